#include <matpoint/exact_solution.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace matpoint {

namespace {

/// The materials of the bodies that a solution's object names.
std::vector<Json> materials_of(const Json& own, const Json& scene) {
    std::vector<Json> materials;
    for (const Json& body : own.at("body")) {
        const Json& material = scene.at("bodies").at(body.get<std::string>()).at("material");
        materials.push_back(scene.at("materials").at(material.get<std::string>()));
    }
    return materials;
}

}  // namespace

double ElasticConstants::bar_speed() const {
    return std::sqrt(youngs_modulus / density);
}

ElasticConstants elastic_constants(const Parameters& parameters) {
    const Json material = materials_of(parameters.json(), *parameters.context().scene).front();
    const double e = material.at("youngs_modulus").get<double>(),
                 nu = material.at("poissons_ratio").get<double>();
    const bool bar = parameters.context().space.dimension() == 1;
    return {.density = material.at("density").get<double>(),
            .youngs_modulus = e,
            .poissons_ratio = nu,
            .lambda = bar ? 0 : e * nu / ((1 + nu) * (1 - 2 * nu)),
            .mu = bar ? e / 2 : e / (2 * (1 + nu))};
}

Schema& refuse_other_materials(Schema& schema, std::vector<std::string> types) {
    std::string reason = fmt::format("is a solution for bodies of {}; the body's material is of another type",
                                     fmt::join(types, " or "));
    return schema.refuse("/body", std::move(reason), [types](const Json& own, const Json& scene) {
        return std::ranges::any_of(materials_of(own, scene), [&](const Json& material) {
            return std::ranges::find(types, material.at("type").get<std::string>()) == types.end();
        });
    });
}

Schema& warn_without_body_force(Schema& schema) {
    return schema.warn(
        "",
        "the bodies move like this under its body force only: add { \"type\": \"manufactured\" } to `loads`",
        [](const Json&, const Json& scene) {
            return std::ranges::none_of(scene.at("loads"),
                                        [](const Json& load) { return load.at("type") == "manufactured"; });
        });
}

}  // namespace matpoint
