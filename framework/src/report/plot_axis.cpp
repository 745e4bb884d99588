#include "report/plot_axis.hpp"

#include "report/markup.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace matpoint {

PlotAxis::PlotAxis(bool logarithmic, const std::vector<double>& values, double first, double last)
    : logarithmic_(logarithmic),
      first_(first),
      last_(last),
      low_(std::numeric_limits<double>::infinity()),
      high_(-low_) {
    for (const double value : values) {
        if (!shows(value)) continue;
        low_ = std::min(low_, coordinate(value));
        high_ = std::max(high_, coordinate(value));
    }
    empty_ = low_ > high_;
    if (empty_) {
        low_ = 0;
        high_ = 1;
        return;
    }
    // One value, or equal ones, lie in the middle of a range.
    const double middle = low_ + (high_ - low_) / 2;
    double least = 0.4;  // decades
    if (!logarithmic_) least = high_ > low_ ? 0 : middle != 0 ? 0.2 * std::abs(middle) : 1;
    low_ = std::min(low_, middle - least / 2);
    high_ = std::max(high_, middle + least / 2);

    const double margin = 0.05 * (high_ - low_);
    const bool from_zero = !logarithmic_ && low_ >= 0 && low_ < 0.35 * high_;
    low_ = from_zero ? 0 : low_ - margin;
    high_ += margin;
}

bool PlotAxis::shows(double value) const {
    return std::isfinite(value) && (!logarithmic_ || value > 0);
}

double PlotAxis::coordinate(double value) const {
    return logarithmic_ ? std::log10(value) : value;
}

double PlotAxis::at(double coordinate) const {
    return first_ + (coordinate - low_) / (high_ - low_) * (last_ - first_);
}

std::vector<PlotAxis::Tick> PlotAxis::ticks() const {
    if (empty_) return {};
    if (!logarithmic_) return even_steps();
    return high_ - low_ < 2 ? parts_of_decades() : decades();
}

std::vector<PlotAxis::Tick> PlotAxis::decades() const {
    const int lowest = static_cast<int>(std::floor(low_));
    const int highest = static_cast<int>(std::floor(high_));
    const int step = 1 + (highest - lowest) / 9;
    std::vector<Tick> ticks;
    for (int decade = lowest; decade <= highest; ++decade) {
        const bool labelled = decade % step == 0;
        if (decade >= low_ && (labelled || step <= 5)) {
            ticks.push_back({at(decade), labelled ? power_markup(decade) : ""});
        }
        for (int digit = 2; digit <= 9 && step == 1; ++digit) {
            const double place = decade + std::log10(digit);
            if (place >= low_ && place <= high_) ticks.push_back({at(place), ""});
        }
    }
    return ticks;
}

std::vector<PlotAxis::Tick> PlotAxis::parts_of_decades() const {
    struct Part {
        double mantissa;
        bool labelled_always;
    };
    static constexpr std::array<Part, 12> parts{{{1, true},
                                                 {1.2, false},
                                                 {1.5, false},
                                                 {2, true},
                                                 {2.5, false},
                                                 {3, false},
                                                 {4, false},
                                                 {5, true},
                                                 {6, false},
                                                 {7, false},
                                                 {8, false},
                                                 {9, false}}};
    const bool narrow = high_ - low_ < 0.7;
    std::vector<Tick> ticks;
    for (int decade = static_cast<int>(std::floor(low_)); decade <= high_; ++decade) {
        for (const auto& [mantissa, labelled_always] : parts) {
            const double place = decade + std::log10(mantissa);
            if (place < low_ || place > high_) continue;
            const bool whole = mantissa == std::floor(mantissa);
            if (narrow || labelled_always) {
                ticks.push_back({at(place), number_markup(mantissa * std::pow(10.0, decade), 4)});
            } else if (whole) {
                ticks.push_back({at(place), ""});
            }
        }
    }
    return ticks;
}

std::vector<PlotAxis::Tick> PlotAxis::even_steps() const {
    const double wanted = (high_ - low_) / 7;
    const double power = std::pow(10.0, std::floor(std::log10(wanted)));
    double step = 10 * power;
    for (const double factor : {5, 2, 1}) {
        if (factor * power >= wanted) step = factor * power;
    }
    const double largest = std::max(std::abs(low_), std::abs(high_));
    const int digits = std::clamp(static_cast<int>(std::ceil(std::log10(largest / step))) + 1, 5, 15);
    std::vector<Tick> ticks;
    for (double count = std::ceil(low_ / step); count * step <= high_; ++count) {
        const double value = count * step + 0.0;  // never -0
        ticks.push_back({at(value), number_markup(value, digits)});
    }
    return ticks;
}

}  // namespace matpoint
