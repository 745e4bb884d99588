#pragma once

#include "each_once.hpp"
#include "particle_cloud.hpp"

#include <matpoint/registry.hpp>
#include <matpoint/tensor_product_shape.hpp>
#include <matpoint/transfer.hpp>

#include <gtest/gtest.h>

#include <cmath>

/// What every transfer must satisfy, in every space. Out of tree:
///
///     Registry registry;
///     matpoint_plugin_register(registry);
///     conformance::check_transfer(registry, {{"type", "my_transfer"}, …});
///
/// with every parameter given.
namespace matpoint::conformance {

/// The basis of the checks: quadratic B-splines.
struct QuadraticKernel {
    static constexpr int width = 3;
    static constexpr bool sized = false;
    template <class T>
    static T base(T xi) {
        using std::floor;
        return floor(xi - T(0.5));
    }
    template <class T>
    static void evaluate(T s, T, T* weights, T* derivatives) {
        const T left = T(1.5) - s, middle = s - T(1), right = s - T(0.5);
        weights[0] = T(0.5) * left * left;
        weights[1] = T(0.75) - middle * middle;
        weights[2] = T(0.5) * right * right;
        derivatives[0] = -left;
        derivatives[1] = T(-2) * middle;
        derivatives[2] = right;
    }
};

template <class S>
class TransferChecks {
  public:
    using Real = typename S::Real;
    using Vector = typename S::Vector;
    using Matrix = typename S::Matrix;
    static constexpr int d = S::dimension;
    static constexpr double tolerance = 2000 * std::numeric_limits<Real>::epsilon();

    explicit TransferChecks(const Transfer<S>& transfer)
        : transfer_(transfer), patch_(make_patch<S>()), cloud_(patch_, DeclaringShape(transfer), 300) {}

    void all() {
        keeps_constant_velocity();
        conserves_momentum();
        if (transfer_.affine()) projects_linear_fields_exactly();
        // Particles that keep some of their own velocity keep it while they fly, not what nodes see of it.
        if (transfer_.needs_affine() && transfer_.grid_share() == Real(1)) conserves_angular_momentum();
        if (transfer_.grid_share() == Real(0)) keeps_velocity_without_acceleration();
        EXPECT_GE(transfer_.grid_share(), 0);
        EXPECT_LE(transfer_.grid_share(), 1);
    }

    void keeps_constant_velocity() {
        set_particles([](const Vector&) -> Vector { return Vector::LinSpaced(1, 2); }, Matrix::Zero());
        project();
        accelerate(Vector::Zero(), Real(0.1));
        update(Real(0.1));
        for (Index p = 0; p < size(); ++p)
            EXPECT_LE((cloud_.particles.velocity(p) - Vector::LinSpaced(1, 2)).norm(), tolerance);
    }

    /// Projection and update pass on what the accelerations put in, and no more.
    void conserves_momentum() {
        randomise_particles();
        const Real dt = Real(0.1);
        const Vector before = momentum();
        project();
        EXPECT_LE((node_momentum() - before).norm(), tolerance * scale());
        accelerate(Vector::LinSpaced(3, -2), dt);
        const Vector after = node_momentum();
        EXPECT_GT((after - before).norm(), 0.1 * scale() * static_cast<double>(dt));
        update(dt);
        EXPECT_LE((momentum() - after).norm(), tolerance * scale());
    }

    /// v(x) = b + L x, known to the particles with its gradient, arrives at every node they reach
    /// [Wallstedt & Guilkey 2007, section 5.1].
    void projects_linear_fields_exactly() {
        const auto field = [](const Vector& x) -> Vector { return Vector::LinSpaced(1, 2) + slope() * x; };
        set_particles(field, slope());
        project();
        int reached = 0;
        for (int i = 0; i < static_cast<int>(patch_.node_count()); ++i) {
            if (!(patch_.column(NodeField::mass)[i] > Real(0.01))) continue;
            const Vector exact = field(node_position(i));
            EXPECT_LE((node(NodeField::velocity, i) - exact).norm(), tolerance);
            ++reached;
        }
        EXPECT_GT(reached, 3);
    }

