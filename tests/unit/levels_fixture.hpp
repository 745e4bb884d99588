#pragma once

#include "grid/levels.hpp"

#include <gtest/gtest.h>
#include <matpoint/geometry.hpp>

#include <map>
#include <random>
#include <vector>

namespace matpoint {

/// What is in one of some boxes.
class Boxes final : public Geometry {
  public:
    explicit Boxes(std::vector<Bounds> boxes) : boxes_(std::move(boxes)) {}

    Bounds bounds() const override {
        Bounds all = boxes_.front();
        for (const Bounds& box : boxes_) all = {all.min.cwiseMin(box.min), all.max.cwiseMax(box.max)};
        return all;
    }
    using Geometry::contains;
    bool contains(const Eigen::Vector3d& x) const override {
        for (const Bounds& box : boxes_)
            if ((x.array() >= box.min.array()).all() && (x.array() <= box.max.array()).all()) return true;
        return false;
    }

  private:
    std::vector<Bounds> boxes_;
};

/// Coefficients of the refinement of splines, by their degree.
inline const std::map<int, std::vector<double>> refinements = {
    {1, {0.5, 1, 0.5}}, {2, {0.25, 0.75, 0.75, 0.25}}, {3, {0.125, 0.5, 0.75, 0.5, 0.125}}};

/// Three levels on [0, 4]^2 with cells of 1/8; the finer regions are L-shaped.
class ThreeLevels : public testing::TestWithParam<int> {
  protected:
    using S = PlaneStrain;
    using Position = S::Position;
    using Coordinates = Patch<S>::Coordinates;

    int degree() const { return GetParam(); }
    /// The spline of this degree about 0, in cells.
    double spline(double x) const {
        x = std::abs(x);
        if (degree() == 1) return std::max(0.0, 1 - x);
        if (degree() == 2) return x < 0.5 ? 0.75 - x * x : x < 1.5 ? (1.5 - x) * (1.5 - x) / 2 : 0;
        if (x < 1) return 2.0 / 3 - x * x * (1 - x / 2);
        return x < 2 ? (2 - x) * (2 - x) * (2 - x) / 6 : 0;
    }
    /// What each node that moves by itself has of a place, evaluated on a level.
    std::map<std::pair<int, Coordinates>, double> weights(int level, const Position& x) const {
        std::map<std::pair<int, Coordinates>, double> all;
        const Patch<S>& own = levels.patch(level);
        Coordinates base;
        for (std::size_t a = 0; a < 2; ++a)
            base[a] = static_cast<int>(
                          std::floor((x[static_cast<int>(a)] - own.min()[0]) * own.inverse_cell_size()[0])) -
                      2;
        for (int k = 0; k < 36; ++k) {
            const Coordinates node{base[0] + k % 6, base[1] + k / 6};
            const Position apart = (x - own.node_position(node)).cwiseProduct(own.inverse_cell_size());
            add(all, level, node, spline(apart[0]) * spline(apart[1]));
        }
        return all;
    }
    void add(std::map<std::pair<int, Coordinates>, double>& all, int level, const Coordinates& node,
             double weight) const {
        if (weight == 0) return;
        if (levels.free(level, node)) {
            all[{level, node}] += weight;
            return;
        }
        EXPECT_TRUE(levels.reached(level, node));
        for (const auto& parent : levels.parents(level, node))
            add(all, level - 1, parent.node, weight * parent.weight);
    }

    Boxes first{{{{1, 1, 0}, {2.5, 1.75, 0}}, {{1, 1, 0}, {1.75, 3, 0}}}},
        second{{{{1.25, 1.25, 0}, {1.5, 1.375, 0}}, {{1.25, 1.25, 0}, {1.375, 1.75, 0}}}};
    Patch<S> patch{{0, 0, 0}, {0.125, 0.125, 0.125}, {32, 32}};
    Levels<S> levels{patch, {&first, &second}, refinements.at(degree())};
    std::mt19937 numbers{1};
    std::uniform_real_distribution<double> along{0.6, 3.4};
};

}  // namespace matpoint
