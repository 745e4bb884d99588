#pragma once

namespace matpoint {

/// The centred cardinal B-spline N of a degree, in cells: a node's measure of what is around it.
class Spline {
  public:
    /// 1 (tent) to 3.
    explicit Spline(int degree) : degree_(degree), reach_((degree + 1) / 2.0) {}

    /// N(x) = 0 from there on.
    double reach() const { return reach_; }
    double value(double x) const;
    /// Integral of N, and of xi N(xi), from -infinity to x.
    double mass(double x) const;
    double moment(double x) const;
    /// How far a half-space -infinity < xi < d reaches beyond the node, by the centroid of N in it,
    /// c = moment(d) / mass(d); from -reach (just touched) to reach (all around the node).
    double surface(double centroid) const;

  private:
    double power_sum(double x, int order) const;

    int degree_;
    double reach_;
};

}  // namespace matpoint
