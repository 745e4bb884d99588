// A plugin whose components fail where and how a scene asks for it.
#include <matpoint/boundary_condition.hpp>
#include <matpoint/exact_solution.hpp>
#include <matpoint/geometry.hpp>
#include <matpoint/integrator.hpp>
#include <matpoint/load.hpp>
#include <matpoint/material.hpp>
#include <matpoint/output.hpp>
#include <matpoint/plugin.hpp>

#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>

namespace matpoint {
namespace {

class Fault {
  public:
    static Schema schema() {
        return Schema("Fails")
            .text("where", {.doc = "The function that fails", .default_value = ""})
            .text("how", {.doc = "What it throws, or the kind of wave speed", .default_value = "int"})
            .number("from", {.doc = "From this time (s) or place (m) on", .default_value = 0})
            .refuse("/where", "fails itself", [](const Json& own, const Json&) {
                if (own.at("where") == "rule") throw 42;
                return false;
            });
    }
    explicit Fault(const Parameters& p)
        : where_(p.text("where")), how_(p.text("how")), from_(p.number("from")) {
        at("constructor");
    }

    bool is(const std::string& function, double time) const { return function == where_ && time >= from_; }
    const std::string& how() const { return how_; }
    void at(const std::string& function, double time = std::numeric_limits<double>::infinity()) const {
        if (!is(function, time)) return;
        if (how_ == "int") throw 42;
        if (how_ == "exception") throw std::exception();
        if (how_ == "bad_alloc") throw std::bad_alloc();
        if (how_ == "logic_error") throw std::logic_error("two and two are five");
        if (how_ == "runtime_error") throw std::runtime_error("the disk is on fire");
    }

  private:
    std::string where_, how_;
    double from_;
};

/// A linear spring in every direction.
template <class S>
class FaultyMaterial final : public Material<S> {
  public:
    using typename Material<S>::Real;
    using typename Material<S>::Batch;
    static Schema schema() {
        return Fault::schema().number("stiffness", {.unit = "Pa", .doc = "E", .at_least = 0});
    }
    explicit FaultyMaterial(const Parameters& p)
        : Material<S>(p), fault_(p), stiffness_(static_cast<Real>(p.number("stiffness"))) {}

    void update_stress(const Batch& batch, Real dt) const override {
        for (Index p = batch.begin(); p < batch.end(); ++p) {
            fault_.at("update", place(batch, p));
            batch.set_stress(p, batch.stress(p) + stiffness_ * dt * batch.velocity_gradient(p));
        }
    }
    Real wave_speed(const Batch& batch) const override {
        const Real speed = std::sqrt(stiffness_ / batch.density(batch.begin()));
        for (Index p = batch.begin(); p < batch.end(); ++p) {
            if (!fault_.is("wave_speed", place(batch, p))) continue;
            fault_.at("wave_speed");
            return fault_.how() == "nan"        ? std::numeric_limits<Real>::quiet_NaN()
                   : fault_.how() == "negative" ? -speed
                                                : Real(0);
        }
        return speed;
    }

  private:
    static double place(const Batch& batch, Index p) {
        return static_cast<double>(batch.particles().column(Field::position)[p]);
    }
    Fault fault_;
    Real stiffness_;
};

template <class S>
class FaultyLoad final : public Load<S> {
  public:
    static Schema schema() { return Fault::schema(); }
    explicit FaultyLoad(const Parameters& p) : fault_(p) {}
    void declare(Particles<S>&) override { fault_.at("declare"); }
    void start(const Patch<S>&, std::span<Particles<S>>) override { fault_.at("start"); }
    void apply(LoadContext<S>& context) const override { fault_.at("apply", context.time); }

  private:
    Fault fault_;
};

template <class S>
class FaultyCondition final : public BoundaryCondition<S> {
  public:
    using typename BoundaryCondition<S>::Vector;
    using typename BoundaryCondition<S>::Position;
    static Schema schema() { return Fault::schema(); }
    explicit FaultyCondition(const Parameters& p) : fault_(p) {}
    std::array<bool, 3> prescribes(int) const override { return {true, true, true}; }
    Vector velocity(const Position&, double time) const override {
        fault_.at("velocity", time);
        return Vector::UnitX();
    }

  private:
    Fault fault_;
};

template <class S>
class FaultyIntegrator final : public Integrator<S> {
  public:
    using typename Integrator<S>::Real;
    static Schema schema() { return Fault::schema(); }
    explicit FaultyIntegrator(const Parameters& p) : fault_(p) {}
    void step(Phases<S>& phases, Real dt) const override {
        phases.project({.velocity = true, .internal_force = true});
        phases.accelerate(dt);
        fault_.at("step", static_cast<double>(phases.step_number()) * static_cast<double>(dt));
        phases.update({.velocity = true, .position = NodeField::velocity, .stress = NodeField::velocity}, dt);
    }

  private:
    Fault fault_;
};

class FaultyGeometry final : public Geometry {
  public:
    static Schema schema() { return Fault::schema(); }
    explicit FaultyGeometry(const Parameters& p) : fault_(p) {}
    Bounds bounds() const override { return {Eigen::Vector3d::Constant(0.1), Eigen::Vector3d::Ones()}; }
    bool contains(const Eigen::Vector3d&) const override {
        fault_.at("contains");
        return true;
    }

  private:
    Fault fault_;
};

/// Of a body that moves with 1 m/s.
class FaultySolution final : public ExactSolution {
  public:
    static Schema schema() { return Fault::schema(); }
    explicit FaultySolution(const Parameters& p) : ExactSolution(p), fault_(p) {}
    Vector displacement(const Vector&, double time) const override {
        fault_.at("displacement", time);
        return time * Vector::UnitX();
    }
    Vector velocity(const Vector&, double) const override { return Vector::UnitX(); }
    Matrix deformation_gradient(const Vector&, double) const override { return Matrix::Identity(); }
    Matrix stress(const Vector&, double) const override { return Matrix::Zero(); }

  private:
    Fault fault_;
};

class FaultyOutput final : public Output {
  public:
    static Schema schema() { return Fault::schema(); }
    explicit FaultyOutput(const Parameters& p) : fault_(p) {}
    void check(const RunView&) override { fault_.at("check"); }
    void open(const RunView&, const std::filesystem::path&, double) override { fault_.at("open"); }
    void write(const RunView& run) override { fault_.at("write", run.time()); }
    void flush() override { fault_.at("flush"); }

  private:
    Fault fault_;
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("faulty", "0.0.1") {
    using namespace matpoint;
    registry.material<FaultyMaterial>("faulty_material");
    registry.load<FaultyLoad>("faulty_load");
    registry.boundary_condition<FaultyCondition>("faulty_condition");
    registry.integrator<FaultyIntegrator>("faulty_integrator");
    registry.geometry<FaultyGeometry>("faulty_geometry");
    registry.exact_solution<FaultySolution>("faulty_solution");
    registry.output<FaultyOutput>("faulty_output");
}
