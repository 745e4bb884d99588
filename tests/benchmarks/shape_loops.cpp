// Time of the particle-grid loops for each shape function, per particle: a block of 32768 jittered
// particles in 3D, 8 a cell, sorted as a simulation sorts them.

#include "loops.hpp"

#include <matpoint/shape_function.hpp>

#include <algorithm>
#include <numeric>
#include <random>

namespace matpoint {
namespace {

template <class S>
class Block {
  public:
    using Real = typename S::Real;

    explicit Block(ShapeFunction<S>& shape)
        : patch({0, 0, 0}, {0.1, 0.1, 0.1}, {cells + 2, cells + 2, cells + 2}),
          particles("block"),
          shape_(shape) {
        shape.declare(particles);
        particles.resize(count);
        fill();
        shape.start_step(patch, particles);
        sort();
        std::vector<int> blocks(
            static_cast<std::size_t>(patch.blocks()[0] * patch.blocks()[1] * patch.blocks()[2]));
        std::iota(blocks.begin(), blocks.end(), 0);
        patch.set_blocks(blocks);
        for (NodeField field : {NodeField::velocity, NodeField::acceleration})
            for (int c = 0; c < 3; ++c) std::fill_n(patch.column(field, c), patch.node_count(), Real(1));
    }

    static constexpr int cells = 16;
    static constexpr Index count = 8 * cells * cells * cells;
    Patch<S> patch;
    Particles<S> particles;

  private:
    void fill() {
        std::mt19937 random(1);
        std::uniform_real_distribution<Real> jitter(Real(-0.01), Real(0.01));
        for (Index p = 0, rest = 0; p < count; rest = ++p)
            for (int a = 0; a < 3; ++a, rest /= 2 * cells) {
                const auto place = static_cast<Real>(rest % (2 * cells));
                particles.column(Field::position, a)[p] =
                    Real(0.1) + Real(0.05) * (place + Real(0.5)) + jitter(random);
                particles.column(Field::velocity, a)[p] = jitter(random);
                if (particles.has(Field::half_size)) particles.column(Field::half_size, a)[p] = Real(0.025);
                if (particles.has(Field::initial_half_size))
                    particles.column(Field::initial_half_size, a)[p] = Real(0.025);
            }
        std::fill_n(particles.column(Field::mass), count, Real(1));
        std::fill_n(particles.column(Field::volume), count, Real(1));
        for (int c = 0; c < 6; ++c) std::fill_n(particles.column(Field::stress, c), count, Real(c));
    }
    /// By the block of the first node of the stencil, then by this node.
    void sort() {
        std::vector<typename Patch<S>::Coordinates> bases(count);
        shape_.base_nodes(patch, particles, 0, count, bases.data());
        const auto key = [&](std::uint32_t p) {
            auto base = bases[static_cast<std::size_t>(p)], block = base;
            for (int& b : block) b = Patch<S>::block_of(b);
            return std::pair(patch.block_number(block), base);
        };
        std::vector<std::uint32_t> order(count);
        std::iota(order.begin(), order.end(), 0U);
        std::ranges::stable_sort(order, {}, key);
        particles.permute(order);
    }

    ShapeFunction<S>& shape_;
};

template <class S>
void scatter(benchmark::State& state, const Json& json) {
    const auto shape = make<ShapeFunction, S>("shape_function", json);
    Block<S> block(*shape);
    const Scatter what{.mass = true, .momentum = NodeField::velocity, .internal_force = true};
    for (auto _ : state) shape->scatter(block.patch, block.particles, 0, block.count, what);
    report(state, block.count);
}

template <class S>
struct Sink final : GatherSink<S> {
    void receive(Index, int, const Gathered<S>& gathered) override { benchmark::DoNotOptimize(&gathered); }
};

template <class S>
void gather(benchmark::State& state, const Json& json) {
    const auto shape = make<ShapeFunction, S>("shape_function", json);
    Block<S> block(*shape);
    const Gather what{.velocity = NodeField::velocity, .acceleration = true, .gradient = NodeField::velocity};
    Sink<S> sink;
    for (auto _ : state) shape->gather(block.patch, block.particles, 0, block.count, what, sink);
    report(state, block.count);
}

}  // namespace
}  // namespace matpoint

int main(int argc, char** argv) {
    using namespace matpoint;
    const std::pair<const char*, Json> shapes[] = {
        {"linear", {{"type", "linear"}}},
        {"gimp", {{"type", "gimp"}, {"domain", "contiguous"}}},
        {"quadratic", {{"type", "bspline"}, {"order", 2}}},
        {"cubic", {{"type", "bspline"}, {"order", 3}}},
    };
    for (const auto& [name, json] : shapes) {
        add(name + std::string("/scatter"), scatter<Solid>, scatter<SolidSingle>, json);
        add(name + std::string("/gather"), gather<Solid>, gather<SolidSingle>, json);
    }
    return run(argc, argv);
}
