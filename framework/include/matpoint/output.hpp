#pragma once

#include <matpoint/contact_report.hpp>
#include <matpoint/registry.hpp>
#include <matpoint/surface_mesh.hpp>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace matpoint {

/// Energies of the whole scene, J.
struct Energies {
    double kinetic = 0;
    double strain = 0;    ///< work done by the stress since the start (stored and dissipated)
    double external = 0;  ///< work done by loads and moving boundaries since the start
    double damped = 0;    ///< taken out by damping since the start
    double contact = 0;   ///< taken out where bodies meet since the start
    double total() const { return kinetic + strain + damped + contact - external; }
};

/// What outputs and checks may see of a run, whatever its space.
class RunView {
  public:
    virtual std::string title() const = 0;
    virtual double time() const = 0;  ///< s
    virtual long step() const = 0;
    virtual double time_step() const = 0;
    virtual SpaceId space() const = 0;

    virtual std::vector<std::string> bodies() const = 0;
    virtual std::size_t particle_count(const std::string& body) const = 0;
    /// Names of the fields that particles of the body carry, and those computed when asked for:
    /// "displacement", "deformation_gradient", "density", "pressure", "von_mises_stress", "kinetic_energy".
    virtual std::vector<std::string> fields(const std::string& body) const = 0;
    virtual int components(const std::string& body, const std::string& field) const = 0;
    /// A component of a field for all particles of a body in the order of their seeding (by id).
    virtual std::vector<double> column(const std::string& body, const std::string& field,
                                       int component) const = 0;

    virtual Energies energies() const = 0;
    virtual double mass() const = 0;                     ///< kg
    virtual std::array<double, 3> momentum() const = 0;  ///< kg m/s
    /// Force of a named boundary condition on the bodies in the last step, N.
    virtual std::array<double, 3> reaction(const std::string& boundary_condition) const = 0;
    /// Names of the contacts, and what one of them has done.
    virtual std::vector<std::string> contacts() const = 0;
    virtual ContactReport contact(const std::string& name) const = 0;
    /// The surface of a tool on the grid, as it is now; of bodies' contact, nothing.
    virtual SurfaceMesh tool_surface(const std::string& contact) const = 0;

    /// How far the last step was from equilibrium: sum |f| of the nodes over that of the forces which should
    /// be in balance, the internal or the external ones, whichever are larger; components that boundary
    /// conditions prescribe have none. Measured if the scene has `damping`, `until_at_rest` or an output that
    /// asks for it (Output::observes_balance).
    virtual double unbalanced_force() const = 0;
    /// Share of the particles' velocity that the grid's at their places lacks after the last step:
    /// sqrt(sum m |v_p - sum S v*|^2 / sum m |v_p|^2).
    virtual double noise() const = 0;

  protected:
    ~RunView() = default;
};

/// Something that observes a run and writes files. The kernel calls write() when it is due, and flush()
/// before each checkpoint, so that a run that goes on from there lacks no file, and at the end of the run.
class Output : public Component {
  public:
    /// Fields beyond the ones that the scene carries anyway, as names of RunView::fields.
    virtual std::vector<std::string> required_fields() const { return {}; }
    /// Body whose fields are required; empty for all.
    virtual std::string body() const { return {}; }
    /// Whether it reads RunView::unbalanced_force.
    virtual bool observes_balance() const { return false; }
    /// Called once when the bodies are seeded, at a restart too. Throws std::exception with the reason if
    /// the scene lacks what the output observes; nothing is written yet.
    virtual void check(const RunView&) {}
    /// Before the first step. `resumed_at` is the time (s) of the checkpoint that is being continued,
    /// below zero for a fresh run: what was written after it is dropped, what was before is kept.
    virtual void open(const RunView& run, const std::filesystem::path& folder, double resumed_at) = 0;
    /// What can't be written is thrown as std::runtime_error with the reason: here, or, by an output that
    /// writes in the background (<matpoint/background_writer.hpp>), by its next write() or flush().
    virtual void write(const RunView& run) = 0;
    /// Returns when all that was to be written is in its files.
    virtual void flush() {}
};

}  // namespace matpoint
