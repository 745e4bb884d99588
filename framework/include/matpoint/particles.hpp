#pragma once

#include <matpoint/columns.hpp>
#include <matpoint/space.hpp>
#include <matpoint/tensor.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace matpoint {

/// Particle fields that the kernel knows. The first five always exist, the others when a component
/// of the scene asks for them.
enum class Field {
    position,      ///< x, m; one component per dimension
    velocity,      ///< v, m/s
    mass,          ///< m, kg (of the whole ring when axisymmetric; per unit width in 1D and plane strain)
    volume,        ///< V, m^3 (likewise)
    stress,        ///< Cauchy stress, Pa; components as Space::stress_size says
    total_stress,  ///< the stress less an artificial pressure, in bodies that have one, Pa; likewise
    displacement_gradient,   ///< H = F - I; components as Space::deformation_size says
    velocity_gradient,       ///< L = dv/dx of the last stress update, 1/s; in-plane components by column
    affine_velocity,         ///< C of the affine transfer, 1/s; likewise
    grid_velocity_gradient,  ///< what of L is taken back in the next step, by integrators that lag; as H
    grid_velocity,           ///< what transfers of higher order read of the nodes and send again, m/s
    half_size,               ///< half-lengths of the particle's domain at the start of the step, m
    initial_half_size,       ///< the same at the start of the run
    initial_position,        ///< X, m
    // What single precision has rounded away; double precision has no such fields.
    position_remainder,          ///< to be added to it
    initial_position_remainder,  ///< likewise
    volume_remainder,            ///< likewise
    velocity_remainder,          ///< of what a transfer has added to the velocity; it adds it the next time
    id,                          ///< number given at seeding, from 0 in each body
};
inline constexpr int known_fields = static_cast<int>(Field::id) + 1;

/// The field that holds what single precision rounds away of another one, and belongs to its value.
constexpr std::optional<Field> remainder_of(Field field) {
    switch (field) {
        case Field::position:
            return Field::position_remainder;
        case Field::initial_position:
            return Field::initial_position_remainder;
        case Field::volume:
            return Field::volume_remainder;
        default:
            return {};
    }
}

std::string_view field_name(Field field);
std::optional<Field> field_from_name(std::string_view name);

/// A material's own variable, one number a particle.
struct StateVariable {
    std::string name;  ///< for outputs, "plastic_strain"
    double initial = 0;
    std::string unit{};
};

/// A particle and its new place, which another one leaves.
struct Exchange {
    std::uint32_t from, to;
};

/// The particles of one body: a column of numbers per component of every field that somebody asked
/// for. The kernel keeps them sorted by the block of the grid that they are in.
template <class S>
class Particles {
  public:
    using Real = typename S::Real;

    explicit Particles(std::string body);

    const std::string& body() const { return body_; }
    Index size() const { return size_; }

    /// Asks for a field (before particles exist). Asking twice is the same as asking once. In single
    /// precision positions and volumes come with their remainders.
    void require(Field field);
    /// Adds a field of a component's own, by a name no other component uses; returns its slot.
    int require(const std::string& name, int components, double initial = 0);
    /// Particles for which this field is not 0 stand for something as a whole, as an area that a load acts
    /// on: they are not split.
    void keep_whole(int slot) { whole_.push_back(slot); }
    bool divisible(Index p) const {
        for (const int slot : whole_)
            for (int c = 0; c < components(slot); ++c)
                if (column(slot, c)[p] != Real(0)) return false;
        return true;
    }
    bool has(Field field) const {
        return field == Field::id ? has_ids_ : slots_[static_cast<std::size_t>(field)] >= 0;
    }
    int slot(Field field) const { return slots_[static_cast<std::size_t>(field)]; }
    int slot(std::string_view name) const;  ///< -1 if there is no such field
    int components(int slot) const { return fields_[static_cast<std::size_t>(slot)].components; }
    const std::string& name(int slot) const { return fields_[static_cast<std::size_t>(slot)].name; }
    int field_count() const { return static_cast<int>(fields_.size()); }

    /// Where the columns of a field begin, by component.
    Real* const* columns(int slot) const {
        return columns_.starts() + fields_[static_cast<std::size_t>(slot)].first;
    }
    Real* const* columns(Field field) const {
        return columns_.starts() + first_columns_[static_cast<std::size_t>(field)];
    }
    Real* column(int slot, int component) { return columns(slot)[component]; }
    const Real* column(int slot, int component) const { return columns(slot)[component]; }
    Real* column(Field field, int component = 0) { return columns(field)[component]; }
    const Real* column(Field field, int component = 0) const { return columns(field)[component]; }
    /// Numbers given at seeding; empty unless Field::id was asked for.
    std::vector<std::uint32_t>& ids() { return ids_; }
    const std::vector<std::uint32_t>& ids() const { return ids_; }

