#include <matpoint/boundary_condition.hpp>
#include <matpoint/plugin.hpp>

namespace matpoint {

/// A frictionless wall, or a plane of symmetry.
template <class S>
class Slip final : public BoundaryCondition<S> {
  public:
    explicit Slip(const Parameters& parameters) {
        if (parameters.has("axis")) axis_ = parameters.text("axis")[0] - 'x';
    }

    static Schema schema() {
        const auto in_region = [](const Json& own) { return own.at("on").is_object(); };
        const auto has_axis = [](const Json& own) {
            return own.contains("axis") && !own.at("axis").is_null();
        };
        Schema schema("The component of velocity normal to the wall is zero, the others are free",
                      "[Chen & Brannon 2002, sec. 2]");
        schema
            .choice("axis", {.doc = "In a region or for a part of a body: the axis whose component is zero",
                             .optional = true,
                             .choices = {"x", "y", "z"}})
            .refuse("/axis", "a region has no normal: say which component is zero",
                    [=](const Json& own, const Json&) { return in_region(own) && !has_axis(own); })
            .refuse("/axis", "a face has its own normal: leave it out",
                    [=](const Json& own, const Json&) { return !in_region(own) && has_axis(own); })
            .refuse("/axis", "the scene has no such axis", [=](const Json& own, const Json& scene) {
                return has_axis(own) && own.at("axis").get<std::string>()[0] - 'x' >=
                                            scene.at("space").at("dimension").get<int>();
            });
        return schema;
    }

    std::array<bool, 3> prescribes(int axis) const override {
        const int normal = axis < 0 ? axis_ : axis;
        return {normal == 0, normal == 1, normal == 2};
    }

  private:
    int axis_ = -1;
};

}  // namespace matpoint

MATPOINT_PLUGIN("slip", "1.0.0") {
    registry.boundary_condition<matpoint::Slip>("slip");
}
