// The Material Point Method as a textbook has it, for the scenes configs/benchmarks/block_*.json: what the
// framework's time is compared with. Particles are structures, each keeps the list of its nodes with their
// weights and gradients, rebuilt in every step; the grid is dense. Neo-Hookean, flip, usl. It shares no code
// with the framework.
//
// usage: reference_loop SHAPE PRECISION ORDER COUNTS STEPS
//   SHAPE linear, gimp (uniform), quadratic, cubic; PRECISION double, single; ORDER random, sorted (by cell);
//   COUNTS particles along an edge of the block, two a cell; STEPS
// Prints JSON; the energy is that after the last step.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace {

// The scene's numbers, SI.
constexpr double edge = 1.5, block_min = 0.25, jitter = 0.25, density = 1000, youngs_modulus = 1e6,
                 poissons_ratio = 0.3, cfl = 0.4, wave_speed = 37;

template <class Real>
using Vector = std::array<Real, 3>;
template <class Real>
using Matrix = std::array<Vector<Real>, 3>;

template <class Real>
struct Neighbour {
    std::size_t node;
    Real weight;
    Vector<Real> gradient;  // 1/m
};

template <class Real>
struct Particle {
    Real mass, volume, initial_volume;
    Vector<Real> position, velocity;
    Matrix<Real> deformation, stress;
    std::vector<Neighbour<Real>> neighbours;
};

template <class Real>
struct Node {
    Real mass;
    Vector<Real> momentum, force, velocity, acceleration;
};

// Shape functions of one axis: value and derivative at a distance of s cells from the node.
struct Linear {
    static constexpr int width = 2;
    static constexpr double reach = 0;  // the first node is floor(x - reach)
    template <class Real>
    static std::array<Real, 2> at(Real s) {
        return {1 - std::abs(s), s < 0 ? Real(1) : Real(-1)};
    }
};

struct Gimp {  // domains of a quarter of a cell to either side [Bardenhagen & Kober 2004]
    static constexpr int width = 3;
    static constexpr double reach = 0.5;
    template <class Real>
    static std::array<Real, 2> at(Real s) {
        const Real l = Real(0.25), a = std::abs(s), sign = s < 0 ? Real(-1) : Real(1);
        if (a < l) return {1 - (s * s + l * l) / (2 * l), -s / l};
        if (a < 1 - l) return {1 - a, -sign};
        if (a < 1 + l) return {(1 + l - a) * (1 + l - a) / (4 * l), -sign * (1 + l - a) / (2 * l)};
        return {0, 0};
    }
};

struct Quadratic {
    static constexpr int width = 3;
    static constexpr double reach = 0.5;
    template <class Real>
    static std::array<Real, 2> at(Real s) {
        const Real a = std::abs(s), sign = s < 0 ? Real(-1) : Real(1), rest = Real(1.5) - a;
        if (a < Real(0.5)) return {Real(0.75) - s * s, -2 * s};
        return {rest * rest / 2, -sign * rest};
    }
};

struct Cubic {
    static constexpr int width = 4;
    static constexpr double reach = 1;
    template <class Real>
    static std::array<Real, 2> at(Real s) {
        const Real a = std::abs(s), sign = s < 0 ? Real(-1) : Real(1), rest = 2 - a;
        if (a < 1) return {Real(2) / 3 - a * a * (1 - a / 2), sign * a * (Real(1.5) * a - 2)};
        return {rest * rest * rest / 6, -sign * rest * rest / 2};
    }
};

template <class Real>
Real determinant(const Matrix<Real>& m) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

template <class Real, class Shape>
class Block {
  public:
    Block(int counts, const std::string& order)
        : h_(static_cast<Real>(cell_size(counts))),
          dt_(static_cast<Real>(cfl * cell_size(counts) / wave_speed)),
          nodes_per_axis_(static_cast<int>(std::lround(edge / cell_size(counts))) + 1),
          nodes_(static_cast<std::size_t>(nodes_per_axis_ * nodes_per_axis_ * nodes_per_axis_)) {
        fill(counts);
        if (order == "random") std::shuffle(particles_.begin(), particles_.end(), std::mt19937(1));
        if (order == "sorted")
            std::ranges::stable_sort(particles_, {}, [&](const Particle<Real>& p) {
                return std::array{base(p.position[2]), base(p.position[1]), base(p.position[0])};
            });
    }

