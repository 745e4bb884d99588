#pragma once

#include "run/assemble.hpp"
#include "run/health.hpp"

#include <algorithm>

namespace matpoint {

/// A Simulation in one space.
template <class S>
class SceneSimulation final : public Simulation {
  public:
    SceneSimulation(const Scene& scene, PluginCatalogue& catalogue);

    bool finished() const override;
    void advance() override;
    double next_time_step() const override;
    double stable_step() const override { return stable_part_ * crossing_time(); }
    void check_step() override;
    long estimated_steps() const override;

    void measure_error() override;
    std::optional<Json> error() const override;

    CheckpointData state() const override;
    void restore(const CheckpointData& state) override;

    Conservation conservation() const override;
    std::size_t particle_count() const override;
    std::size_t bytes_per_particle() const override;
    std::size_t memory_bytes() const override;
    Json phase_seconds() const override;
    Json levels() const override;
    std::vector<std::string> particle_fields() const override;
    std::vector<std::string> node_fields() const override;
    const std::vector<ScheduledOutput>& outputs() const override { return assembly_.outputs; }
    const std::vector<SeededBody>& seeded_bodies() const override { return assembly_.seeded; }
    const std::vector<std::string>& warnings() const override { return warnings_; }

    std::string title() const override { return title_; }
    double time() const override { return time_; }
    long step() const override { return step_; }
    double time_step() const override { return last_time_step_; }
    SpaceId space() const override { return SpaceId::of<S>(); }
    std::vector<std::string> bodies() const override;
    std::size_t particle_count(const std::string& body) const override;
    std::vector<std::string> fields(const std::string& body) const override;
    int components(const std::string& body, const std::string& field) const override;
    std::vector<double> column(const std::string& body, const std::string& field,
                               int component) const override;
    Energies energies() const override {
        return {engine_.tally().kinetic, numbers_.strain, numbers_.external, numbers_.damped,
                numbers_.contact};
    }
    double unbalanced_force() const override;
    double noise() const override;
    std::optional<bool> at_rest() const override;
    double mass() const override;
    std::array<double, 3> momentum() const override { return engine_.tally().momentum; }
    std::array<double, 3> reaction(const std::string& boundary_condition) const override;
    std::vector<std::string> contacts() const override;
    ContactReport contact(const std::string& name) const override;
    SurfaceMesh tool_surface(const std::string& contact) const override;

  private:
    std::size_t number_of_contact(const std::string& name) const;
    /// What is added up over the run, and what the next step needs beyond the particles.
    struct Numbers {
        double strain = 0, external = 0, damped = 0, contact = 0;  // J
        double first_energy = 0, largest_energy = 0;               // J
        double given_energy = 0;                  // most that the start and what acts from outside gave
        double energy_gain = 0, energy_loss = 0;  // largest, of the balance
        double largest_carried = 0;               // N, of the forces that hold each other
        double scene_from_step = 0;               // from which on the scene is as it is
        double first_mass = 0, lost_mass = 0;     // kg
        std::array<double, 3> given_momentum{};   // kg m/s, at the start and by all impulses since
        double largest_momentum = 0, momentum_drift = 0;
        /// A fixed step, s, and the step and time (s) from which it is counted: those of a restart that
        /// changed it.
        double fixed_step = 0, fixed_from_step = 0, fixed_from_time = 0;
        ErrorSums error;
        /// Every number by name, for checkpoints.
        template <class Numbers_, class Visitor>
        static void visit(Numbers_& n, const Visitor& visitor);
    };

    const Particles<S>& body(const std::string& name) const;
    void check_outputs(const Scene& scene);
    /// Time that a wave and a particle take to cross a cell, s.
    double crossing_time() const;
    void remove_strays();
    void guard_waves();
    void refuse_faults(const Scene& scene) const;
    void account();
    /// What the start, loads, walls and the release of stress at the start have given, J.
    double given_energy() const;
    void guard_energy(double dt) const;
    /// At the end: what did nothing, and energy that was not kept.
    void warn_at_end();
    /// What is wrong with a body that a number alone doesn't tell: that it is torn, or the shape's trouble.
    std::string ailments(std::size_t body) const;
    /// Unless a warning has the word already.
    void warn_once(const std::string& word, const std::string& text);

    std::string title_, scene_text_, folder_;
    std::map<std::string, std::string> plugins_;
    double end_, step_length_ = 0, cfl_ = 0;
    double rest_;  ///< unbalanced force of a scene at rest; 0: not asked for
    long max_steps_;
    bool guarded_, deletes_strays_;
    std::string on_unstable_step_;
    double most_drift_, most_gain_;  ///< of energy, in parts
    Assembly<S> assembly_;
    Engine<S> engine_;
    double settled_at_;  ///< s, from when on loads and boundaries stay as they are
    double smallest_cell_;
    double stable_part_;  ///< of the time that a wave takes to cross a cell

    std::vector<std::size_t> first_pieces_;  ///< by body: of how many parts it is at the start

    long step_ = 0;
    double time_ = 0, last_time_step_ = 0;
    Numbers numbers_;
    std::vector<std::string> warnings_;
    bool warned_of_waves_ = false;
};

}  // namespace matpoint
