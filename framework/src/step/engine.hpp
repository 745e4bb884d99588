#pragma once

#include <matpoint/damping.hpp>
#include <matpoint/integrator.hpp>
#include <matpoint/load.hpp>
#include <matpoint/material.hpp>
#include <matpoint/parallel.hpp>
#include <matpoint/transfer.hpp>

#include "contact/pairs.hpp"
#include "grid/levels.hpp"
#include "step/artificial_viscosity.hpp"
#include "step/held_parts.hpp"
#include "step/light_nodes.hpp"
#include "step/ordering.hpp"
#include "step/ties.hpp"
#include "step/unilateral.hpp"
#include "step/walls.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace matpoint {

/// What a level goes with: a body or a tool.
struct Follow {
    std::optional<std::size_t> body{}, contact{};
};

/// The components of a scene that take part in a step.
template <class S>
struct Components {
    std::shared_ptr<Grid<S>> grid;
    std::shared_ptr<Levels<S>> levels;  ///< of the grid
    std::vector<Follow> follows;        ///< by level from 1 on
    std::shared_ptr<ShapeFunction<S>> shape;
    std::shared_ptr<Transfer<S>> transfer;
    std::shared_ptr<Integrator<S>> integrator;
    std::vector<std::shared_ptr<Material<S>>> materials;          ///< one per body
    std::vector<std::optional<ArtificialViscosity>> viscosities;  ///< one per body, or none at all
    std::vector<std::shared_ptr<Load<S>>> loads;
    std::vector<PlacedCondition<S>> conditions;
    std::vector<PlacedContact<S>> contacts;
    ContactLayers layers;  ///< of the nodes, by which bodies in contact have velocities of their own
    std::shared_ptr<Damping<S>> damping;            ///< null if the scene has none
    bool measures_balance = false;                  ///< whether Tally::unbalanced_force is asked for
    std::shared_ptr<ExactSolution> exact_solution;  ///< null if the scene has none
    double light_nodes = 0;                         ///< share of a full node's mass that makes a node light
};

/// A particle that stopped making sense in a step.
struct Fault {
    enum class Kind {
        inverted,    ///< its volume turned to zero or below
        not_finite,  ///< its velocity or stress, or its volume
        wave_speed,  ///< its state is sound, but its material gives it a wave speed that is none
    };
    std::size_t body;
    Index particle;
    Kind kind;
    double value;  ///< the volume's ratio of the step, or the wave speed (m/s)
};

/// What a step added up.
struct Tally {
    double kinetic = 0;                ///< J, at the end of the step
    double strain_work = 0;            ///< J, done by the stress in the step
    double external_work = 0;          ///< J, by loads and moving boundaries in the step
    double damped = 0;                 ///< J, taken out by damping in the step
    double contact = 0;                ///< J, taken out where bodies meet, in the step
    double noise_energy = 0;           ///< J, sum m |v - sum S v*|^2 / 2, see RunView::noise
    double unbalanced_force = 0;       ///< N, sum |m a| of nodes that move freely, without damping
    double carried_force = 0;          ///< N, sum |f| of the internal forces, or of the external
    std::array<double, 3> momentum{};  ///< kg m/s, at the end of the step
    double momentum_scale = 0;         ///< sum m |v|
    std::array<double, 3> impulse{};   ///< N s, of loads and boundaries in the step
    double largest_speed = 0;          ///< of a particle, m/s
    double largest_wave_speed = 0;     ///< m/s
    double largest_compression = 0;    ///< -tr L of a particle with artificial viscosity, 1/s
    double load_acceleration = 0;      ///< m/s^2, mean size of the loads' over the mass
    std::vector<std::array<double, 3>> reactions;  ///< N, by boundary condition
    /// The first body whose stress does work though its material has no waves.
    std::optional<std::size_t> stiff_without_waves{};
};