    std::size_t size() const { return particles_.size(); }

    void step() {
        for (Node<Real>& node : nodes_) node = {};
        for (Particle<Real>& p : particles_) find_neighbours(p);
        for (const Particle<Real>& p : particles_) project(p);
        for (const Particle<Real>& p : particles_) add_internal_force(p);
        for (Node<Real>& node : nodes_)
            if (node.mass > 0)
                for (std::size_t a = 0; a < 3; ++a) {
                    node.acceleration[a] = node.force[a] / node.mass;
                    node.velocity[a] = node.momentum[a] / node.mass + node.acceleration[a] * dt_;
                }
        for (Particle<Real>& p : particles_) move(p);
        for (Particle<Real>& p : particles_) strain(p);
    }

    double kinetic_energy() const {
        double sum = 0;
        for (const Particle<Real>& p : particles_)
            for (const Real v : p.velocity) sum += static_cast<double>(p.mass * v * v) / 2;
        return sum;
    }

  private:
    static constexpr double lambda =
        youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio));
    static constexpr double mu = youngs_modulus / (2 * (1 + poissons_ratio));

    static double cell_size(int counts) { return 2.0 / (counts - 1); }

    // SplitMix64's k-th number in [-1, 1), as plugins/geometry/lattice/README.md says.
    static double scattered(std::uint64_t k) {
        std::uint64_t z = (k + 1) * 0x9e3779b97f4a7c15U;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return std::ldexp(static_cast<double>((z ^ (z >> 31U)) >> 11U), -52) - 1;
    }

    void fill(int counts) {
        const double spacing = cell_size(counts) / 2;
        const auto volume = static_cast<Real>(spacing * spacing * spacing);
        for (int k = 0; k < counts; ++k)
            for (int j = 0; j < counts; ++j)
                for (int i = 0; i < counts; ++i) {
                    const std::array place{i, j, k};
                    Particle<Real> p{};
                    std::array<double, 3> x{};
                    for (std::size_t a = 0; a < 3; ++a) {
                        x[a] = block_min +
                               spacing * (place[a] + 0.5 + jitter * scattered(3 * particles_.size() + a));
                        p.position[a] = static_cast<Real>(x[a]);
                        p.deformation[a][a] = 1;
                    }
                    p.velocity = {1, Real(0.5), static_cast<Real>(0.5 * x[0])};
                    p.volume = p.initial_volume = volume;
                    p.mass = static_cast<Real>(density) * volume;
                    particles_.push_back(p);
                }
    }

    int base(Real x) const { return static_cast<int>(std::floor(x / h_ - Real(Shape::reach))); }

    void find_neighbours(Particle<Real>& p) const {
        std::array<int, 3> first{};
        std::array<std::array<std::array<Real, 2>, Shape::width>, 3> shapes{};
        for (std::size_t a = 0; a < 3; ++a) {
            first[a] = base(p.position[a]);
            for (int i = 0; i < Shape::width; ++i)
                shapes[a][static_cast<std::size_t>(i)] =
                    Shape::at(p.position[a] / h_ - static_cast<Real>(first[a] + i));
        }
        p.neighbours.clear();
        for (int k = 0; k < Shape::width; ++k)
            for (int j = 0; j < Shape::width; ++j)
                for (int i = 0; i < Shape::width; ++i) {
                    const auto& [x, dx] = shapes[0][static_cast<std::size_t>(i)];
                    const auto& [y, dy] = shapes[1][static_cast<std::size_t>(j)];
                    const auto& [z, dz] = shapes[2][static_cast<std::size_t>(k)];
                    const int node =
                        ((first[2] + k) * nodes_per_axis_ + first[1] + j) * nodes_per_axis_ + first[0] + i;
                    p.neighbours.push_back({static_cast<std::size_t>(node),
                                            x * y * z,
                                            {dx * y * z / h_, x * dy * z / h_, x * y * dz / h_}});
                }
    }

    // [Wallstedt & Guilkey 2008, eq. 8, 9]
    void project(const Particle<Real>& p) {
        for (const Neighbour<Real>& n : p.neighbours) {
            Node<Real>& node = nodes_[n.node];
            node.mass += n.weight * p.mass;
            for (std::size_t a = 0; a < 3; ++a) node.momentum[a] += n.weight * p.mass * p.velocity[a];
        }
    }

    // eq. 14
    void add_internal_force(const Particle<Real>& p) {
        for (const Neighbour<Real>& n : p.neighbours)
            for (std::size_t a = 0; a < 3; ++a)
                for (std::size_t b = 0; b < 3; ++b)
                    nodes_[n.node].force[a] -= p.volume * p.stress[a][b] * n.gradient[b];
    }

    // eq. 18, 19
    void move(Particle<Real>& p) const {
        for (const Neighbour<Real>& n : p.neighbours)
            for (std::size_t a = 0; a < 3; ++a) {
                p.velocity[a] += n.weight * nodes_[n.node].acceleration[a] * dt_;
                p.position[a] += n.weight * nodes_[n.node].velocity[a] * dt_;
            }
    }

    // eq. 17, 11-13, 55
    void strain(Particle<Real>& p) const {
        Matrix<Real> gradient{};
        for (const Neighbour<Real>& n : p.neighbours)
            for (std::size_t a = 0; a < 3; ++a)
                for (std::size_t b = 0; b < 3; ++b)
                    gradient[a][b] += nodes_[n.node].velocity[a] * n.gradient[b];
        Matrix<Real> f = p.deformation;
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b)
                for (std::size_t c = 0; c < 3; ++c) f[a][b] += dt_ * gradient[a][c] * p.deformation[c][b];
        p.deformation = f;
        const Real j = determinant(f);
        p.volume = p.initial_volume * j;
        const Real pressure = static_cast<Real>(lambda) * std::log(j) / j;
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b) {
                const Real one = a == b ? 1 : 0;
                const Real square = f[a][0] * f[b][0] + f[a][1] * f[b][1] + f[a][2] * f[b][2];
                p.stress[a][b] = pressure * one + static_cast<Real>(mu) / j * (square - one);
            }
    }

    Real h_, dt_;  // m, s
    int nodes_per_axis_;
    std::vector<Node<Real>> nodes_;
    std::vector<Particle<Real>> particles_;
};

