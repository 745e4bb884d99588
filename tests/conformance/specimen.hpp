#pragma once

#include <matpoint/material.hpp>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace matpoint::conformance {

/// Particles of a material that are strained by hand, as the kernel would. They carry what the
/// material asked for and nothing else. A step lasts one second.
template <class S>
class Specimen {
  public:
    using Real = typename S::Real;

    explicit Specimen(const Material<S>& material, Index count = 1)
        : material_(&material), particles_("specimen"), states_(material.state()) {
        if (material.uses_deformation_gradient()) particles_.require(Field::displacement_gradient);
        for (std::size_t k = 0; k < states_.size(); ++k) {
            const int slot = particles_.require(states_[k].name, 1, states_[k].initial);
            if (k == 0) first_state_ = slot;
        }
        particles_.resize(count);
        std::fill_n(particles_.column(Field::mass), count, static_cast<Real>(material.density()));
        std::fill_n(particles_.column(Field::volume), count, Real(1));
        displacement_gradients_.resize(static_cast<std::size_t>(count));
    }

    Particles<S>& particles() { return particles_; }
    Tensor<S> deformation(Index p = 0) const {
        return Tensor<S>::identity() + displacement_gradients_[static_cast<std::size_t>(p)];
    }
    Real density(Index p = 0) const {
        return particles_.column(Field::mass)[p] / particles_.column(Field::volume)[p];
    }
    Tensor<S> stress(Index p = 0) const { return ParticleBatch<S>::load_stress(particles_, p); }
    Real state(int k, Index p = 0) const { return particles_.column(first_state_ + k, 0)[p]; }

    /// All particles: F = (I + gradient) F.
    void step(const Tensor<S>& gradient) {
        step(std::vector<Tensor<S>>(static_cast<std::size_t>(particles_.size()), gradient), batch_size);
    }
    /// One for every particle, in batches of `extent`.
    void step(const std::vector<Tensor<S>>& gradients, Index extent) {
        for (Index p = 0; p < particles_.size(); ++p) {
            const Tensor<S>& gradient = gradients[static_cast<std::size_t>(p)];
            Tensor<S>& h = displacement_gradients_[static_cast<std::size_t>(p)];
            h = h + (gradient + gradient * h);
            particles_.column(Field::volume)[p] = 1 + volume_change(h);
            if (particles_.has(Field::displacement_gradient))
                ParticleBatch<S>::store_displacement_gradient(particles_, p, h);
        }
        for_each_batch(extent, [&](Index begin, Index end) {
            for (Index p = begin; p < end; ++p)
                store_gradient(gradients[static_cast<std::size_t>(p)], p - begin);
            material_->update_stress({particles_, begin, end, gathered_, first_state_}, Real(1));
        });
    }

    Real wave_speed(Index extent = batch_size) {
        Real fastest = -std::numeric_limits<Real>::infinity();
        for_each_batch(extent, [&](Index begin, Index end) {
            const Real speed = material_->wave_speed({particles_, begin, end, gathered_, first_state_});
            if (!(speed <= fastest)) fastest = speed;  // what is not a number stays
        });
        return fastest;
    }
    std::optional<double> stored_energy(Index p = 0) {
        return material_->stored_energy({particles_, p, p + 1, gathered_, first_state_}, p);
    }

  private:
    template <class Function>
    void for_each_batch(Index extent, Function function) {
        for (Index begin = 0; begin < particles_.size(); begin += extent)
            function(begin, std::min(particles_.size(), begin + extent));
    }
    void store_gradient(const Tensor<S>& gradient, Index k) {
        const auto place = static_cast<std::size_t>(k);
        for (int c = 0; c < S::dimension * S::dimension; ++c)
            gathered_.velocity_gradient[static_cast<std::size_t>(c)][place] = gradient.plane.data()[c];
        if constexpr (S::axisymmetric) gathered_.velocity_gradient.back()[place] = gradient.normal;
    }

    const Material<S>* material_;
    Particles<S> particles_;
    std::vector<StateVariable> states_;
    std::vector<Tensor<S>> displacement_gradients_;
    Gathered<S> gathered_{};
    int first_state_ = 0;
};

/// Components between -1 and 1; none normal to the plane in plane strain.
template <class S>
Tensor<S> random_tensor(std::mt19937& random) {
    std::uniform_real_distribution<double> component(-1, 1);
    Tensor<S> t;
    for (int c = 0; c < S::dimension * S::dimension; ++c)
        t.plane.data()[c] = static_cast<typename S::Real>(component(random));
    if constexpr (S::axisymmetric) t.normal = static_cast<typename S::Real>(component(random));
    return t;
}

template <class S>
typename S::Vector random_direction(std::mt19937& random) {
    std::normal_distribution<double> component;
    typename S::Vector n;
    for (int a = 0; a < S::dimension; ++a) n[a] = static_cast<typename S::Real>(component(random));
    return n.normalized();
}

/// Rotation in the plane, or about an oblique axis in 3D.
template <class S>
Tensor<S> rotation(double angle) {
    Tensor<S> r = Tensor<S>::identity();
    if constexpr (S::dimension == 2)
        r.plane = Eigen::Rotation2Dd(angle).toRotationMatrix().cast<typename S::Real>();
    if constexpr (S::dimension == 3)
        r.plane = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized())
                      .toRotationMatrix()
                      .cast<typename S::Real>();
    return r;
}
/// Gradient of a step that is this rotation and nothing else.
template <class S>
Tensor<S> turn(double angle) {
    return rotation<S>(angle) - Tensor<S>::identity();
}

/// Gradient of a step of one second that adds the logarithmic strain `strain`, which is symmetric, and does
/// not turn: exp(strain) - I.
template <class S>
Tensor<S> straining(const Tensor<S>& strain) {
    const Eigen::SelfAdjointEigenSolver<typename S::Matrix> principal(strain.plane);
    Tensor<S> gradient;
    gradient.plane = principal.eigenvectors() *
                     principal.eigenvalues().array().expm1().matrix().asDiagonal() *
                     principal.eigenvectors().transpose();
    if constexpr (S::has_normal) gradient.normal = std::expm1(strain.normal);
    return gradient;
}

}  // namespace matpoint::conformance
