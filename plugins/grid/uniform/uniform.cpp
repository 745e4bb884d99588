#include <matpoint/plugin.hpp>

#include "../cells.hpp"

namespace {

using namespace matpoint;

/// One level of equal cells; only blocks of nodes near particles exist.
template <class S>
class Uniform final : public Grid<S> {
  public:
    static Schema schema() {
        Schema schema(
            "One level of equal cells; of a block of nodes without particles near it only four bytes exist");
        return add_cells(schema);
    }

    explicit Uniform(const Parameters& parameters) : patch_(patch_of<S>(parameters)) {}

    Patch<S>& patch() override { return patch_; }

  private:
    Patch<S> patch_;
};

}  // namespace

MATPOINT_PLUGIN("uniform", "1.0.0") {
    registry.grid<Uniform>("uniform");
}
