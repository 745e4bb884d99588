#include "run/derived_fields.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace matpoint {

template <class S>
Eigen::Matrix3d full_stress(const Particles<S>& particles, Index p) {
    const Tensor<S> stress = ParticleBatch<S>::load_stress(particles, p);
    Eigen::Matrix3d full = Eigen::Matrix3d::Zero();
    full.topLeftCorner<S::dimension, S::dimension>() = stress.plane.template cast<double>();
    if constexpr (S::has_normal) full(2, 2) = static_cast<double>(stress.normal);
    return full;
}

namespace {

template <class S>
using Value = double (*)(const Particles<S>&, Index, int component);

template <class S>
struct Derived {
    const char* name;
    int components;
    Value<S> value;
};

template <class S>
const std::vector<Derived<S>>& derived_fields() {
    static const std::vector<Derived<S>> all = {
        {"displacement", S::dimension,
         [](const Particles<S>& particles, Index p, int c) {
             return particles.value(Field::position, c, p) - particles.value(Field::initial_position, c, p);
         }},
        {"deformation_gradient", S::deformation_size,
         [](const Particles<S>& particles, Index p, int c) {
             const bool diagonal = c % (S::dimension + 1) == 0 || c == S::dimension * S::dimension;
             return particles.value(Field::displacement_gradient, c, p) + (diagonal ? 1 : 0);
         }},
        {"density", 1,
         [](const Particles<S>& particles, Index p, int) {
             return particles.value(Field::mass, 0, p) / particles.value(Field::volume, 0, p);
         }},
        {"pressure", 1,
         [](const Particles<S>& particles, Index p, int) { return -full_stress(particles, p).trace() / 3; }},
        {"von_mises_stress", 1,
         [](const Particles<S>& particles, Index p, int) {
             const Eigen::Matrix3d s = full_stress(particles, p);
             const Eigen::Matrix3d deviator = s - s.trace() / 3 * Eigen::Matrix3d::Identity();
             return std::sqrt(1.5) * deviator.norm();
         }},
        {"kinetic_energy", 1,
         [](const Particles<S>& particles, Index p, int) {
             return static_cast<double>(particles.column(Field::mass)[p] *
                                        particles.velocity(p).squaredNorm()) /
                    2;
         }},
    };
    return all;
}

template <class S>
const Derived<S>* find_derived(const Particles<S>& particles, const std::string& name) {
    for (const Derived<S>& derived : derived_fields<S>()) {
        if (name != derived.name) continue;
        const auto needed = field_behind(name);
        return needed && !particles.has(*needed) ? nullptr : &derived;
    }
    return nullptr;
}

/// Where each particle stands in the order of ids; ids may have gaps where particles were deleted.
template <class S>
class PlacesById {
  public:
    explicit PlacesById(const Particles<S>& particles) {
        if (!particles.has(Field::id)) return;
        ids_ = particles.ids().data();
        std::uint32_t largest = 0;
        for (const std::uint32_t id : particles.ids()) largest = std::max(largest, id);
        if (particles.size() == Index{largest} + 1) return;
        ranks_.assign(std::size_t{largest} + 1, 0);
        for (const std::uint32_t id : particles.ids()) ranks_[id] = 1;
        std::exclusive_scan(ranks_.begin(), ranks_.end(), ranks_.begin(), std::uint32_t{0});
    }
    std::size_t operator[](Index p) const {
        if (!ids_) return static_cast<std::size_t>(p);
        return ranks_.empty() ? ids_[p] : ranks_[ids_[p]];
    }

  private:
    const std::uint32_t* ids_ = nullptr;
    std::vector<std::uint32_t> ranks_;  ///< by id; none if there are no gaps
};

}  // namespace

std::optional<Field> field_behind(const std::string& name) {
    if (name == "displacement") return Field::initial_position;
    if (name == "deformation_gradient") return Field::displacement_gradient;
    const auto field = field_from_name(name);
    return field == Field::total_stress ? std::nullopt : field;  // bodies have it that need it
}

template <class S>
std::vector<std::string> field_names(const Particles<S>& particles) {
    std::vector<std::string> names;
    for (int slot = 0; slot < particles.field_count(); ++slot) names.push_back(particles.name(slot));
    if (particles.has(Field::id)) names.emplace_back("id");
    for (const Derived<S>& derived : derived_fields<S>())
        if (find_derived(particles, derived.name)) names.emplace_back(derived.name);
    return names;
}

template <class S>
int field_components(const Particles<S>& particles, const std::string& field) {
    if (const int slot = particles.slot(field); slot >= 0) return particles.components(slot);
    if (field == "id") return particles.has(Field::id) ? 1 : 0;
    const Derived<S>* derived = find_derived(particles, field);
    return derived ? derived->components : 0;
}

template <class S>
std::vector<double> field_column(const Particles<S>& particles, const std::string& field, int component) {
    const PlacesById<S> places(particles);
    const Index n = particles.size();
    std::vector<double> values(static_cast<std::size_t>(n));
    if (const int slot = particles.slot(field); slot >= 0) {
        const auto known = field_from_name(field);
        const auto* column = particles.column(slot, component);
        for (Index p = 0; p < n; ++p)
            values[places[p]] =
                known ? particles.value(*known, component, p) : static_cast<double>(column[p]);
    } else if (field == "id") {
        for (Index p = 0; p < n; ++p) values[places[p]] = particles.ids()[static_cast<std::size_t>(p)];
    } else if (const Derived<S>* derived = find_derived(particles, field)) {
        for (Index p = 0; p < n; ++p) values[places[p]] = derived->value(particles, p, component);
    }
    return values;
}

#define MATPOINT_INSTANTIATE(S)                                             \
    template std::vector<std::string> field_names(const Particles<S>&);     \
    template Eigen::Matrix3d full_stress(const Particles<S>&, Index);       \
    template int field_components(const Particles<S>&, const std::string&); \
    template std::vector<double> field_column(const Particles<S>&, const std::string&, int);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
