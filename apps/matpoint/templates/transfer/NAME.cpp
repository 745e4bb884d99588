#include <matpoint/plugin.hpp>
#include <matpoint/transfer.hpp>

using namespace matpoint;

/// Particle in cell: a particle takes the grid's velocity [Harlow 1964]; see README.md.
template <class Space>
class {{Name}} final : public Transfer<Space> {
  public:
    using Real = typename Space::Real;

    static Schema schema() { return Schema("Particle in cell: particles take the grid's velocity", "[Harlow 1964]"); }
    explicit {{Name}}(const Parameters&) {}

    bool needs_acceleration() const override { return false; }
    Real grid_share() const override { return 1; }

    void update(const ParticleBatch<Space>& batch, Real) const override {
        for (int a = 0; a < Space::dimension; ++a) {
            Real* v = batch.particles().column(Field::velocity, a);
            const auto& grid_velocity = batch.gathered().velocity[static_cast<std::size_t>(a)];
            for (Index p = batch.begin(); p < batch.end(); ++p)
                v[p] = grid_velocity[static_cast<std::size_t>(p - batch.begin())];
        }
    }
};

MATPOINT_PLUGIN("{{name}}", "0.1.0") { registry.transfer<{{Name}}>("{{name}}"); }
