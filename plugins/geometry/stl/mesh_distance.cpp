#include "mesh_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace matpoint {

namespace {

constexpr std::uint32_t leaf_size = 4;

/// Normals of triangles that point out of the mesh, whichever way they are turned in the file: told by points
/// on both sides. Zero for those without an area.
std::vector<Eigen::Vector3d> outward_normals(const TriangleMesh& mesh) {
    constexpr double beside = 1e-5;  // in lengths of the longest edge
    std::vector<Eigen::Vector3d> normals, sides;
    for (const auto& [a, b, c] : mesh.triangles()) {
        const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
        const Eigen::Vector3d across = (b - a).cross(c - a);
        const bool flat = !(across.norm() > 1e-12 * longest * longest);
        normals.push_back(flat ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : across.normalized());
        for (const double side : {-1, 1})
            sides.push_back((a + b + c) / 3 + side * beside * longest * normals.back());
    }
    const auto verdicts = mesh.classify(sides);
    for (std::size_t t = 0; t < normals.size(); ++t)
        if (verdicts[2 * t] != TriangleMesh::Verdict::inside &&
            verdicts[2 * t + 1] == TriangleMesh::Verdict::inside)
            normals[t] = -normals[t];
    return normals;
}

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The point of a triangle that is nearest to another one [Ericson 2005, Real-Time Collision
/// Detection, 5.1.5], and what of the triangle it is: `corner` or `edge`, or none of them.
struct Nearest {
    Eigen::Vector3d point;
    int corner = -1, edge = -1;
};
Nearest nearest_of(const TriangleMesh::Triangle& triangle, const Eigen::Vector3d& point) {
    const auto& [a, b, c] = triangle;
    const Eigen::Vector3d ab = b - a, ac = c - a, ap = point - a, bp = point - b, cp = point - c;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp),
                 d6 = ac.dot(cp);
    if (d1 <= 0 && d2 <= 0) return {a, 0};
    if (d3 >= 0 && d4 <= d3) return {b, 1};
    if (d6 >= 0 && d5 <= d6) return {c, 2};
    const double in_ab = d1 * d4 - d3 * d2, in_bc = d3 * d6 - d5 * d4, in_ca = d5 * d2 - d1 * d6;
    if (in_ab <= 0 && d1 >= 0 && d3 <= 0) return {a + d1 / (d1 - d3) * ab, -1, 0};
    if (in_ca <= 0 && d2 >= 0 && d6 <= 0) return {a + d2 / (d2 - d6) * ac, -1, 2};
    if (in_bc <= 0 && d4 >= d3 && d5 >= d6) return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), -1, 1};
    const double all = in_bc + in_ca + in_ab;
    return {a + in_ca / all * ab + in_ab / all * ac};
}

}  // namespace

MeshDistance::MeshDistance(const TriangleMesh& mesh) {
    const std::vector<Eigen::Vector3d> normals = outward_normals(mesh);
    std::array<Eigen::Vector3d, 3> none;
    none.fill(Eigen::Vector3d::Zero());
    std::vector<std::size_t> sources;
    for (std::size_t t = 0; t < normals.size(); ++t) {
        if (normals[t].isZero(0)) continue;
        faces_.push_back({mesh.triangles()[t], normals[t], none, none});
        sources.push_back(t);
    }
    set_pseudonormals(mesh, sources);
    grow(0, static_cast<std::uint32_t>(faces_.size()));
}

