#pragma once

#include <matpoint/shape_function.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace matpoint::conformance {

/// A grid with cells of different lengths along the axes, all of whose blocks exist.
template <class S>
Patch<S> make_patch() {
    constexpr std::array<int, 3> cells{7, 6, 5};
    typename Patch<S>::Coordinates own{};
    std::copy_n(cells.begin(), S::dimension, own.begin());
    Patch<S> patch({0, -0.2, 0.1}, {0.1, 0.25, 0.16}, own);  // x is a radius when axisymmetric
    for (int field = 0; field < node_fields; ++field) patch.require(static_cast<NodeField>(field));
    int blocks = 1;
    for (const int n : patch.blocks()) blocks *= n;
    std::vector<int> numbers(static_cast<std::size_t>(blocks));
    std::iota(numbers.begin(), numbers.end(), 0);
    patch.set_blocks(numbers);
    return patch;
}

/// Particles at random places all over a grid, a third of them in one cell, with random masses,
/// volumes, velocities, stresses and domains; domains have half-lengths of 10 to 45 % of a cell, of
/// their own along each axis. Deformations, if the shape asks for them, stretch them by 0.7 to `stretch`.
template <class S>
class ParticleCloud {
  public:
    using Real = typename S::Real;
    using Vector = typename S::Vector;
    static constexpr int d = S::dimension;

    ParticleCloud(const Patch<S>& patch, const ShapeFunction<S>& shape, Index count, double stretch = 1.1)
        : particles("cloud"), patch_(patch) {
        shape.declare(particles);
        particles.require(Field::velocity_gradient);
        particles.require(Field::grid_velocity);
        particles.resize(count);
        for (Index p = 0; p < count; ++p) place(p, p < count / 3);
        for (const Field field : {Field::mass, Field::volume}) fill(field, 1, 0.5, 2);
        fill(Field::velocity, d, -1, 1);
        fill(Field::grid_velocity, d, -1, 1);
        fill(Field::stress, S::stress_size, -1, 1);
        fill(Field::velocity_gradient, d * d, -1, 1);
        for (int a = 0; a < d; ++a) {
            const double h = patch.cell_size()[a];
            if (particles.has(Field::initial_half_size))
                fill_column(Field::initial_half_size, a, 0.1 * h, 0.45 * h);
            if (particles.has(Field::half_size))
                fill_column(Field::half_size, a, 0.1 * h, 0.45 * h * stretch);
            if (particles.has(Field::displacement_gradient))
                fill_column(Field::displacement_gradient, a * (d + 1), -0.3, stretch - 1);
        }
    }

    Vector half_size(Index p) const {
        return particles.has(Field::half_size) ? particles.vector(Field::half_size, p)
                                               : Vector(Vector::Zero());
    }
    /// From a particle to a node, m.
    Vector arm(const typename Patch<S>::Coordinates& node, Index p) const {
        return (patch_.node_position(node) - particles.position(p)).template cast<Real>();
    }

    Particles<S> particles;

  private:
    Real random(double low, double high) {
        return static_cast<Real>(std::uniform_real_distribution<double>(low, high)(engine_));
    }
    void place(Index p, bool crowded) {
        for (int a = 0; a < d; ++a) {
            const double cells = patch_.cells()[static_cast<std::size_t>(a)];
            const double xi = crowded ? random(2.55, 3.45) : random(1e-3, cells - 1e-3);
            particles.set_value(Field::position, a, p, patch_.min()[a] + xi * patch_.cell_size()[a]);
        }
    }
    void fill_column(Field field, int component, double low, double high) {
        std::generate_n(particles.column(field, component), particles.size(),
                        [&] { return random(low, high); });
    }
    void fill(Field field, int components, double low, double high) {
        for (int c = 0; c < components; ++c) fill_column(field, c, low, high);
    }

    const Patch<S>& patch_;
    std::mt19937 engine_{7};
};

/// A velocity field of the nodes (ghosts included), f(position).
template <class S, class Function>
void set_nodes(Patch<S>& patch, NodeField field, const Function& f) {
    for (int i = 0; i < static_cast<int>(patch.node_count()); ++i) {
        const auto x = patch.node_position(patch.node_coordinates(i));
        const typename S::Vector value = f(typename S::Vector(x.template cast<typename S::Real>()));
        for (int c = 0; c < S::dimension; ++c) patch.column(field, c)[i] = value[c];
    }
}

/// Copies of what was gathered for each particle.
template <class S>
class Record final : public GatherSink<S> {
  public:
    using Real = typename S::Real;
    struct Entry {
        typename S::Vector velocity, acceleration;
        std::array<Real, S::deformation_size> gradient;
        typename S::Matrix affine;
    };
    std::vector<Entry> entries;
    std::vector<std::pair<Index, int>> batches;

    void receive(Index begin, int count, const Gathered<S>& gathered) override {
        batches.push_back({begin, count});
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            Entry& entry = entries.emplace_back();
            for (std::size_t c = 0; c < S::dimension; ++c) {
                entry.velocity[static_cast<Index>(c)] = gathered.velocity[c][i];
                entry.acceleration[static_cast<Index>(c)] = gathered.acceleration[c][i];
            }
            for (std::size_t c = 0; c < S::deformation_size; ++c)
                entry.gradient[c] = gathered.velocity_gradient[c][i];
            for (std::size_t c = 0; c < S::dimension * S::dimension; ++c)
                entry.affine.data()[c] = gathered.affine[c][i];
        }
    }
};

/// Calls check.template operator()<S>(name of the space) for every space.
template <class Check>
void in_every_space(const Check& check) {
    constexpr const char* modes[] = {"bar", "plane strain", "axisymmetric", "solid"};
    for (const Mode mode : {Mode::bar, Mode::plane_strain, Mode::axisymmetric, Mode::solid})
        for (const bool single : {false, true})
            with_space({mode, single}, [&]<class S>() {
                check.template operator()<S>(std::string(modes[static_cast<int>(mode)]) +
                                             (single ? ", single precision" : ", double precision"));
            });
}

}  // namespace matpoint::conformance
