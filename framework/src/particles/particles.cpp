#include <matpoint/parallel.hpp>
#include <matpoint/particles.hpp>

#include <algorithm>
#include <stdexcept>

namespace matpoint {

namespace {

constexpr std::array<std::string_view, known_fields> names = {"position",
                                                              "velocity",
                                                              "mass",
                                                              "volume",
                                                              "stress",
                                                              "total_stress",
                                                              "displacement_gradient",
                                                              "velocity_gradient",
                                                              "affine_velocity",
                                                              "grid_velocity_gradient",
                                                              "half_size",
                                                              "initial_half_size",
                                                              "initial_position",
                                                              "position_remainder",
                                                              "initial_position_remainder",
                                                              "volume_remainder",
                                                              "velocity_remainder",
                                                              "id"};

template <class S>
std::vector<double> initial_values(Field field) {
    constexpr std::size_t d = S::dimension;
    switch (field) {
        case Field::mass:
        case Field::volume:
        case Field::volume_remainder:
            return {0};
        case Field::stress:
        case Field::total_stress:
            return std::vector<double>(S::stress_size, 0);
        case Field::displacement_gradient:
        case Field::grid_velocity_gradient:
            return std::vector<double>(S::deformation_size, 0);
        case Field::velocity_gradient:
        case Field::affine_velocity:
            return std::vector<double>(d * d, 0);
        default:
            return std::vector<double>(d, 0);
    }
}

bool is_remainder(Field field) {
    return field >= Field::position_remainder && field <= Field::velocity_remainder;
}

}  // namespace

std::string_view field_name(Field field) {
    return names[static_cast<std::size_t>(field)];
}

std::optional<Field> field_from_name(std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return {};
    return static_cast<Field>(found - names.begin());
}

template <class S>
Particles<S>::Particles(std::string body) : body_(std::move(body)) {
    slots_.fill(-1);
    first_columns_.fill(0);
    for (const Field field : {Field::position, Field::velocity, Field::mass, Field::volume, Field::stress})
        require(field);
}

template <class S>
void Particles<S>::require(Field field) {
    if (field == Field::id) {
        has_ids_ = true;
        return;
    }
    const auto i = static_cast<std::size_t>(field);
    if (slots_[i] >= 0 || (is_remainder(field) && !S::single)) return;
    slots_[i] = add(std::string(field_name(field)), initial_values<S>(field));
    first_columns_[i] = fields_.back().first;
    if (const auto rest = remainder_of(field)) require(*rest);
}

template <class S>
int Particles<S>::require(const std::string& name, int components, double initial) {
    const int found = slot(name);
    if (found >= 0) {
        if (this->components(found) != components)
            throw std::logic_error("particle field \"" + name +
                                   "\" was asked for with different numbers of components");
        return found;
    }
    return add(name, std::vector<double>(static_cast<std::size_t>(components), initial));
}

template <class S>
int Particles<S>::add(std::string name, std::vector<double> initial) {
    if (size_ > 0) throw std::logic_error("particle field \"" + name + "\" was asked for after seeding");
    const int components = static_cast<int>(initial.size());
    fields_.push_back({std::move(name), components, column_count(), std::move(initial)});
    columns_.resize(column_count(), 0);
    return static_cast<int>(fields_.size()) - 1;
}

template <class S>
int Particles<S>::slot(std::string_view name) const {
    for (std::size_t i = 0; i < fields_.size(); ++i)
        if (fields_[i].name == name) return static_cast<int>(i);
    return -1;
}

template <class S>
void Particles<S>::resize(Index n) {
    columns_.resize(column_count(), n);
    for (const FieldInfo& field : fields_)
        for (std::size_t c = 0; c < field.initial.size(); ++c) {
            Real* const column = columns_[static_cast<std::size_t>(field.first) + c];
            const auto initial = static_cast<Real>(field.initial[c]);  // 0 it is already
            if (n > size_ && initial != 0) std::fill(column + size_, column + n, initial);
        }
    if (has_ids_) {
        const std::size_t old = ids_.size();
        ids_.resize(static_cast<std::size_t>(n));
        for (std::size_t p = old; p < ids_.size(); ++p) ids_[p] = static_cast<std::uint32_t>(p);
    }
    size_ = n;
}

template <class S>
void Particles<S>::permute(std::span<const std::uint32_t> order) {
    constexpr Index chunk = 16384;
    const auto count = static_cast<Index>(order.size());
    for (std::size_t c = 0; c < static_cast<std::size_t>(columns_.count()); ++c) {
        const Real* const from = columns_[c];
        Real* const to = columns_.spare();
        parallel_for((count + chunk - 1) / chunk, count, [&](Index task) {
            const auto end = static_cast<std::size_t>(std::min(count, (task + 1) * chunk));
            for (auto k = static_cast<std::size_t>(task * chunk); k < end; ++k) to[k] = from[order[k]];
        });
        columns_.exchange_with_spare(c);
    }
    columns_.release_spare();
    columns_.shorten(count);
    if (has_ids_) {
        std::vector<std::uint32_t> ids(order.size());
        for (std::size_t k = 0; k < order.size(); ++k) ids[k] = ids_[order[k]];
        ids_.swap(ids);
    }
    size_ = static_cast<Index>(order.size());
}

template <class S>
void Particles<S>::exchange(Index begin, std::span<const Exchange> exchanges) {
    const auto exchange_in = [&]<class T>(T* column, std::vector<T>& old) {
        old.resize(exchanges.size());
        for (std::size_t k = 0; k < exchanges.size(); ++k) old[k] = column[exchanges[k].from];
        for (std::size_t k = 0; k < exchanges.size(); ++k) column[exchanges[k].to] = old[k];
    };
    thread_local std::vector<Real> numbers;
    for (std::size_t c = 0; c < static_cast<std::size_t>(columns_.count()); ++c)
        exchange_in(columns_[c] + begin, numbers);
    if (has_ids_) {
        thread_local std::vector<std::uint32_t> ids;
        exchange_in(ids_.data() + begin, ids);
    }
}

template <class S>
std::size_t Particles<S>::bytes_per_particle() const {
    return static_cast<std::size_t>(column_count()) * sizeof(Real) + (has_ids_ ? sizeof(std::uint32_t) : 0);
}

#define MATPOINT_INSTANTIATE(S) template class Particles<S>;
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