/// What a step's time goes into.
enum class StepPhase {
    order,    ///< sorting, the shape's domains and the blocks of nodes
    scatter,  ///< particles to nodes
    loads,
    nodes,   ///< walls, velocities and accelerations
    gather,  ///< nodes to particles, with their new strain and stress
};
inline constexpr std::array<const char*, 5> step_phases = {"order", "scatter", "loads", "nodes", "gather"};
using PhaseSeconds = std::array<double, step_phases.size()>;

/// The part of a tally that one task over particles adds up.
struct Partial {
    std::size_t body = 0;
    bool off_grid = false;  ///< whether one of the particles has left the grid
    double kinetic = 0, noise_energy = 0, momentum_scale = 0, strain_work = 0;
    std::array<double, 3> momentum{};
    double largest_speed = 0, largest_wave_speed = 0, largest_compression = 0;
    std::optional<Fault> fault{};
};

/// Carries out the phases of a step on the particles and the nodes. Sums are formed in an order that
/// does not depend on the number of threads.
template <class S>
class Engine final : public Phases<S> {
  public:
    using Real = typename S::Real;

    Engine(Components<S> components, std::vector<Particles<S>>& bodies, std::vector<int> first_states);

    /// Particles off the grid, to be dealt with before step().
    std::vector<Stray> strays() const {
        if (!off_grid_) return {};
        return ordering_.strays(patch_, bodies_);
    }
    /// One step of length dt (s) from `time` (s), after one of last_dt. What went wrong is in faults().
    void step(long number, double time, double dt, double last_dt);
    /// Brings particles into order and makes the blocks of nodes that they reach.
    void prepare();
    const Tally& tally() const { return tally_; }
    /// Whether each boundary condition has held a node with mass; a checkpoint keeps it.
    std::vector<char>& held() { return held_; }
    const std::vector<char>& held() const { return held_; }
    const std::vector<Fault>& faults() const { return faults_; }
    /// Wall time of all steps so far.
    const PhaseSeconds& seconds() const { return seconds_; }
    /// Mass and velocity of the nodes as the present particles give them, as a step that begins at `time` (s)
    /// would have them.
    void project_velocity(double time);
    /// Kinetic energy, momentum, speeds and loads of the state before the first step.
    void measure();

    const Ordering<S>& ordering() const { return ordering_; }
    std::optional<Exit> exit(const typename S::Position& x, double time) const {
        return walls_.exit(patch_, x, time);
    }
    void restore(const Tally& tally) { tally_ = tally; }
    void restore(std::size_t body, std::vector<BlockRange> ranges) {
        ordering_.restore(levels_, bodies_, body, std::move(ranges));
        located_ = false;
        off_grid_ = true;
    }
    void forget(std::size_t body) { ordering_.forget(body); }
    const Levels<S>& levels() const { return levels_; }
    /// Where what the levels follow was at the start, and how far they have gone with it, m, by level from 1
    /// on; a checkpoint keeps both.
    const std::vector<Eigen::Vector3d>& level_starts() const { return level_starts_; }
    const std::vector<Eigen::Vector3d>& level_shifts() const { return level_shifts_; }
    void restore_levels(std::vector<Eigen::Vector3d> starts, std::vector<Eigen::Vector3d> shifts);
    /// All nodes, and those of a body on the coarsest level.
    const Patch<S>& patch() const { return patch_; }
    const Patch<S>& patch(std::size_t body) const { return *nodes_of_[body]; }
    /// By node: on or within the grid's faces, and moves by itself.
    const std::vector<char>& inside() const { return inside_; }
    /// What the contacts, in the scene's order, have done so far; a checkpoint keeps it.
    ContactReport contact_report(std::size_t contact) const;
    std::map<std::string, double> contact_state(std::size_t contact) const;
    void restore_contact(std::size_t contact, const std::map<std::string, double>& state);
    const std::vector<PlacedContact<S>>& contacts() const { return components_.contacts; }
    /// Memory of all nodes.
    std::size_t node_bytes() const {
        std::size_t bytes = patch_.bytes();
        for (const Patch<S>* layer : layers_) bytes += layer == &patch_ ? 0 : layer->table_bytes();
        return bytes;
    }
    const Material<S>& material(std::size_t body) const { return *components_.materials[body]; }

