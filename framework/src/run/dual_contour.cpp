#include "run/dual_contour.hpp"

#include <matpoint/parallel.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace matpoint {

namespace {

using Place = std::array<int, 3>;

/// Where a surface cuts an edge of the lattice.
struct Cut {
    Eigen::Vector3d place, normal;
};

/// The point nearest to the planes at a cell's cuts, and among those to the middle of the cuts, in the cell.
Eigen::Vector3d vertex(const std::vector<Cut>& cuts, const Eigen::Vector3d& low, double spacing) {
    constexpr double flat = 0.01;  // directions with less than this share of the largest have no say
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(), away = middle;
    for (const Cut& cut : cuts) middle += cut.place / static_cast<double>(cuts.size());
    Eigen::Matrix3d planes = Eigen::Matrix3d::Zero();
    for (const Cut& cut : cuts) {
        planes += cut.normal * cut.normal.transpose();
        away += cut.normal * cut.normal.dot(cut.place - middle);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(planes);
    Eigen::Vector3d best = middle;
    for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d axis = axes.eigenvectors().col(k);
        if (axes.eigenvalues()[k] > flat * axes.eigenvalues()[2])
            best += axis * (axis.dot(away) / axes.eigenvalues()[k]);
    }
    return best.cwiseMax(low).cwiseMin((low.array() + spacing).matrix());
}

class Contour {
  public:
    Contour(const Lattice& lattice, const std::function<SignedDistance(const Eigen::Vector3d&)>& distance)
        : lattice_(lattice), distance_(distance) {
        const Index count = Index(lattice.nodes[0]) * lattice.nodes[1] * lattice.nodes[2];
        values_.resize(static_cast<std::size_t>(count));
        const Index row = lattice.nodes[0];
        parallel_for(count / row, count, [&](Index r) {
            for (Index i = r * row; i < (r + 1) * row; ++i)
                values_[static_cast<std::size_t>(i)] = distance_(position(place_of(i))).distance;
        });
    }

    SurfaceMesh mesh() {
        mesh_.corners = 1 << (lattice_.dimension - 1);
        for (Index i = 0; i < static_cast<Index>(values_.size()); ++i) {
            const Place node = place_of(i);
            for (int axis = 0; axis < lattice_.dimension; ++axis)
                if (is_cut(node, axis)) add_face(node, axis);
        }
        return std::move(mesh_);
    }

  private:
    static std::size_t at(int axis) { return static_cast<std::size_t>(axis); }
    Place place_of(Index i) const {
        const int x = lattice_.nodes[0], y = lattice_.nodes[1];
        return {static_cast<int>(i % x), static_cast<int>(i / x % y), static_cast<int>(i / x / y)};
    }
    Eigen::Vector3d position(const Place& node) const {
        return lattice_.min + lattice_.spacing * Eigen::Vector3d(node[0], node[1], node[2]);
    }
    double value(const Place& n) const {
        return values_[static_cast<std::size_t>((n[2] * Index(lattice_.nodes[1]) + n[1]) * lattice_.nodes[0] +
                                                n[0])];
    }
    bool is_cut(Place node, int axis) const {
        if (node[at(axis)] + 1 >= lattice_.nodes[at(axis)]) return false;
        const bool within = value(node) < 0;
        ++node[at(axis)];
        return within != (value(node) < 0);
    }

    /// The face between the cells around an edge, unless some are beyond the lattice; the tool is on its left
    /// in 2D, behind it in 3D.
    void add_face(const Place& node, int axis) {
        const int u = (axis + 1) % lattice_.dimension, v = (axis + 2) % lattice_.dimension;
        std::vector<Place> cells{node};
        const auto beside = [](Place cell, int along) {
            --cell[static_cast<std::size_t>(along)];
            return cell;
        };
        if (lattice_.dimension == 2) cells = {node, beside(node, u)};
        if (lattice_.dimension == 3)
            cells = {node, beside(node, u), beside(beside(node, u), v), beside(node, v)};
        for (const Place& cell : cells)
            for (int a = 0; a < lattice_.dimension; ++a)
                if (cell[at(a)] < 0 || cell[at(a)] + 1 >= lattice_.nodes[at(a)]) return;
        if ((value(node) < 0) == (lattice_.dimension == 2 && axis == 0))
            std::reverse(cells.begin(), cells.end());
        for (const Place& cell : cells) mesh_.cells.push_back(point_in(cell));
    }

    /// Number of the point in a cell.
    std::int64_t point_in(const Place& cell) {
        const auto [found, is_new] = point_of_.try_emplace(cell, mesh_.points.size() / 3);
        if (is_new) {
            const Eigen::Vector3d point = vertex(cuts_of(cell), position(cell), lattice_.spacing);
            mesh_.points.insert(mesh_.points.end(), point.begin(), point.end());
        }
        return found->second;
    }

    std::vector<Cut> cuts_of(const Place& cell) const {
        std::vector<Cut> cuts;
        for (int corner = 0; corner < 1 << lattice_.dimension; ++corner)
            for (int axis = 0; axis < lattice_.dimension; ++axis) {
                if ((corner >> axis & 1) != 0) continue;
                Place node = cell;
                for (int a = 0; a < lattice_.dimension; ++a) node[at(a)] += corner >> a & 1;
                if (is_cut(node, axis)) cuts.push_back(cut(node, axis));
            }
        return cuts;
    }

    /// By regula falsi: beside edges and corners distances aren't linear.
    Cut cut(const Place& node, int axis) const {
        constexpr int most_steps = 60;
        constexpr double close = 1e-10;  // of the spacing
        Place end = node;
        ++end[at(axis)];
        const Eigen::Vector3d origin = position(node);
        double low = 0, high = 1, from = value(node), to = value(end);
        for (int step = 1;; ++step) {
            const double share = low + (high - low) * from / (from - to);
            const Eigen::Vector3d place = origin + share * lattice_.spacing * Eigen::Vector3d::Unit(axis);
            const SignedDistance found = distance_(place);
            if (step == most_steps || std::abs(found.distance) < close * lattice_.spacing)
                return {place, found.normal};
            if ((found.distance < 0) == (from < 0))
                low = share, from = found.distance, to /= 2;
            else
                high = share, to = found.distance, from /= 2;
        }
    }

    const Lattice& lattice_;
    const std::function<SignedDistance(const Eigen::Vector3d&)>& distance_;
    std::vector<double> values_;  ///< distances of the nodes, m
    std::map<Place, std::int64_t> point_of_;
    SurfaceMesh mesh_;
};

}  // namespace

SurfaceMesh dual_contour(const Lattice& lattice,
                         const std::function<SignedDistance(const Eigen::Vector3d&)>& distance) {
    return Contour(lattice, distance).mesh();
}

}  // namespace matpoint
