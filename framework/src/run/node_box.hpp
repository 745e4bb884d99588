#pragma once

#include <matpoint/geometry.hpp>
#include <matpoint/grid.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace matpoint {

/// A node's place; coordinates that the space lacks are zero.
template <class S>
Eigen::Vector3d place_of(const Patch<S>& patch, const typename Patch<S>::Coordinates& node) {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    place.head<S::dimension>() = patch.node_position(node);
    return place;
}

/// The nodes of the grid in a box. Of more than a million, evenly chosen ones stand for all.
template <class S>
class NodeBox {
  public:
    using Coordinates = typename Patch<S>::Coordinates;

    NodeBox(const Patch<S>& patch, const Geometry::Bounds& box) {
        double nodes = 1;
        for (int a = 0; a < S::dimension; ++a) {
            const auto i = static_cast<std::size_t>(a);
            const double min = patch.min()[a], h = patch.cell_size()[a];
            const double cells = patch.cells()[i];
            constexpr double rounding = 1e-3;  // in cells; the region itself decides
            first_[i] =
                static_cast<int>(std::clamp(std::ceil((box.min[a] - min) / h - rounding), 0.0, cells + 1));
            last_[i] =
                static_cast<int>(std::clamp(std::floor((box.max[a] - min) / h + rounding), -1.0, cells));
            nodes *= std::max(0, last_[i] - first_[i] + 1);
        }
        stride_ = std::max(1, static_cast<int>(std::ceil(std::pow(nodes / 1e6, 1.0 / S::dimension))));
    }

    /// Only those on a face of the grid.
    void keep_face(const Patch<S>& patch, int axis, int side) {
        const auto i = static_cast<std::size_t>(axis);
        const int face = side == 0 ? 0 : patch.cells()[i];
        if (face < first_[i] || face > last_[i])
            last_[i] = first_[i] - 1;
        else
            first_[i] = last_[i] = face;
    }

    /// Whether some of the nodes are passed over.
    bool thinned() const { return stride_ > 1; }

    /// Whether `holds(node)` is true of a node that is looked at.
    template <class Holds>
    bool any(const Holds& holds) const {
        for (std::size_t a = 0; a < S::dimension; ++a)
            if (first_[a] > last_[a]) return false;
        for (Coordinates node = first_;;) {
            if (holds(node)) return true;
            std::size_t a = 0;
            while (a < S::dimension && last_[a] - node[a] < stride_) {
                node[a] = first_[a];
                ++a;
            }
            if (a == S::dimension) return false;
            node[a] += stride_;
        }
    }

  private:
    Coordinates first_{}, last_{};
    int stride_ = 1;
};

}  // namespace matpoint