    long step_number() const override { return number_; }
    void project(typename Phases<S>::Projection projection) override;
    void accelerate(Real dt, Real factor) override;
    void remap() override;
    void update(typename Phases<S>::Update update, Real dt) override;

  private:
    class BatchUpdate;
    class GridVelocity;
    /// Counts the time of its life to a phase.
    class Timer;

    void scatter(const Scatter& request);
    /// Whether particles extend their velocity to the nodes' places in this momentum.
    bool extends(NodeField momentum) const;
    void extend_to_parents(NodeField momentum);
    void apply_loads();
    /// Momentum to velocity, zero where there is hardly any mass; then walls.
    void finish_velocity(NodeField field, const PathMean& mean);
    void resample(NodeField velocity, const PathMean& mean);
    /// Makes a velocity of the lumped mass matrix one of as many terms as the transfer wants.
    void add_terms(NodeField velocity, const PathMean& mean);
    bool has_terms() const { return components_.transfer->order() > 1; }
    void follow_light_nodes(Real share);
    void add_load_work(Real dt, Real factor);
    /// J, of a force (N, `force(c)` its component c by node) in the step whose acceleration is done. Folding
    /// is the transpose of filling, so the nodes within see all of it.
    template <class Force>
    double node_work(Real dt, const Force& force) {
        node_sums_.assign(static_cast<std::size_t>(node_tasks()), 0.0);
        for_nodes([&](Index task, Index begin, Index end) {
            for (int c = 0; c < S::dimension; ++c) {
                const Real* a = patch_.column(NodeField::acceleration, c);
                const Real* v = patch_.column(NodeField::velocity, c);
                const Real* f = force(c);
                double sum = 0;
                for (Index i = begin; i < end; ++i)
                    if (inside_[static_cast<std::size_t>(i)])
                        sum += static_cast<double>(f[i] * (v[i] - a[i] * dt / 2));
                node_sums_[static_cast<std::size_t>(task)] += sum;
            }
        });
        double work = 0;
        for (const double sum : node_sums_) work += sum * dt_;
        return work;
    }
    /// How far the nodes' forces are from balance, of which `factor` was taken.
    void measure_balance(Real factor);
    /// Adds what the damping slows the nodes down by to their acceleration, with which light nodes follow
    /// already: in balance their own forces aren't 0.
    void damp(Real dt);
    void add_damping_work(Real dt);
    /// Whether a node's motion along an axis follows from forces: on or within the grid, and not prescribed.
    bool moves_freely(Index node, int axis) const {
        const auto i = static_cast<std::size_t>(node);
        return inside_[i] && (walls_.prescribed_components()[i] >> axis & 1) == 0;
    }
    /// Brings all particles to a halt.
    void stop();
    void make_layers();
    /// That a body has nodes on at a place: beside a border a particle may still be of either level.
    int level_at(std::size_t body, const typename S::Position& x) const;
    /// Brings levels that follow a body or tool to where that is.
    void move_levels();
    Eigen::Vector3d place_of(const Follow& follow) const;
    /// What a body's particles of a level see.
    Patch<S>& nodes(std::size_t body, int level) const {
        return *nodes_of_[static_cast<std::size_t>(level) * bodies_.size() + body];
    }
    void make_blocks();
    /// Finds where bodies meet, by the mass of the nodes.
    void meet();
    /// By share of a node where bodies meet, m/s: its velocity, of this field.
    void read_meeting(NodeField field);
    void separate(NodeField velocity);
    /// What separate() has changed of the nodes' own velocities, before forces act on them.
    void rejoin();
    void add_contact_forces(Real dt);
    void act_with_tools();
    void add_contact_work(Real dt);
    /// Puts particles back that are beyond closed faces by hardly more than nothing.
    void hold_at_walls();
    void add_reactions(NodeField source, NodeField value, double share, const PathMean& mean);
    /// What conditions gave, N s and J if `share` is 1.
    void add_reactions(const std::vector<typename Walls<S>::Sum>& sums, double share);
    /// What the unilateral faces have pushed with in the step.
    void add_pushes(Real dt);
    static constexpr Index nodes_per_task = 8192;
    Index node_tasks() const { return (patch_.node_count() + nodes_per_task - 1) / nodes_per_task; }
    /// body(task, begin, end) of each task over nodes [begin, end).
    template <class Body>
    void for_nodes(const Body& body) const {
        const auto blocks = static_cast<Index>(patch_.blocks_by_place().size());
        parallel_for(node_tasks(), S::dimension * blocks, [&](Index k) {
            body(k, k * nodes_per_task, std::min(patch_.node_count(), (k + 1) * nodes_per_task));
        });
    }
    void collect(typename Phases<S>::Update what);
    const ArtificialViscosity* viscosity(std::size_t body) const {
        const auto& all = components_.viscosities;
        return body < all.size() && all[body] ? &*all[body] : nullptr;
    }
    void find_stiff_without_waves();

