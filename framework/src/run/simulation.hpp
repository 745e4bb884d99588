#pragma once

#include <matpoint/output.hpp>

#include "config/scene.hpp"
#include "registry/catalogue.hpp"
#include "run/checkpoint_file.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace matpoint {

/// The numbers broke down: says the step, the time, the body, the particle, the likely cause and
/// the setting to change.
class Breakdown : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// An output of the scene, and when it is due.
struct ScheduledOutput {
    std::shared_ptr<Output> output;
    std::string type;
    double every = 0;      ///< s; 0: not by time
    long every_steps = 0;  ///< 0: not by steps
};

/// Drifts relative to the largest value over the run of mass, sum |m v| and energy.
struct Conservation {
    double mass_drift = 0;
    double momentum_drift = 0;  ///< what loads and boundaries did not put in
    double energy_drift = 0;    ///< of kinetic + strain - external
    double lost_mass = 0;       ///< kg, of particles deleted off the grid
};

/// A body as it was seeded, beside its geometry.
struct SeededBody {
    std::string name;
    std::size_t particles;
    double mass, volume;                    ///< kg, m^D
    std::optional<double> geometry_volume;  ///< m^D; a list of points has none
};

/// A scene being advanced: particles, grid and components, but no files, no clock and no terminal.
class Simulation : public RunView {
  public:
    virtual ~Simulation() = default;

    /// Makes the components and seeds the bodies. Throws InputError for mistakes that only show now
    /// (a body without particles, a file that can't be read).
    static std::unique_ptr<Simulation> create(const Scene& scene, PluginCatalogue& catalogue);

    virtual bool finished() const = 0;
    /// One step. Throws Breakdown; the state is then no longer one to go on from.
    virtual void advance() = 0;
    virtual const std::vector<ScheduledOutput>& outputs() const = 0;
    virtual const std::vector<SeededBody>& seeded_bodies() const = 0;
    /// Warnings so far, each once: of the scene, of the health guard, and at the end of what did nothing.
    virtual const std::vector<std::string>& warnings() const = 0;
    /// Time step the next advance() would take, s.
    virtual double next_time_step() const = 0;
    /// Longest time step that is stable in the present state, s.
    virtual double stable_step() const = 0;
    /// Throws Breakdown if the next step is longer, or keeps a warning, as the scene asks.
    virtual void check_step() = 0;

    virtual CheckpointData state() const = 0;
    /// Continues from a state of the same scene; the next steps equal the uninterrupted run's.
    virtual void restore(const CheckpointData& state) = 0;

    virtual Conservation conservation() const = 0;
    virtual std::size_t particle_count() const = 0;
    virtual std::size_t bytes_per_particle() const = 0;
    virtual std::size_t memory_bytes() const = 0;
    /// Wall seconds of the steps so far by phase.
    virtual Json phase_seconds() const = 0;
    virtual std::vector<std::string> particle_fields() const = 0;
    virtual std::vector<std::string> node_fields() const = 0;
    /// Whether the scene is at rest; empty unless it is to end then.
    virtual std::optional<bool> at_rest() const = 0;
    /// Cells and particles of the grid's levels; null if there is one.
    virtual Json levels() const = 0;
    /// Norms of the deviation from the scene's exact solution so far; empty if it has none.
    virtual std::optional<Json> error() const = 0;
    /// Compares the present state with the exact solution; called once before the first step and once after
    /// each.
    virtual void measure_error() = 0;
    /// Steps left if the time step stays as it is.
    virtual long estimated_steps() const = 0;
    using RunView::particle_count;
};

}  // namespace matpoint
