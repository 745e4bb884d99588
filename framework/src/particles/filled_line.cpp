#include "particles/filled_line.hpp"

#include <algorithm>
#include <cmath>

namespace matpoint {

FilledLine::FilledLine(const std::vector<double>& planes, double resolution)
    : planes_(planes), resolution_(resolution), fillings_(planes.size() - 1), whole_(planes.size() - 1) {}

void FilledLine::clear() {
    std::ranges::fill(fillings_, Filling());
    std::ranges::fill(whole_, 0);
    lines_ = 0;
    sections_.clear();
}

void FilledLine::add(const Intervals& intervals, const LineRule::Point& y, const LineRule::Point& z) {
    ++lines_;
    for (auto interval = intervals.begin(); interval != intervals.end();) {
        const double begin = in_places(interval->begin);
        double end = in_places(interval->end);
        while (++interval != intervals.end() && in_places(interval->begin) <= end)
            end = std::max(end, in_places(interval->end));
        if (!(begin < end)) continue;
        sections_.push_back({begin, end, y.local, z.local, y.weight * z.weight});
        const auto first = static_cast<std::size_t>(std::ceil(begin)),
                   last = static_cast<std::size_t>(std::floor(end));
        for (std::size_t i = first; i < last; ++i) ++whole_[i];
    }
}

const std::vector<Filling>& FilledLine::fill() {
    for (const Section& s : sections_) {
        const auto last = static_cast<std::size_t>(std::ceil(s.end));
        for (auto i = static_cast<std::size_t>(s.begin); i < last; ++i) {
            if (is_whole(i)) continue;
            const double middle = static_cast<double>(i) + 0.5;
            const double lo = std::max(s.begin - middle, -0.5), hi = std::min(s.end - middle, 0.5);
            const double volume = s.weight * (hi - lo);
            Filling& filling = fillings_[i];
            filling.volume += volume;
            filling.first += volume * Eigen::Vector3d((hi + lo) / 2, s.y, s.z);
            filling.second +=
                volume * Eigen::Vector3d((hi * hi + hi * lo + lo * lo) / 3, s.y * s.y, s.z * s.z);
        }
    }
    return fillings_;
}

/// A coordinate along the line, in places from its begin.
double FilledLine::in_places(double x) const {
    if (x <= planes_.front() + resolution_) return 0;
    if (x >= planes_.back() - resolution_) return static_cast<double>(fillings_.size());
    const auto above = std::ranges::upper_bound(planes_, x + resolution_);
    const double min = *(above - 1);
    return static_cast<double>(above - 1 - planes_.begin()) + std::max(0.0, (x - min) / (*above - min));
}

}  // namespace matpoint
