#include <matpoint/boundary_condition.hpp>
#include <matpoint/plugin.hpp>

namespace matpoint {

/// No motion at all: a wall that bodies stick to.
template <class S>
class Fixed final : public BoundaryCondition<S> {
  public:
    explicit Fixed(const Parameters&) {}

    static Schema schema() {
        return Schema("All components of velocity are zero", "[Chen & Brannon 2002, sec. 2]");
    }

    std::array<bool, 3> prescribes(int) const override { return {true, true, true}; }
};

}  // namespace matpoint

MATPOINT_PLUGIN("fixed", "1.0.0") {
    registry.boundary_condition<matpoint::Fixed>("fixed");
}