    /// A number of a field with its remainder, if it has one.
    double value(Field field, int component, Index p) const {
        auto value = static_cast<double>(column(field, component)[p]);
        if (const auto rest = carried_remainder(field))
            value += static_cast<double>(column(*rest, component)[p]);
        return value;
    }
    void set_value(Field field, int component, Index p, double value) {
        const Real rounded = column(field, component)[p] = static_cast<Real>(value);
        if (const auto rest = carried_remainder(field))
            column(*rest, component)[p] = static_cast<Real>(value - static_cast<double>(rounded));
    }
    /// x, or another field of positions.
    typename S::Position position(Index p, Field field = Field::position) const {
        typename S::Position x;
        for (int a = 0; a < S::dimension; ++a) x[a] = value(field, a, p);
        return x;
    }
    typename S::Vector velocity(Index p) const { return vector(Field::velocity, p); }
    typename S::Vector vector(Field field, Index p) const {
        typename S::Vector v;
        for (int a = 0; a < S::dimension; ++a) v[a] = column(field, a)[p];
        return v;
    }

    /// All columns get `n` entries; new ones hold the field's initial value.
    void resize(Index n);
    /// Puts particle order[k] at place k. `order` may be shorter than size(): the rest is dropped.
    void permute(std::span<const std::uint32_t> order);
    /// Puts particles in each other's places, which are counted from `begin` on. Threads may do so at once
    /// with particles of their own.
    void exchange(Index begin, std::span<const Exchange> exchanges);
    std::size_t bytes_per_particle() const;

  private:
    struct FieldInfo {
        std::string name;
        int components;
        int first;
        std::vector<double> initial;
    };
    int add(std::string name, std::vector<double> initial);
    std::optional<Field> carried_remainder(Field field) const {
        if constexpr (!S::single) return {};
        const auto rest = remainder_of(field);
        return rest && has(*rest) ? rest : std::nullopt;
    }
    int column_count() const {
        return fields_.empty() ? 0 : fields_.back().first + fields_.back().components;
    }

    std::string body_;
    Index size_ = 0;
    std::vector<FieldInfo> fields_;
    std::vector<int> whole_;  ///< slots
    std::array<int, known_fields> slots_, first_columns_;
    Columns<Real> columns_{1};
    std::vector<std::uint32_t> ids_;
    bool has_ids_ = false;
};

/// The least position that the columns of Field::position may hold as x, rounded in single precision.
template <class S>
typename S::Position lowest_position(const typename S::Vector& x) {
    typename S::Position lowest = x.template cast<double>();
    if constexpr (S::single) lowest -= std::numeric_limits<typename S::Real>::epsilon() * lowest.cwiseAbs();
    return lowest;
}
template <class S>
typename S::Position highest_position(const typename S::Vector& x) {
    return -lowest_position<S>(-x);
}

/// Most particles in a batch: its columns stay in the first-level cache.
inline constexpr int batch_size = 64;
/// Batches hold a multiple of these, if no fewer are left: whole Packs of any width.
inline constexpr int batch_multiple = 8;

/// What was read from the nodes for the particles of one batch; [component][particle of the batch].
template <class S>
struct Gathered {
    using Real = typename S::Real;
    template <int N>
    using Columns = std::array<std::array<Real, batch_size>, static_cast<std::size_t>(N)>;

    Columns<S::dimension> velocity;                  ///< sum S v, m/s
    Columns<S::dimension> acceleration;              ///< sum S a, m/s^2
    Columns<S::deformation_size> velocity_gradient;  ///< sum v (x) grad S, by column, then v_r / r; 1/s
    Columns<S::dimension * S::dimension> affine;     ///< sum S v (x) (x_i - x_p) D^-1, by column; 1/s

    /// Moves what was read for the particles from `place` on, fewer than batch_multiple, to the front.
    void keep_from(int place) {
        const auto keep = [&](auto& columns) {
            for (auto& column : columns) std::copy_n(column.begin() + place, batch_multiple, column.begin());
        };
        keep(velocity), keep(acceleration), keep(velocity_gradient), keep(affine);
    }
};

