namespace acme {
double melting_point();
double melting_point() {
    return 1;
}
}  // namespace acme
