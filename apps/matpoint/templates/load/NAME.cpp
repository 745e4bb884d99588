#include <matpoint/load.hpp>
#include <matpoint/plugin.hpp>

using namespace matpoint;

/// Linear drag: slows everything down in proportion to its velocity; see README.md.
template <class Space>
class {{Name}} final : public Load<Space> {
  public:
    using Real = typename Space::Real;

    static Schema schema() {
        return Schema("Linear drag, f = -c m v").number("rate", {.unit = "1/s", .doc = "c", .at_least = 0});
    }
    explicit {{Name}}(const Parameters& parameters) : rate_(Real(parameters.number("rate"))) {}

    void apply(LoadContext<Space>& context) const override {
        Patch<Space>& patch = context.patch;
        for (int a = 0; a < Space::dimension; ++a) {
            const Real* momentum = patch.column(NodeField::velocity, a);  // m v while loads are applied
            Real* force = patch.column(NodeField::external_force, a);
            for (Index i = 0; i < patch.node_count(); ++i) force[i] -= rate_ * momentum[i];
        }
    }

  private:
    Real rate_;
};

MATPOINT_PLUGIN("{{name}}", "0.1.0") { registry.load<{{Name}}>("{{name}}"); }
