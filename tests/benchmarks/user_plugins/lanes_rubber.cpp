// The law of plain_rubber.cpp as somebody tunes it who knows the machine: 3D alone, registers of 32 bytes,
// the six components that differ, one division, a logarithm of its own.
#include <matpoint/elasticity.hpp>
#include <matpoint/material.hpp>
#include <matpoint/plugin.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

using namespace matpoint;

template <class Space>
class LanesRubber final : public Material<Space> {
  public:
    using Real = typename Space::Real;
    using Batch = ParticleBatch<Space>;

    static Schema schema() {
        Schema schema("Neo-Hookean solid in 3D, by hand", "[Wallstedt & Guilkey 2008]");
        return add_elastic_constants(schema);
    }
    explicit LanesRubber(const Parameters& parameters)
        : Material<Space>(parameters),
          lame_(parameters.number("youngs_modulus"), parameters.number("poissons_ratio")) {
        if (Space::dimension != 3) throw std::invalid_argument("lanes_rubber is for 3D");
    }

    bool uses_deformation_gradient() const override { return true; }
    void update_stress(const Batch& batch, Real) const override { treat<true>(batch); }
    Real wave_speed(const Batch& batch) const override { return treat<false>(batch); }
    Real update(const Batch& batch, Real) const override { return treat<true>(batch); }

  private:
    typedef Real Lanes __attribute__((vector_size(32)));
    static constexpr int lanes = sizeof(Lanes) / sizeof(Real);

    /// Slow lanes for a batch's last particles, fewer than a register holds.
    static Lanes load(const Real* from, int count) {
        Lanes a;
        if (count == lanes) {
            std::memcpy(&a, from, sizeof a);
            return a;
        }
        for (int i = 0; i < lanes; ++i) a[i] = from[std::min(i, count - 1)];
        return a;
    }

    /// Of J near 1: 2 artanh((J - 1)/(J + 1)) as a series, to rounding for 0.7 < J < 1.4.
    static Lanes logarithm(Lanes j) {
        bool near = true;
        for (int i = 0; i < lanes; ++i) near = near & (j[i] > Real(0.7)) & (j[i] < Real(1.4));
        if (!near) {
            for (int i = 0; i < lanes; ++i) j[i] = std::log(j[i]);
            return j;
        }
        const Lanes z = (j - 1) / (j + 1), z2 = z * z;
        Lanes sum = z2 * 0 + Real(1) / 21;
        for (int k = 19; k > 0; k -= 2) sum = sum * z2 + Real(1) / Real(k);
        return 2 * z * sum;
    }

    template <bool stores>
    Real treat(const Batch& batch) const {
        if constexpr (Space::dimension == 3) {
            const auto& particles = batch.particles();
            Real* const* const h = particles.columns(particles.slot(Field::displacement_gradient));
            Real* const* const s = particles.columns(particles.slot(Field::stress));
            const Real* const mass = particles.column(Field::mass);
            const Real* const volume = particles.column(Field::volume);
            Lanes fastest{};
            for (Index p = batch.begin(); p < batch.end(); p += lanes) {
                const int count = static_cast<int>(std::min<Index>(lanes, batch.end() - p));
                Lanes F[9];
                for (std::size_t c = 0; c < 9; ++c) F[c] = load(h[c] + p, count) + Real(c % 4 == 0 ? 1 : 0);
                const Lanes J = F[0] * (F[4] * F[8] - F[7] * F[5]) + F[3] * (F[7] * F[2] - F[1] * F[8]) +
                                F[6] * (F[1] * F[5] - F[4] * F[2]);
                const Lanes inverse = 1 / J, log_j = logarithm(J);
                const auto b = [&](std::size_t i, std::size_t k) {
                    return F[i] * F[k] + F[3 + i] * F[3 + k] + F[6 + i] * F[6 + k];
                };
                const Lanes B[6] = {b(0, 0), b(1, 1), b(2, 2), b(0, 1), b(1, 2), b(0, 2)};
                if constexpr (stores) {
                    const Lanes shear = lame_.mu * inverse, pressure = lame_.lambda * inverse * log_j - shear;
                    for (std::size_t c = 0; c < 6; ++c) {
                        const Lanes stress = c < 3 ? shear * B[c] + pressure : shear * B[c];
                        if (count == lanes)
                            std::memcpy(s[c] + p, &stress, sizeof stress);
                        else
                            for (int i = 0; i < count; ++i) s[c][p + i] = stress[i];
                    }
                }
                const Lanes mean = (B[0] + B[1] + B[2]) * (Real(1) / 3);
                const Lanes x = B[0] - mean, y = B[1] - mean, z = B[2] - mean;
                Lanes stretch =
                    (x * x + y * y + z * z + 2 * (B[3] * B[3] + B[4] * B[4] + B[5] * B[5])) * (Real(2) / 3);
                for (int i = 0; i < lanes; ++i) stretch[i] = std::sqrt(stretch[i]);
                const Lanes volumetric = lame_.lambda * (1 - log_j) + lame_.mu;
                const Lanes stiffness = (volumetric > 0 ? volumetric : Lanes{}) + lame_.mu * (mean + stretch);
                const Lanes square = stiffness * inverse * load(volume + p, count) / load(mass + p, count);
                fastest = square > fastest ? square : fastest;
            }
            Real largest = 0;
            for (int i = 0; i < lanes; ++i) largest = std::max(largest, fastest[i]);
            return std::sqrt(largest);
        }
        return 0;
    }

    Lame<Space> lame_;
};

MATPOINT_PLUGIN("lanes_rubber", "1.0.0") {
    registry.material<LanesRubber>("lanes_rubber");
}
