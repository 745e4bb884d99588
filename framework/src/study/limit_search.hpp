#pragma once

#include <optional>

namespace matpoint {

/// Bisection for the value at which something stops being stable, among the numbers with so many significant
/// digits. It takes for granted that there is one such value in the range.
class LimitSearch {
  public:
    /// `largest`: stable below the limit, and the largest stable value is looked for; else stable above it.
    LimitSearch(double from, double to, int digits, bool largest);

    /// The value to try next; nothing when the answer is known.
    std::optional<double> next() const;
    /// Whether the value that next() gave is stable.
    void answer(bool stable);

    /// The last stable value, once one was found.
    std::optional<double> stable() const { return stable_; }
    /// The unstable value next to it, once one was found.
    std::optional<double> unstable() const { return unstable_; }

  private:
    double middle() const;

    double good_end_, bad_end_;
    int digits_;
    std::optional<double> stable_, unstable_;
};

}  // namespace matpoint