    Components<S> components_;
    std::vector<Particles<S>>& bodies_;
    std::vector<int> first_states_;
    Levels<S>& levels_;
    Patch<S>& patch_;
    Ordering<S> ordering_;
    Walls<S> walls_;
    LevelBorders<S> borders_;
    Ties<S> ties_;
    UnilateralFaces<S> unilateral_;
    HeldParts<S> held_parts_;
    LightNodes<S> light_nodes_;
    std::deque<Patch<S>> further_layers_;
    /// Of the nodes: by level, then by layer of contact; and by level, then by body.
    std::vector<Patch<S>*> layers_, nodes_of_;
    std::vector<Eigen::Vector3d> level_starts_, level_shifts_;  ///< m, by level from 1 on: of what it follows
    std::optional<ContactPairs<S>> pairs_;                      ///< if bodies have velocities of their own
    std::vector<typename ToolContext<S>::Push> pushes_;         ///< by tools, in this step
    std::vector<typename S::Position> start_, meeting_;         ///< by share of a meeting node, m/s
    /// By share of a meeting node: what contact did in the step, and what separate() did until forces act.
    std::vector<typename ContactPairs<S>::Change> change_, separation_;
    bool terms_added_ = false;  ///< whether NodeField::velocity has more terms than it is accelerated with
    bool located_ = false;
    bool off_grid_ = true;  ///< whether a particle may have left the grid
    double largest_mass_ = 0;
    std::vector<char> inside_;  ///< by node: on or within the grid's faces, and moves by itself
    const std::function<int(std::size_t, const typename S::Position&)> level_at_ =
        [this](std::size_t body, const typename S::Position& x) { return level_at(body, x); };
    const std::function<std::span<const NodePart<Real>>(int)> parents_of_ = [this](int node) {
        return borders_.parents(node);
    };
    std::array<double, 3> load_force_{};  ///< N, sum of the external forces
    std::vector<Real> damping_force_;     ///< N, by component, then by node
    std::vector<double> node_sums_;       ///< by task over nodes
    std::vector<Partial> partials_;       ///< by task over particles
    PhaseSeconds seconds_{};

    long number_ = 0;
    double time_ = 0, dt_ = 0;
    /// Of the nodal velocities before and after accelerate(): means of the last step and of this one.
    PathMean velocity_from_{0}, velocity_to_{0};
    Tally tally_;
    std::vector<char> held_;  ///< by boundary condition
    std::vector<Fault> faults_;
};

}  // namespace matpoint
