#include <matpoint/geometry.hpp>
#include <matpoint/plugin.hpp>

#include "../cells.hpp"

namespace {

using namespace matpoint;

Schema level_schema() {
    Schema schema("A level finer than those before it");
    schema.add(
        "within", ParameterType::component,
        {.doc = "Where its cells are: the cells of the next coarser level that this reaches, and those "
                "around finer levels",
         .kind = "geometry"});
    schema.text("follow",
                {.doc = "Name of a body, by its centre of mass, or of a rigid tool: the region goes with it",
                 .optional = true});
    return schema;
}

bool has_unilateral(const Json& scene) {
    return std::ranges::any_of(scene.at("boundary_conditions"),
                               [](const Json& condition) { return condition.at("type") == "unilateral"; });
}

/// Whether a transfer doesn't extend the particles' velocities by an affine field.
bool loses_slopes(const Json& scene) {
    const Json& transfer = scene.at("transfer");
    return transfer.at("type") == "fmpm" ||
           (transfer.at("type") == "flip" && !transfer.value("gradient_enhanced", false));
}

bool has_quadratic_splines(const Json& scene) {
    return scene.at("shape_function").value("order", 0) == 2;
}

bool has_artificial_viscosity(const Json& scene) {
    return std::ranges::any_of(scene.at("bodies"),
                               [](const Json& body) { return body.contains("artificial_viscosity"); });
}

/// Nested levels, each with cells of half the size in a region.
template <class S>
class Multilevel final : public Grid<S> {
  public:
    static Schema schema() {
        Schema schema(
            "Nested levels, each with cells of half the size of the next coarser one in a region; particles "
            "are "
            "seeded as each level's cells say, and split where they come to a finer one",
            "[Ma et al. 2005, section 3]");
        return add_cells(schema)
            .add("levels", ParameterType::objects,
                 {.doc = "Finer levels, each within the one before",
                  .nested = std::make_shared<Schema>(level_schema())})
            .boolean("substeps", {.doc = "Whether a level takes two steps for one of the next coarser",
                                  .default_value = false})
            .refuse("/substeps", "is not there yet: all levels take the same steps",
                    [](const Json& own, const Json&) { return own.at("substeps") == true; })
            .refuse("/levels", "has no level: take the grid \"uniform\"",
                    [](const Json& own, const Json&) { return own.at("levels").empty(); })
            .warn(
                "/levels",
                "a velocity that is linear in space has a wrong slope in the cells at their borders, by 10 % "
                "and more, with this transfer: take \"affine_flip\", \"apic\", or \"flip\" with "
                "\"gradient_enhanced\"",
                [](const Json&, const Json& scene) { return loses_slopes(scene); })
            .warn(
                "/levels",
                "artificial viscosity takes the size of the coarsest cells on all levels: shocks are as wide "
                "as there",
                [](const Json&, const Json& scene) { return has_artificial_viscosity(scene); })
            .refuse(
                "/levels",
                "quadratic splines have no nodes on the faces of finer levels, which \"unilateral\" needs: "
                "take \"order\": 3, or gimp",
                [](const Json&, const Json& scene) {
                    return has_unilateral(scene) && has_quadratic_splines(scene);
                });
    }

    explicit Multilevel(const Parameters& parameters) : patch_(patch_of<S>(parameters)) {
        for (const Parameters& level : parameters.objects("levels")) {
            regions_.push_back(level.geometry("within"));
            follow_.push_back(level.has("follow") ? level.text("follow") : "");
        }
    }

    Patch<S>& patch() override { return patch_; }
    std::vector<Refined> refined() const override {
        std::vector<Refined> all;
        for (std::size_t k = 0; k < regions_.size(); ++k) all.push_back({regions_[k].get(), follow_[k]});
        return all;
    }

  private:
    Patch<S> patch_;
    std::vector<std::shared_ptr<Geometry>> regions_;
    std::vector<std::string> follow_;  ///< by level; empty: it stays
};

}  // namespace

MATPOINT_PLUGIN("multilevel", "1.0.0") {
    registry.grid<Multilevel>("multilevel");
}