/// Consecutive particles of one body, handed to a component in one virtual call.
template <class S>
class ParticleBatch {
  public:
    using Real = typename S::Real;

    ParticleBatch(Particles<S>& particles, Index begin, Index end, const Gathered<S>& gathered,
                  int first_state)
        : particles_(&particles), begin_(begin), end_(end), gathered_(&gathered), first_state_(first_state) {}

    Index begin() const { return begin_; }
    Index end() const { return end_; }
    Particles<S>& particles() const { return *particles_; }
    const Gathered<S>& gathered() const { return *gathered_; }
    /// Slot of the first of Material::state().
    int first_state() const { return first_state_; }

    Real mass(Index p) const { return particles_->column(Field::mass)[p]; }
    Real volume(Index p) const { return particles_->column(Field::volume)[p]; }
    Real density(Index p) const { return mass(p) / volume(p); }

    /// F at the end of the step (the material must ask for it: Material::uses_deformation_gradient).
    Tensor<S> deformation_gradient(Index p) const { return load_deformation_gradient(*particles_, p); }
    /// H = F - I, exact where F is I but for rounding.
    Tensor<S> displacement_gradient(Index p) const { return load_displacement_gradient(*particles_, p); }
    /// L of the step.
    Tensor<S> velocity_gradient(Index p) const {
        Tensor<S> t;
        const auto i = static_cast<std::size_t>(p - begin_);
        for (int c = 0; c < S::dimension * S::dimension; ++c)
            t.plane.data()[c] = gathered_->velocity_gradient[static_cast<std::size_t>(c)][i];
        if constexpr (S::axisymmetric)
            t.normal = gathered_->velocity_gradient[S::dimension * S::dimension][i];
        return t;
    }
    Tensor<S> stress(Index p) const { return load_stress(*particles_, p); }
    void set_stress(Index p, const Tensor<S>& t) const { store_stress(*particles_, p, t); }
    /// The k-th of Material::state(), at particle p.
    Real& state(int k, Index p) const { return particles_->column(first_state_ + k, 0)[p]; }

    static Tensor<S> load_deformation_gradient(const Particles<S>& particles, Index p) {
        return Tensor<S>::identity() + load_displacement_gradient(particles, p);
    }
    static Tensor<S> load_displacement_gradient(const Particles<S>& particles, Index p) {
        Tensor<S> t;
        for (int c = 0; c < S::dimension * S::dimension; ++c)
            t.plane.data()[c] = particles.column(Field::displacement_gradient, c)[p];
        if constexpr (S::axisymmetric)
            t.normal = particles.column(Field::displacement_gradient, S::dimension * S::dimension)[p];
        return t;
    }
    static void store_displacement_gradient(Particles<S>& particles, Index p, const Tensor<S>& t) {
        for (int c = 0; c < S::dimension * S::dimension; ++c)
            particles.column(Field::displacement_gradient, c)[p] = t.plane.data()[c];
        if constexpr (S::axisymmetric)
            particles.column(Field::displacement_gradient, S::dimension * S::dimension)[p] = t.normal;
    }
    static Tensor<S> load_stress(const Particles<S>& particles, Index p, Field field = Field::stress) {
        const auto s = [&](int c) { return particles.column(field, c)[p]; };
        Tensor<S> t;
        if constexpr (S::dimension == 1) {
            t.plane << s(0);
        } else if constexpr (S::dimension == 2) {
            t.plane << s(0), s(3), s(3), s(1);
            t.normal = s(2);
        } else {
            t.plane << s(0), s(3), s(5), s(3), s(1), s(4), s(5), s(4), s(2);
        }
        return t;
    }
    static void store_stress(Particles<S>& particles, Index p, const Tensor<S>& t,
                             Field field = Field::stress) {
        const auto set = [&](int c, Real value) { particles.column(field, c)[p] = value; };
        set(0, t.plane(0, 0));
        if constexpr (S::dimension == 2) {
            set(1, t.plane(1, 1));
            set(2, t.normal);
            set(3, t.plane(0, 1));
        } else if constexpr (S::dimension == 3) {
            set(1, t.plane(1, 1));
            set(2, t.plane(2, 2));
            set(3, t.plane(0, 1));
            set(4, t.plane(1, 2));
            set(5, t.plane(0, 2));
        }
    }

  private:
    Particles<S>* particles_;
    Index begin_, end_;
    const Gathered<S>* gathered_;
    int first_state_;
};

}  // namespace matpoint