template <class Real, class Shape>
int run(const std::string& order, int counts, int steps) {
    Block<Real, Shape> block(counts, order);
    const auto begin = std::chrono::steady_clock::now();
    for (int s = 0; s < steps; ++s) block.step();
    const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - begin;
    std::cout.precision(17);
    std::cout << "{ \"order\": \"" << order << "\", \"particles\": " << block.size()
              << ", \"steps\": " << steps << ", \"nanoseconds_per_particle_step\": "
              << elapsed.count() / (static_cast<double>(block.size()) * steps)
              << ", \"kinetic_energy\": " << block.kinetic_energy() << " }\n";
    return 0;
}

template <class Real>
int run(const std::string& shape, const std::string& order, int counts, int steps) {
    if (shape == "linear") return run<Real, Linear>(order, counts, steps);
    if (shape == "gimp") return run<Real, Gimp>(order, counts, steps);
    if (shape == "quadratic") return run<Real, Quadratic>(order, counts, steps);
    if (shape == "cubic") return run<Real, Cubic>(order, counts, steps);
    return 2;
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() != 5) {
        std::cerr << "usage: reference_loop SHAPE PRECISION ORDER COUNTS STEPS\n";
        return 2;
    }
    const int counts = std::atoi(words[3].c_str()), steps = std::atoi(words[4].c_str());
    return words[1] == "single" ? run<float>(words[0], words[2], counts, steps)
                                : run<double>(words[0], words[2], counts, steps);
}
