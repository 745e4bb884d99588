#include <matpoint/boundary_condition.hpp>
#include <matpoint/plugin.hpp>

namespace matpoint {

/// A wall that pushes and rubs but does not pull; the kernel solves for it, by its friction.
template <class S>
class Unilateral final : public BoundaryCondition<S> {
  public:
    explicit Unilateral(const Parameters& parameters) : friction_(parameters.number("friction")) {}

    static Schema schema() {
        Schema schema(
            "A wall that pushes, and rubs, but does not pull: bodies touch it with their surface "
            "and let go",
            "[Bardenhagen et al. 2000, sec. 2.2, with a rigid wall]");
        schema
            .number("friction",
                    {.doc = "Coefficient of Coulomb's friction", .default_value = 0, .at_least = 0})
            .refuse("/on", "pushes bodies that touch a face of the grid: name faces",
                    [](const Json& own, const Json&) { return !own.at("on").is_array(); });
        return schema;
    }

    std::array<bool, 3> prescribes(int) const override { return {}; }
    std::optional<double> friction() const override { return friction_; }

  private:
    double friction_;
};

}  // namespace matpoint

MATPOINT_PLUGIN("unilateral", "1.0.0") {
    registry.boundary_condition<matpoint::Unilateral>("unilateral");
}
