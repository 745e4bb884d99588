#pragma once

namespace matpoint {

/// Folds what one axis' stencil has past an open face (no wall) onto the two nodes at that face, for
/// weights and derivatives alike: a ghost's value continues the line through its neighbours,
/// f(-1) = 2 f(0) - f(1), so w(0) += 2 w(-1) and w(1) -= w(-1). B-splines become those with a knot
/// repeated at the edge: they stay non-negative, sum to one and reproduce linear functions up to it.
/// `base`: first node of the stencil, from -1; the last is at most cells + 1.
template <class Real>
void fold_open_edge(int base, int width, int cells, Real* weights) {
    const auto fold = [&](int ghost, int inward) {
        Real& weight = weights[ghost - base];
        if (weight == Real(0)) return;
        weights[ghost + inward - base] += Real(2) * weight;
        weights[ghost + 2 * inward - base] -= weight;
        weight = Real(0);
    };
    if (base < 0) fold(-1, 1);
    if (base + width - 1 > cells) fold(cells + 1, -1);
}

}  // namespace matpoint