    /// The nodes' angular momentum is the same after a round trip over the particles.
    void conserves_angular_momentum() {
        randomise_particles();
        project();
        update(Real(0.1));
        project();
        const auto before = node_angular_momentum();
        update(Real(0.1));
        project();
        const auto after = node_angular_momentum();
        for (std::size_t k = 0; k < before.size(); ++k) EXPECT_NEAR(before[k], after[k], tolerance * scale());
    }

    void keeps_velocity_without_acceleration() {
        randomise_particles();
        std::vector<Vector> before;
        for (Index p = 0; p < size(); ++p) before.push_back(cloud_.particles.velocity(p));
        project();
        accelerate(Vector::Zero(), Real(0.1));
        update(Real(0.1));
        for (Index p = 0; p < size(); ++p)
            EXPECT_EQ(cloud_.particles.velocity(p), before[static_cast<std::size_t>(p)]);
    }

  private:
    using Shape = TensorProductShape<S, QuadraticKernel>;
    /// Has the cloud carry the transfer's fields.
    struct DeclaringShape : Shape {
        explicit DeclaringShape(const Transfer<S>& declaring) : transfer(declaring) {}
        void declare(Particles<S>& particles) const override { transfer.declare(particles); }
        const Transfer<S>& transfer;
    };
    struct Update final : GatherSink<S> {
        Update(const Transfer<S>& t, Particles<S>& p, Real step) : transfer(t), particles(p), dt(step) {}
        void receive(Index begin, int count, const Gathered<S>& gathered) override {
            transfer.update(ParticleBatch<S>(particles, begin, begin + count, gathered, -1), dt);
        }
        const Transfer<S>& transfer;
        Particles<S>& particles;
        Real dt;
    };

    /// Keeps what particles read.
    struct Read final : GatherSink<S> {
        explicit Read(Particles<S>& p) : particles(p) {}
        void receive(Index begin, int count, const Gathered<S>& gathered) override {
            for (int c = 0; c < d; ++c)
                std::copy_n(gathered.velocity[static_cast<std::size_t>(c)].data(), count,
                            particles.column(Field::grid_velocity, c) + begin);
        }
        Particles<S>& particles;
    };

    Index size() const { return cloud_.particles.size(); }
    static Matrix slope() {
        Matrix l;
        for (int c = 0; c < d * d; ++c) l.data()[c] = static_cast<Real>(1.5 - 0.5 * c);
        return l;
    }
    template <class Function>
    void set_particles(const Function& velocity, const Matrix& gradient) {
        for (Index p = 0; p < size(); ++p) {
            const Vector v = velocity(cloud_.particles.vector(Field::position, p));
            for (int c = 0; c < d; ++c) cloud_.particles.column(Field::velocity, c)[p] = v[c];
            if (cloud_.particles.has(Field::velocity_remainder))
                for (int c = 0; c < d; ++c) cloud_.particles.column(Field::velocity_remainder, c)[p] = 0;
            if (!transfer_.affine()) continue;
            for (int c = 0; c < d * d; ++c)
                cloud_.particles.column(*transfer_.affine(), c)[p] = gradient.data()[c];
        }
    }
    void randomise_particles() {
        std::mt19937 random(3);
        std::uniform_real_distribution<Real> value(-1, 1);
        set_particles(
            [&](const Vector&) -> Vector { return Vector::NullaryExpr([&] { return value(random); }); },
            slope());
    }

