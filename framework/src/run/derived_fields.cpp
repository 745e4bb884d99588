#include "run/derived_fields.hpp"

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
             return static_cast<double>(particles.column(Field::position, c)[p] -
                                        particles.column(Field::initial_position, c)[p]);
         }},
        {"density", 1,
         [](const Particles<S>& particles, Index p, int) {
             return static_cast<double>(particles.column(Field::mass)[p] /
                                        particles.column(Field::volume)[p]);
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

}  // namespace

std::optional<Field> field_behind(const std::string& name) {
    if (name == "displacement") return Field::initial_position;
    return field_from_name(name);
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
    const auto n = static_cast<std::size_t>(particles.size());
    // Ids may have gaps where particles were deleted: ranks, not the ids themselves, are the places.
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (particles.has(Field::id)) {
        const auto& ids = particles.ids();
        std::vector<std::size_t> by_id;
        for (std::size_t p = 0; p < n; ++p) {
            if (ids[p] >= by_id.size()) by_id.resize(ids[p] + std::size_t{1}, n);
            by_id[ids[p]] = p;
        }
        order.clear();
        for (const std::size_t p : by_id)
            if (p < n) order.push_back(p);
    }

    std::vector<double> values(n);
    if (const int slot = particles.slot(field); slot >= 0) {
        const auto* column = particles.column(slot, component);
        for (std::size_t k = 0; k < n; ++k) values[k] = static_cast<double>(column[order[k]]);
    } else if (field == "id") {
        for (std::size_t k = 0; k < n; ++k) values[k] = particles.ids()[order[k]];
    } else if (const Derived<S>* derived = find_derived(particles, field)) {
        for (std::size_t k = 0; k < n; ++k)
            values[k] = derived->value(particles, static_cast<Index>(order[k]), component);
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
