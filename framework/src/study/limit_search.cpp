#include "study/limit_search.hpp"

#include <matpoint/output_file.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace matpoint {

LimitSearch::LimitSearch(double from, double to, int digits, bool largest)
    : good_end_(largest ? from : to), bad_end_(largest ? to : from), digits_(digits) {}

/// Between the two, with the digits asked for: the geometric mean while they are far apart.
double LimitSearch::middle() const {
    const auto [low, high] = std::minmax(*stable_, *unstable_);
    const double middle = low > 0 && high > 2 * low ? std::sqrt(low * high) : std::midpoint(low, high);
    return std::stod(number_text(middle, digits_));
}

std::optional<double> LimitSearch::next() const {
    if (!stable_) return unstable_ ? std::nullopt : std::optional(good_end_);  // unstable everywhere
    if (*stable_ == bad_end_) return {};                                       // stable everywhere
    if (!unstable_) return bad_end_;
    const double next = middle();
    const auto [low, high] = std::minmax(*stable_, *unstable_);
    if (next <= low || next >= high) return {};
    return next;
}

void LimitSearch::answer(bool stable) {
    const std::optional<double> tried = next();
    (stable ? stable_ : unstable_) = tried;
}

}  // namespace matpoint
