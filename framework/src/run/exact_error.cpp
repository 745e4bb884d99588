#include "run/exact_error.hpp"

#include "run/derived_fields.hpp"

#include <Eigen/LU>

namespace matpoint {

namespace {

template <class Vector>
Eigen::Vector3d spatial(const Vector& v) {
    Eigen::Vector3d full = Eigen::Vector3d::Zero();
    full.head<Vector::RowsAtCompileTime>() = v.template cast<double>();
    return full;
}

template <class Value>
double distance(const Value& found, const Value& exact, bool relative) {
    const double deviation = (found - exact).norm();
    return relative && deviation > 0 ? deviation / exact.norm() : deviation;
}

/// The material point X that is at x at a time: X + u(X) = x, by Newton's method
/// [Wallstedt & Guilkey 2008, eq. A.1].
Eigen::Vector3d reference_point(const ExactSolution& solution, const Eigen::Vector3d& x, double time) {
    Eigen::Vector3d reference = x;
    for (int iteration = 0; iteration < 30; ++iteration) {
        const Eigen::Vector3d miss = reference + solution.displacement(reference, time) - x;
        if (miss.norm() <= 1e-15 * (x.norm() + miss.norm())) break;
        reference -= solution.deformation_gradient(reference, time).inverse() * miss;
    }
    return reference;
}

}  // namespace

template <class S>
bool ExactError<S>::within(const Eigen::Vector3d& x) const {
    return !within_ || guarded(*within_, "contains", [&] { return within_->contains(x); });
}

template <class S>
double ExactError<S>::deviation(const Particles<S>& particles, Index p, double time,
                                double velocity_time) const {
    const Eigen::Vector3d reference = spatial(particles.position(p, Field::initial_position));
    if (quantity_ == "velocity")
        return distance(spatial(particles.velocity(p)), solution_->velocity(reference, velocity_time),
                        relative_);
    if (quantity_ == "stress")
        return distance(full_stress(particles, p), solution_->stress(reference, time), relative_);
    const Eigen::Vector3d displacement = spatial(particles.position(p)) - reference;
    return distance(displacement, solution_->displacement(reference, time), relative_);
}

template <class S>
void ExactError<S>::add_particles(const Particles<S>& particles, double time, double velocity_time,
                                  ErrorSums& sums) const {
    if (!solution_->covers(particles.body())) return;
    for (Index p = 0; p < particles.size(); ++p) {
        if (!within(spatial(particles.position(p, Field::initial_position)))) continue;
        sums.add(
            guarded(*solution_, "functions", [&] { return deviation(particles, p, time, velocity_time); }));
    }
}

template <class S>
void ExactError<S>::add_nodes(const Patch<S>& patch, const std::vector<char>& inside, double time,
                              double velocity_time, ErrorSums& sums) const {
    const auto* mass = patch.column(NodeField::mass);
    for (int i = 0; i < static_cast<int>(patch.node_count()); ++i) {
        if (!(mass[i] > 0) || inside[static_cast<std::size_t>(i)] == 0) continue;
        const Eigen::Vector3d x = spatial(patch.position_at(i));
        if (!within(x)) continue;
        typename S::Vector v;
        for (int c = 0; c < S::dimension; ++c) v[c] = patch.column(NodeField::velocity, c)[i];
        sums.add(guarded(*solution_, "functions", [&] {
            const Eigen::Vector3d reference = reference_point(*solution_, x, time);
            return distance(spatial(v), solution_->velocity(reference, velocity_time), relative_);
        }));
    }
}

#define MATPOINT_INSTANTIATE(S) template class ExactError<S>;
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
