#pragma once

#include <matpoint/particles.hpp>
#include <matpoint/tensor.hpp>

#include <algorithm>
#include <array>

namespace matpoint {

/// As many particles of a batch as a Pack has lanes, seen as one. The batch's last ones may be fewer (not
/// `whole`): then the lanes beyond repeat the first, and are not stored.
template <class S, bool whole>
class ParticlePack {
  public:
    using Real = typename S::Real;
    using Number = Pack<Real>;

    /// The particles of `batch` from place `at` on.
    ParticlePack(const ParticleBatch<S>& batch, int at)
        : batch_(&batch),
          at_(at),
          count_(whole ? Number::lanes : static_cast<int>(batch.end() - batch.begin()) - at) {}

    int at() const { return at_; }
    int count() const { return count_; }

    MATPOINT_INLINE Number load(const Real* column) const {
        return load_from(column + batch_->begin() + at_);
    }
    /// Of a column of Gathered.
    MATPOINT_INLINE Number load(const std::array<Real, batch_size>& column) const {
        return load_from(column.data() + at_);
    }
    MATPOINT_INLINE void store(Real* column, Number a) const {
        Real* const to = column + batch_->begin() + at_;
        if constexpr (whole) return a.store(to);
        std::array<Real, Number::lanes> lanes;
        a.store(lanes.data());
        std::copy_n(lanes.begin(), count_, to);
    }
    /// 0 in lanes beyond the batch.
    template <class T>
    MATPOINT_INLINE Pack<T, Number::lanes> mine(Pack<T, Number::lanes> a) const {
        if constexpr (whole) return a;
        return head(a, count_, Pack<T, Number::lanes>(0));
    }
    MATPOINT_INLINE Number load(Field field, int component = 0) const {
        return load(columns(field)[component]);
    }
    MATPOINT_INLINE void store(Field field, int component, Number a) const {
        store(columns(field)[component], a);
    }
    /// Adds to a number that may be far greater, and returns the sum. What single precision rounds away stays
    /// in the field's remainder and is added the next time [Kahan 1965].
    template <Field field>
    MATPOINT_INLINE Number add(int component, Number increment) const {
        Real* const column = columns(field)[component];
        const Number before = load(column);
        if constexpr (S::single) {
            Real* const remainders = columns(*remainder_of(field))[component];
            increment += load(remainders);
            store(remainders, increment - ((before + increment) - before));
        }
        const Number sum = before + increment;
        store(column, sum);
        return sum;
    }
    /// Where the columns of a field begin.
    MATPOINT_INLINE Real* const* columns(Field field) const { return particles().columns(field); }

    MATPOINT_INLINE Number mass() const { return load(Field::mass); }
    MATPOINT_INLINE Number volume() const { return load(Field::volume); }
    MATPOINT_INLINE Number density() const { return mass() / volume(); }
    /// F at the end of the step (the material must ask for it: Material::uses_deformation_gradient).
    MATPOINT_INLINE Tensor<S, Number> deformation_gradient() const {
        Tensor<S, Number> t = displacement_gradient();
        for (int a = 0; a < S::dimension; ++a) t.plane(a, a) += Number(1);
        if constexpr (S::has_normal) t.normal += Number(1);
        return t;
    }
    /// H = F - I, in which a small strain keeps all its digits: volume_change, squared_strain.
    MATPOINT_INLINE Tensor<S, Number> displacement_gradient() const {
        Real* const* const h = columns(Field::displacement_gradient);
        Tensor<S, Number> t;
        for (int c = 0; c < plane_size; ++c) t.plane.data()[c] = load(h[c]);
        if constexpr (S::axisymmetric)
            t.normal = load(h[plane_size]);
        else if constexpr (S::has_normal)
            t.normal = Number(0);
        return t;
    }
    MATPOINT_INLINE void set_displacement_gradient(const Tensor<S, Number>& t) const {
        Real* const* const h = columns(Field::displacement_gradient);
        for (int c = 0; c < plane_size; ++c) store(h[c], t.plane.data()[c]);
        if constexpr (S::axisymmetric) store(h[plane_size], t.normal);
    }
    /// L of the step.
    MATPOINT_INLINE Tensor<S, Number> velocity_gradient() const {
        Tensor<S, Number> t;
        const auto& columns = batch_->gathered().velocity_gradient;
        for (int c = 0; c < plane_size; ++c) t.plane.data()[c] = load(columns[static_cast<std::size_t>(c)]);
        if constexpr (S::axisymmetric) t.normal = load(columns[plane_size]);
        return t;
    }
    MATPOINT_INLINE Tensor<S, Number> stress(Field field = Field::stress) const {
        Real* const* const columns_of_stress = columns(field);
        const auto s = [&](int c) { return load(columns_of_stress[c]); };
        Tensor<S, Number> t;
        if constexpr (d == 1) {
            t.plane(0, 0) = s(0);
        } else if constexpr (d == 2) {
            t.plane(0, 0) = s(0);
            t.plane(1, 1) = s(1);
            t.plane(0, 1) = t.plane(1, 0) = s(3);
            t.normal = s(2);
        } else {
            for (int a = 0; a < 3; ++a) t.plane(a, a) = s(a);
            t.plane(0, 1) = t.plane(1, 0) = s(3);
            t.plane(1, 2) = t.plane(2, 1) = s(4);
            t.plane(0, 2) = t.plane(2, 0) = s(5);
        }
        return t;
    }
    MATPOINT_INLINE void set_stress(const Tensor<S, Number>& t, Field field = Field::stress) const {
        Real* const* const s = columns(field);
        store(s[0], t.plane(0, 0));
        if constexpr (d == 2) {
            store(s[1], t.plane(1, 1));
            store(s[2], t.normal);
            store(s[3], t.plane(0, 1));
        } else if constexpr (d == 3) {
            store(s[1], t.plane(1, 1));
            store(s[2], t.plane(2, 2));
            store(s[3], t.plane(0, 1));
            store(s[4], t.plane(1, 2));
            store(s[5], t.plane(0, 2));
        }
    }
    /// The k-th of Material::state().
    MATPOINT_INLINE Number state(int k) const {
        return load(particles().column(batch_->first_state() + k, 0));
    }
    MATPOINT_INLINE void set_state(int k, Number a) const {
        store(particles().column(batch_->first_state() + k, 0), a);
    }

  private:
    static constexpr int d = S::dimension, plane_size = d * d;
    Particles<S>& particles() const { return batch_->particles(); }
    MATPOINT_INLINE Number load_from(const Real* from) const {
        if constexpr (whole) return Number::load(from);
        std::array<Real, Number::lanes> lanes;
        for (int i = 0; i < Number::lanes; ++i) lanes[static_cast<std::size_t>(i)] = from[i < count_ ? i : 0];
        return Number::load(lanes.data());
    }
    const ParticleBatch<S>* batch_;
    int at_, count_;
};

/// Calls visit(pack) for all packs of a batch.
template <class S, class Visit>
MATPOINT_INLINE void visit_packs(const ParticleBatch<S>& batch, const Visit& visit) {
    constexpr int lanes = ParticlePack<S, true>::Number::lanes;
    const auto count = static_cast<int>(batch.end() - batch.begin());
    int at = 0;
    for (; at + lanes <= count; at += lanes) visit(ParticlePack<S, true>(batch, at));
    if (at < count) visit(ParticlePack<S, false>(batch, at));
}

}  // namespace matpoint
