#include "config/describe.hpp"
#include "config_example.hpp"
#include "editor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace matpoint {
namespace {

TEST(json_schema, accepts_good_scenes_and_their_resolved_form) {
    FakeCatalogue catalogue;
    const Editor editor(catalogue);
    EXPECT_TRUE(editor.accepts(example().json));
    Json resolved = resolve_scene(example(), catalogue).resolved;
    EXPECT_TRUE(editor.accepts(resolved));
    resolved["resolved_with"] = {{"a", "1"}};
    EXPECT_TRUE(editor.accepts(resolved));
}

TEST(json_schema, refuses_broken_scenes) {
    FakeCatalogue catalogue;
    const Editor editor(catalogue);
    for (const char* setting : {
             "/matpoint=2",
             "/unknown=1",
             "/grid/cell_size=0",
             "/grid/min=[]",
             "/grid/min/0=far",
             "/grid/min/0=1 2",
             "/transfer/type=flop",
             "/transfer/type=apic",
             "/transfer={}",
             "/transfer/pic_fraction=1.5",
             "/time={\"cfl\": 0.4}",
             "/materials={}",
             "/materials/rubber/poissons_ratio=0.5",
             "/materials/rubber/density=0",
             "/materials/rubber/densty=1",
             "/bodies/disk/geometry/type=stl",
             "/bodies/plane/geometry/of/0/file=3",
             "/boundary_conditions/2/value/0/extra=3",
             "/boundary_conditions/0/on=w_min",
             "/boundary_conditions/1/value=3",
             "/outputs/0/every_steps=0",
             "/contacts/0/between=[1]",
             "/exact_solution={\"type\": \"any\"}",
             "/health={\"off_grid\": \"stop\"}",
         }) {
        EXPECT_FALSE(editor.accepts(example({setting}).json)) << setting;
        EXPECT_NE(complaints({setting}), "") << setting;
    }
}

TEST(json_schema, accepts_whatever_resolves) {
    FakeCatalogue catalogue;
    const Editor editor(catalogue);
    for (const char* setting : {
             "/grid/cell_size=[\"1 cm\", 0.02]",
             "/materials/rubber/youngs_modulus=4.2e6",
             "/time/end=5 1/Hz",
             "/boundary_conditions/0/on=[\"x_min\", \"y_max\"]",
             "/contacts/0/between=disk",
             "/title=Some words",
             "/comment=for readers",
             "/checkpoint={\"every_steps\": 10, \"keep\": 1}",
         }) {
        EXPECT_EQ(complaints({setting}), "") << setting;
        EXPECT_TRUE(editor.accepts(example({setting}).json)) << setting;
    }
}

TEST(json_schema, keeps_the_facts_that_editors_show) {
    FakeCatalogue catalogue;
    const Json schema = json_schema(catalogue);
    EXPECT_EQ(schema["$schema"], "http://json-schema.org/draft-07/schema#");
    EXPECT_EQ(schema["definitions"]["integrator"]["properties"]["type"]["enum"],
              Json({"central_difference", "usl"}));
    const Json& parameters = schema["definitions"]["material"]["allOf"][0]["then"]["properties"];
    EXPECT_EQ(parameters["youngs_modulus"]["description"], "E (Pa)");
    EXPECT_EQ(schema["properties"]["transfer"]["default"], (Json{{"type", "affine_flip"}}));
}

TEST(describe, shows_all_that_a_component_says_of_itself) {
    FakeCatalogue catalogue;
    const Kind& kind = *find_kind("material");
    const Schema& schema = *catalogue.find("material", "neo_hookean");
    EXPECT_EQ(describe_text(kind, "neo_hookean", schema),
              "neo_hookean (material; in 1, 2, 3 dimensions)\n"
              "Compressible rubber [Author 2000, eq. 1]\n"
              "\n"
              "Parameters\n"
              "  density: a number > 0 (kg/m^3); required\n"
              "      Initial mass per volume\n"
              "  youngs_modulus: a number > 0 (Pa); required\n"
              "      E\n"
              "  poissons_ratio: a number > -1 and < 0.5; required\n"
              "\n"
              "Rules\n"
              "  refused (poissons_ratio): too stiff for this material\n");
    const Json json = describe_json(kind, "neo_hookean", schema);
    EXPECT_EQ(json["paper"], "[Author 2000, eq. 1]");
    EXPECT_EQ(json["dimensions"], Json({1, 2, 3}));
    EXPECT_EQ(json["parameters"][1]["name"], "youngs_modulus");
    EXPECT_EQ(json["parameters"][1]["unit"], "Pa");
    EXPECT_EQ(json["parameters"][1]["greater_than"], 0);
    EXPECT_EQ(json["rules"][0]["at"], "/poissons_ratio");
}

TEST(describe, shows_a_kind) {
    FakeCatalogue catalogue;
    const Kind& kind = *find_kind("output");
    EXPECT_EQ(describe_text(kind, catalogue),
              "output: Files written during a run\n"
              "Types: csv, probe, tables\n"
              "\n"
              "Parameters of every type\n"
              "  every: a number > 0 (s); optional\n"
              "      Simulated time between outputs\n"
              "  every_steps: a whole number >= 1; optional\n"
              "      Steps between outputs\n");
    EXPECT_EQ(describe_json(kind, catalogue)["types"], Json::array({"csv", "probe", "tables"}));
    EXPECT_EQ(find_kind("matreial"), nullptr);
    EXPECT_EQ(kinds().size(), 12u);
}

TEST(describe, shows_the_keys_of_a_scene) {
    std::vector<std::string> names;
    for (const Parameter* key : own_keys()) names.push_back(key->name);
    for (const char* name :
         {"space", "time", "bodies", "accuracy", "checkpoint", "health", "plugins", "checks"})
        EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
    EXPECT_EQ(std::count(names.begin(), names.end(), "materials"), 0);
    const Parameter& time = *scene_schema().find("time");
    const std::string text = describe_text(time);
    EXPECT_EQ(text.find("time (key of a scene): an object; required\n"), 0U) << text;
    for (const Parameter& p : time.nested->parameters())
        EXPECT_NE(text.find("\n  " + p.name + ": "), std::string::npos) << text;
    for (const Rule& rule : time.nested->rules())
        EXPECT_NE(text.find(rule.reason), std::string::npos) << text;
    EXPECT_EQ(describe_json(time)["parameters"].size(), time.nested->parameters().size());
}

TEST(describe, shows_what_goes_with_each_choice_as_a_table) {
    Schema schema("A probe");
    schema.choice("quantity", {.choices = {"mass", "min"}})
        .text("body", {.optional = true})
        .text("field", {.optional = true})
        .use({"quantity",
              {"body", "field"},
              {{"mass", {Use::possible, Use::refused}}, {"min", {Use::possible, Use::needed}}}});
    const std::string text = describe_text(*find_kind("output"), "probe", schema);
    EXPECT_NE(text.find("\nWhat goes with each quantity\n"
                        "  quantity  body      field   \n"
                        "  mass      possible  -       \n"
                        "  min       possible  needed  \n"),
              std::string::npos)
        << text;
    EXPECT_EQ(text.find("takes no"), std::string::npos) << text;

    // And holds as rules.
    ASSERT_EQ(schema.rules().size(), 2U);
    const auto refused = [&](const Json& own) {
        return std::any_of(schema.rules().begin(), schema.rules().end(),
                           [&](const Rule& rule) { return rule.refuses && rule.applies(own, {}); });
    };
    EXPECT_TRUE(refused({{"quantity", "mass"}, {"field", "stress"}}));
    EXPECT_TRUE(refused({{"quantity", "min"}}));
    EXPECT_FALSE(refused({{"quantity", "min"}, {"field", "stress"}}));
    EXPECT_FALSE(refused({{"quantity", "mass"}, {"body", "disk"}}));
}

}  // namespace
}  // namespace matpoint