/// `sources`: of each face, its number in the mesh.
void MeshDistance::set_pseudonormals(const TriangleMesh& mesh, const std::vector<std::size_t>& sources) {
    const auto numbers = mesh.corner_numbers();
    std::map<std::pair<std::size_t, std::size_t>, Eigen::Vector3d> at_edges;
    std::map<std::size_t, Eigen::Vector3d> at_corners;
    const auto edge = [](const std::array<std::size_t, 3>& corners, std::size_t i) {
        return std::minmax(corners[i], corners[(i + 1) % 3]);
    };
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        const auto& [a, b, c] = faces_[f].corners;
        const std::array<double, 3> angles{angle_between(b - a, c - a), angle_between(c - b, a - b),
                                           angle_between(a - c, b - c)};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& corners = numbers[sources[f]];
            at_edges.try_emplace(edge(corners, i), Eigen::Vector3d::Zero()).first->second += faces_[f].normal;
            at_corners.try_emplace(corners[i], Eigen::Vector3d::Zero()).first->second +=
                angles[i] * faces_[f].normal;
        }
    }
    for (std::size_t f = 0; f < faces_.size(); ++f)
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& corners = numbers[sources[f]];
            faces_[f].at_edge[i] = at_edges.at(edge(corners, i));
            faces_[f].at_corner[i] = at_corners.at(corners[i]);
        }
}

/// Makes the branch of faces [begin, end), and those that grow from it; returns its number.
std::uint32_t MeshDistance::grow(std::uint32_t begin, std::uint32_t end) {
    const auto number = static_cast<std::uint32_t>(tree_.size());
    Branch branch{{}, begin, end, 0};
    Eigen::AlignedBox3d middles;
    const auto middle = [](const Face& face) -> Eigen::Vector3d {
        return face.corners[0] + face.corners[1] + face.corners[2];
    };
    for (std::uint32_t f = begin; f < end; ++f) {
        for (const Eigen::Vector3d& corner : faces_[f].corners) branch.box.extend(corner);
        middles.extend(middle(faces_[f]));
    }
    tree_.push_back(branch);
    if (end - begin <= leaf_size) return number;
    Eigen::Index axis = 0;
    middles.sizes().maxCoeff(&axis);
    const std::uint32_t half = begin + (end - begin) / 2;
    std::nth_element(
        faces_.begin() + begin, faces_.begin() + half, faces_.begin() + end,
        [&](const Face& one, const Face& other) { return middle(one)[axis] < middle(other)[axis]; });
    grow(begin, half);
    const std::uint32_t second = grow(half, end);
    tree_[number].second = second;
    return number;
}

SignedDistance MeshDistance::operator()(const Eigen::Vector3d& point) const {
    double least = std::numeric_limits<double>::infinity();
    const Face* nearest_face = nullptr;
    Nearest nearest{Eigen::Vector3d::Zero()};
    std::array<std::uint32_t, 64> waiting;  // as deep as the tree: it halves the number of faces
    std::size_t count = 0;
    waiting[count++] = 0;
    while (count > 0) {
        const std::uint32_t number = waiting[--count];
        const Branch& branch = tree_[number];
        if (branch.box.squaredExteriorDistance(point) >= least) continue;
        if (branch.second == 0) {
            for (std::uint32_t f = branch.begin; f < branch.end; ++f) {
                const Nearest found = nearest_of(faces_[f].corners, point);
                const double square = (point - found.point).squaredNorm();
                if (square >= least) continue;
                least = square;
                nearest_face = &faces_[f];
                nearest = found;
            }
            continue;
        }
        std::uint32_t near = number + 1, far = branch.second;
        if (tree_[far].box.squaredExteriorDistance(point) < tree_[near].box.squaredExteriorDistance(point))
            std::swap(near, far);
        waiting[count++] = far;
        waiting[count++] = near;
    }
    const Eigen::Vector3d away = point - nearest.point;
    if (nearest.corner < 0 && nearest.edge < 0) return {nearest_face->normal.dot(away), nearest_face->normal};
    const Eigen::Vector3d& side = nearest.corner >= 0
                                      ? nearest_face->at_corner[static_cast<std::size_t>(nearest.corner)]
                                      : nearest_face->at_edge[static_cast<std::size_t>(nearest.edge)];
    const double distance = std::copysign(away.norm(), side.dot(away));
    return {distance, distance != 0 ? Eigen::Vector3d(away / distance) : side.normalized()};
}

}  // namespace matpoint
