#include "run/first_state.hpp"

#include <matpoint/material.hpp>

#include <Eigen/LU>

namespace matpoint {

template <class S>
void set_initial_gradient(Particles<S>& particles, Field field,
                          const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& velocity,
                          double cell_size) {
    const double reach = 1e-3 * cell_size;
    for (Index p = 0; p < particles.size(); ++p) {
        Eigen::Vector3d x = Eigen::Vector3d::Zero();
        x.head<S::dimension>() = particles.position(p);
        for (int a = 0; a < S::dimension; ++a) {
            const Eigen::Vector3d step = reach * Eigen::Vector3d::Unit(a);
            const Eigen::Vector3d slope = (velocity(x + step) - velocity(x - step)) / (2 * reach);
            for (int c = 0; c < S::dimension; ++c)
                particles.column(field, c + S::dimension * a)[p] = static_cast<typename S::Real>(slope[c]);
        }
    }
}

template <class S>
void start_exactly(const ExactSolution& solution, Particles<S>& particles) {
    using Real = typename S::Real;
    const auto tensor = [](const Eigen::Matrix3d& full) {
        Tensor<S> t;
        t.plane = full.topLeftCorner<S::dimension, S::dimension>().template cast<Real>();
        if constexpr (S::has_normal) t.normal = static_cast<Real>(full(2, 2));
        return t;
    };
    for (Index p = 0; p < particles.size(); ++p) {
        Eigen::Vector3d reference = Eigen::Vector3d::Zero();
        reference.head<S::dimension>() = particles.position(p);
        const Eigen::Vector3d u = solution.displacement(reference, 0), v = solution.velocity(reference, 0);
        const Eigen::Matrix3d f = solution.deformation_gradient(reference, 0);
        for (int a = 0; a < S::dimension; ++a) {
            particles.set_value(Field::position, a, p, reference[a] + u[a]);
            particles.column(Field::velocity, a)[p] = static_cast<Real>(v[a]);
        }
        particles.set_value(Field::volume, 0, p, particles.value(Field::volume, 0, p) * f.determinant());
        ParticleBatch<S>::store_stress(particles, p, tensor(solution.stress(reference, 0)));
        if (particles.has(Field::displacement_gradient))
            ParticleBatch<S>::store_displacement_gradient(particles, p,
                                                          tensor(f - Eigen::Matrix3d::Identity()));
    }
}

template <class S>
void set_exact_gradient(const ExactSolution& solution, Particles<S>& particles, Field field, double reach) {
    for (Index p = 0; p < particles.size(); ++p) {
        Eigen::Vector3d x = Eigen::Vector3d::Zero();
        x.head<S::dimension>() = particles.position(p, Field::initial_position);
        Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
        for (int a = 0; a < S::dimension; ++a) {
            const Eigen::Vector3d step = reach * Eigen::Vector3d::Unit(a);
            slope.col(a) = (solution.velocity(x + step, 0) - solution.velocity(x - step, 0)) / (2 * reach);
        }
        const Eigen::Matrix3d gradient = slope * solution.deformation_gradient(x, 0).inverse();
        for (int a = 0; a < S::dimension; ++a)
            for (int c = 0; c < S::dimension; ++c)
                particles.column(field, c + S::dimension * a)[p] =
                    static_cast<typename S::Real>(gradient(c, a));
    }
}

#define MATPOINT_INSTANTIATE(S)                                                                       \
    template void set_initial_gradient(                                                               \
        Particles<S>&, Field, const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>&, double); \
    template void start_exactly(const ExactSolution&, Particles<S>&);                                 \
    template void set_exact_gradient(const ExactSolution&, Particles<S>&, Field, double);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