    void project() {
        patch_.clear(NodeField::mass);
        patch_.clear(NodeField::velocity);
        const int slot = transfer_.affine() ? cloud_.particles.slot(*transfer_.affine()) : -1;
        shape_.scatter(patch_, cloud_.particles, 0, size(), {true, NodeField::velocity, slot, false});
        for (Index i = 0; i < patch_.node_count(); ++i)
            for (int c = 0; c < d; ++c) {
                const Real mass = patch_.column(NodeField::mass)[i];
                Real& v = patch_.column(NodeField::velocity, c)[i];
                v = mass > Real(0) ? v / mass : Real(0);
            }
    }
    void accelerate(const Vector& a, Real dt) {
        set_nodes(patch_, NodeField::acceleration, [&](const Vector&) { return a; });
        for (int c = 0; c < d; ++c)
            for (Index i = 0; i < patch_.node_count(); ++i)
                patch_.column(NodeField::velocity, c)[i] += a[c] * dt;
    }
    /// As the kernel, to transfers of higher order.
    void add_terms() {
        std::vector<std::vector<Real>> lumped;
        for (int c = 0; c < d; ++c) {
            const Real* v = patch_.column(NodeField::velocity, c);
            lumped.emplace_back(v, v + patch_.node_count());
        }
        const int slot = cloud_.particles.slot(Field::grid_velocity);
        for (int term = 1; term < transfer_.order(); ++term) {
            Read sink(cloud_.particles);
            shape_.gather(patch_, cloud_.particles, 0, size(), {.velocity = NodeField::velocity}, sink);
            patch_.clear(NodeField::resampled_velocity);
            shape_.scatter(patch_, cloud_.particles, 0, size(),
                           {.momentum = NodeField::resampled_velocity, .velocity_slot = slot});
            for (int c = 0; c < d; ++c)
                for (Index i = 0; i < patch_.node_count(); ++i) {
                    const Real mass = patch_.column(NodeField::mass)[i];
                    if (mass > Real(0))
                        patch_.column(NodeField::velocity, c)[i] +=
                            lumped[static_cast<std::size_t>(c)][static_cast<std::size_t>(i)] -
                            patch_.column(NodeField::resampled_velocity, c)[i] / mass;
                }
        }
    }
    void update(Real dt) {
        add_terms();
        Gather what{.acceleration = transfer_.needs_acceleration(), .affine = transfer_.needs_affine()};
        if (transfer_.grid_share() > Real(0)) what.velocity = NodeField::velocity;
        Update sink(transfer_, cloud_.particles, dt);
        shape_.gather(patch_, cloud_.particles, 0, size(), what, sink);
    }

    Vector node(NodeField field, int i) const {
        Vector v;
        for (int c = 0; c < d; ++c) v[c] = patch_.column(field, c)[i];
        return v;
    }
    Vector node_position(int i) const {
        return patch_.node_position(patch_.node_coordinates(i)).template cast<Real>();
    }
    Vector momentum() const {
        Vector sum = Vector::Zero();
        for (Index p = 0; p < size(); ++p)
            sum += cloud_.particles.column(Field::mass)[p] * cloud_.particles.velocity(p);
        return sum;
    }
    Vector node_momentum() const {
        Vector sum = Vector::Zero();
        for (int i = 0; i < static_cast<int>(patch_.node_count()); ++i)
            sum += patch_.column(NodeField::mass)[i] * node(NodeField::velocity, i);
        return sum;
    }
    /// sum m x (x) v, skew part.
    std::vector<double> node_angular_momentum() const {
        std::vector<double> sum(static_cast<std::size_t>(d * (d - 1) / 2));
        for (int i = 0; i < static_cast<int>(patch_.node_count()); ++i) {
            const Vector x = node_position(i), v = node(NodeField::velocity, i);
            std::size_t k = 0;
            for (int a = 0; a < d; ++a)
                for (int b = a + 1; b < d; ++b)
                    sum[k++] +=
                        static_cast<double>(patch_.column(NodeField::mass)[i] * (x[a] * v[b] - x[b] * v[a]));
        }
        return sum;
    }
    /// Of momenta: the total mass.
    double scale() const {
        const Real* mass = cloud_.particles.column(Field::mass);
        return std::accumulate(mass, mass + size(), 0.0);
    }

    const Transfer<S>& transfer_;
    Shape shape_;
    Patch<S> patch_;
    ParticleCloud<S> cloud_;
};

/// Runs all checks in all spaces. `own`: the transfer's object as in a resolved scene.
inline void check_transfer(const Registry& registry, const Json& own) {
    each_failure_once([&] {
        in_every_space([&]<class S>(const std::string& space) {
            SCOPED_TRACE(own.dump() + ", " + space);
            const Parameters::Context context{SpaceId::of<S>(), ".", &registry, nullptr};
            TransferChecks<S>(*registry.make<Transfer<S>>("transfer", own, context)).all();
        });
    });
}

}  // namespace matpoint::conformance
