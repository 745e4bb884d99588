// Time of what is done to particles apart from the grid, per particle: stress of each material, new velocity
// of each transfer, and putting particles in order. 32768 particles in 3D.

#include "loops.hpp"
#include "step/ordering.hpp"

#include <matpoint/material.hpp>
#include <matpoint/transfer.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace matpoint {
namespace {

constexpr Index count = 32768;

/// Numbers of every field and of what was gathered, uniform in -size to size; F is the identity plus such.
template <class S>
class Cloud {
  public:
    using Real = typename S::Real;

    Cloud() : particles("cloud") {}
    void fill(Real size) {
        particles.resize(count);
        std::uniform_real_distribution<Real> number(-size, size);
        for (int slot = 0; slot < particles.field_count(); ++slot)
            for (int c = 0; c < particles.components(slot); ++c) {
                Real* column = particles.column(slot, c);
                for (Index p = 0; p < count; ++p) column[p] += number(random_);
            }
        for (Field field : {Field::mass, Field::volume}) std::fill_n(particles.column(field), count, Real(1));
        for (auto* fields : {&gathered.velocity_gradient, &gathered.affine})
            for (auto& column : *fields) std::ranges::generate(column, [&] { return number(random_); });
        for (auto* fields : {&gathered.velocity, &gathered.acceleration})
            for (auto& column : *fields) std::ranges::generate(column, [&] { return number(random_); });
    }
    template <class Function>
    void for_each_batch(int first_state, Function function) {
        for (Index begin = 0; begin < count; begin += batch_size)
            function(ParticleBatch<S>(particles, begin, begin + batch_size, gathered, first_state));
    }

    Particles<S> particles;
    Gathered<S> gathered{};

  private:
    std::mt19937 random_{1};
};

template <class S>
void update_stress(benchmark::State& state, const Json& json) {
    const auto material = make<Material, S>("material", json);
    Cloud<S> cloud;
    if (material->uses_deformation_gradient()) cloud.particles.require(Field::displacement_gradient);
    const int first_state = cloud.particles.field_count();
    for (const StateVariable& variable : material->state())
        cloud.particles.require(variable.name, 1, variable.initial);
    cloud.fill(typename S::Real(1e-3));
    for (auto _ : state)
        cloud.for_each_batch(first_state, [&](const ParticleBatch<S>& batch) {
            material->update_stress(batch, typename S::Real(1e-3));
        });
    report(state, count);
}

template <class S>
void update_velocity(benchmark::State& state, const Json& json) {
    const auto transfer = make<Transfer, S>("transfer", json);
    Cloud<S> cloud;
    transfer->declare(cloud.particles);
    cloud.fill(typename S::Real(1e-3));
    for (auto _ : state)
        cloud.for_each_batch(
            0, [&](const ParticleBatch<S>& batch) { transfer->update(batch, typename S::Real(1e-3)); });
    report(state, count);
}

/// All particles of a block in order anew, from an order that has nothing to do with it, or that is it
/// already.
template <class S>
void order(benchmark::State& state, const Json& json) {
    const auto shape = make<ShapeFunction, S>("shape_function", {{"type", "bspline"}, {"order", 2}});
    constexpr int edge = 16;  // cells
    Patch<S> patch({0, 0, 0}, {1, 1, 1}, {edge + 2, edge + 2, edge + 2});
    const Levels<S> levels(patch, {}, {});
    std::vector<Particles<S>> bodies;
    bodies.emplace_back("block");
    bodies[0].require(Field::displacement_gradient);
    bodies[0].resize(count);
    std::mt19937 random(1);
    std::uniform_real_distribution<typename S::Real> place(1, edge + 1);
    for (int a = 0; a < 3; ++a)
        std::generate_n(bodies[0].column(Field::position, a), count, [&] { return place(random); });
    std::vector<std::uint32_t> shuffled(count);
    std::iota(shuffled.begin(), shuffled.end(), 0U);
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    Ordering<S> ordering(1);
    for (auto _ : state) {
        if (json.at("shuffled")) {
            state.PauseTiming();
            bodies[0].permute(shuffled);
            state.ResumeTiming();
        }
        ordering.forget(0);
        ordering.update(levels, bodies, *shape);
    }
    report(state, count);
}

}  // namespace
}  // namespace matpoint

int main(int argc, char** argv) {
    using namespace matpoint;
    for (Json json : {Json{{"type", "linear_elastic"}, {"strain", "rate"}}, Json{{"type", "neo_hookean"}},
                      Json{{"type", "j2_plasticity"}, {"yield_stress", 100}, {"tangent_modulus", 1e4}}}) {
        json.update({{"density", 1000}, {"youngs_modulus", 1e6}, {"poissons_ratio", 0.3}});
        add("stress/" + json.at("type").get<std::string>(), update_stress<Solid>, update_stress<SolidSingle>,
            json);
    }
    for (const Json& json :
         {Json{{"type", "flip"}, {"pic_fraction", 0}, {"gradient_enhanced", false}}, Json{{"type", "apic"}}})
        add("velocity/" + json.at("type").get<std::string>(), update_velocity<Solid>,
            update_velocity<SolidSingle>, json);
    add("order/shuffled", order<Solid>, order<SolidSingle>, {{"shuffled", true}});
    add("order/ordered", order<Solid>, order<SolidSingle>, {{"shuffled", false}});
    return run(argc, argv);
}
