#include "config_example.hpp"

#include <gtest/gtest.h>

namespace matpoint {
namespace {

Scene resolve(const std::vector<std::string>& settings = {}) {
    FakeCatalogue catalogue;
    return resolve_scene(example(settings), catalogue);
}

TEST(scene, resolves_units_lists_and_defaults) {
    const Scene scene = resolve();
    const Json& r = scene.resolved;
    EXPECT_EQ(r["title"], "example");
    EXPECT_EQ(r["space"], (Json{{"dimension", 2}, {"mode", "plane_strain"}, {"precision", "double"}}));
    EXPECT_EQ(r["grid"]["max"], Json({2.0, 1}));
    EXPECT_EQ(r["grid"]["cell_size"], Json({0.1, 0.1}));
    EXPECT_EQ(r["grid"]["light_nodes"], 0.1);
    EXPECT_EQ(r["shape_function"], (Json{{"type", "bspline"}}));
    EXPECT_EQ(r["integrator"], (Json{{"type", "central_difference"}}));
    EXPECT_EQ(r["time"], (Json{{"end", 0.01}, {"cfl", 0.4}}));
    EXPECT_DOUBLE_EQ(r["materials"]["rubber"]["youngs_modulus"].get<double>(), 4.2e6);
    EXPECT_EQ(r["bodies"]["disk"]["particles_per_cell"], Json({3, 3}));
    EXPECT_EQ(r["bodies"]["disk"]["velocity"], Json({0, 0}));
    EXPECT_EQ(r["bodies"]["plane"]["particles_per_cell"], Json({2, 2}));
    EXPECT_EQ(r["bodies"]["plane"]["velocity"][0], "0.1*sin(pi*x)");
    EXPECT_DOUBLE_EQ(r["bodies"]["plane"]["velocity"][1].get<double>(), 10);
    EXPECT_DOUBLE_EQ(r["boundary_conditions"][2]["value"][0]["times"][1].get<double>(), 1e-3);
    EXPECT_DOUBLE_EQ(r["boundary_conditions"][2]["value"][0]["values"][1].get<double>(), 10);
    EXPECT_EQ(r["boundary_conditions"][0]["on"], Json::array({"y_min"}));
    EXPECT_EQ(r["boundary_conditions"][1]["on"]["type"], "box");
    EXPECT_EQ(r["boundary_conditions"][1]["value"], Json({nullptr, 0.02}));
    EXPECT_EQ(r["outputs"][0]["fields"], Json::array({"stress"}));
    EXPECT_EQ(r["loads"], Json::array());
    EXPECT_EQ(r["plugins"], Json::array());
    EXPECT_EQ(r["health"], (Json{{"enabled", true},
                                 {"off_grid", "error"},
                                 {"unstable_step", "error"},
                                 {"energy_drift", 0.05},
                                 {"energy_gain", 0.5}}));
    EXPECT_FALSE(r.contains("checkpoint"));
    EXPECT_FALSE(r.contains("exact_solution"));
    EXPECT_EQ(scene.space, SpaceId::of<PlaneStrain>());
    EXPECT_EQ(scene.folder, std::filesystem::absolute("scenes"));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(scene, resolves_again_to_itself_from_any_folder) {
    const Scene once = resolve({"/plugins=\"lib/a.so\"", "/checkpoint={\"every\": \"1 s\"}", "/checks=[1]"});
    EXPECT_EQ(once.resolved["plugins"],
              Json::array({(std::filesystem::absolute("scenes/lib/a.so")).string()}));
    EXPECT_EQ(once.resolved["bodies"]["plane"]["geometry"]["of"][0]["file"],
              std::filesystem::absolute("scenes/meshes/plane.stl").string());
    Json saved = once.resolved;
    saved["resolved_with"] = {{"neo_hookean", "1.0.0"}};
    FakeCatalogue catalogue;
    const Scene twice = resolve_scene(parse_document(saved.dump(2), "elsewhere/resolved.json"), catalogue);
    EXPECT_EQ(once.resolved.dump(2), twice.resolved.dump(2));
}

TEST(scene, knows_its_space) {
    EXPECT_EQ(resolve({"/space/mode=axisymmetric"}).space, SpaceId::of<Axisymmetric>());
    EXPECT_EQ(resolve({"/space/precision=single"}).space, SpaceId::of<PlaneStrainSingle>());
    EXPECT_EQ(complaints({"/space/mode=solid"}),
              "--set /space/mode: error: /space/mode: in 2 dimension(s) expected plane_strain or "
              "plane_stress or axisymmetric, got "
              "\"solid\"");
}

TEST(scene, takes_null_as_an_absent_optional_key) {
    const Json resolved =
        resolve({"/space/mode=null", "/title=null", "/time/cfl=null", "/checkpoint=null"}).resolved;
    EXPECT_EQ(resolved, resolve().resolved);
}

TEST(scene, keeps_exactly_one_way_to_choose_the_step) {
    EXPECT_EQ(resolve({"/time/step=1 us"}).resolved["time"].contains("cfl"), false);
    EXPECT_EQ(resolve({"/time/cfl=2"}).resolved["time"]["cfl"], 2);
    EXPECT_EQ(complaints({"/time/cfl=0.3", "/time/step=1 us"}),
              "--set /time/cfl: error: /time/cfl: give `step` or `cfl`, not both");
    EXPECT_EQ(complaints({"/time/cfl=2.1"}),
              "--set /time/cfl: error: /time/cfl: expected a number > 0 and <= 2, got 2.1");
}

TEST(scene, takes_a_single_number_of_particles_as_the_total) {
    const char* pointer = "/bodies/disk/particles_per_cell";
    EXPECT_EQ(resolve({std::string(pointer) + "=1"}).resolved["bodies"]["disk"]["particles_per_cell"],
              Json({1, 1}));
    EXPECT_EQ(resolve({std::string(pointer) + "=[2, 5]"}).resolved["bodies"]["disk"]["particles_per_cell"],
              Json({2, 5}));
    EXPECT_NE(complaints({std::string(pointer) + "=5"}).find("such as 4 or 9; got 5"), std::string::npos);
    EXPECT_NE(complaints({std::string(pointer) + "=8"}).find("such as 4 or 9; got 8"), std::string::npos);
    EXPECT_NE(complaints({std::string(pointer) + "=0"}).find("such as 1 or 4; got 0"), std::string::npos);
    EXPECT_NE(complaints({std::string(pointer) + "=[2, 0]"}).find("/1: expected a number >= 1, got 0"),
              std::string::npos);
    EXPECT_NE(
        complaints({std::string(pointer) + "=[2, 2.5]"}).find("/1: expected a whole number >= 1, got 2.5"),
        std::string::npos);
}

TEST(scene, reports_each_mistake_in_words) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{"/materials/rubber={\"typ\": \"neo_hookean\"}"},
         "/materials/rubber/typ: unknown key; did you mean \"type\"?"},
        {{"/materials/rubber/poissons_ratio=0.7"},
         "/materials/rubber/poissons_ratio: expected a number > -1 and < 0.5, got 0.7"},
        {{"/materials/rubber/youngs_modulus=4 MPaa"},
         "/materials/rubber/youngs_modulus: expected a number > 0 (Pa): unknown unit \"MPaa\""},
        {{"/materials/rubber/youngs_modulus=true"},
         "/materials/rubber/youngs_modulus: expected a number > 0 (Pa), got true"},
        {{"/materials/rubber/youngs_modulus=-1 GPa"},
         "/materials/rubber/youngs_modulus: expected a number > 0 (Pa), got \"-1 GPa\""},
        {{"/materials/rubber/densty=3"}, "/materials/rubber/densty: unknown key"},
        {{"/materials/rubber={\"type\": \"neo_hookean\", \"densty\": 3, \"youngs_modulus\": 1, "
          "\"poissons_ratio\": 0}"},
         "/materials/rubber: missing key \"density\": expected a number > 0 (kg/m^3)\n"
         "--set /materials/rubber: error: /materials/rubber/densty: unknown key; did you mean \"density\"?"},
        {{"/materials/rubber/type=neo_hokean"},
         "/materials/rubber/type: unknown material \"neo_hokean\"; did you mean \"neo_hookean\"?"},
        {{"/materials={}"}, "/materials: expected an object of at least 1 named item(s), got {}"},
        {{"/shape_function={}"}, "/shape_function: missing key \"type\"; expected one of bspline, gimp"},
        {{"/shape_function=gimp"},
         "/shape_function: expected a shape_function: an object with \"type\", got \"gimp\""},
        {{"/transfer/type=apic"}, "/transfer/pic_fraction: unknown key; it is a parameter of \"flip\""},
        {{"/integrator={\"type\": 3}"},
         "/integrator/type: unknown integrator 3; expected one of central_difference, usl"},
        {{"/contacts/0/between/0=dsk"},
         "/contacts/0/between/0: no \"dsk\" in /bodies; did you mean \"disk\"?"},
        {{"/contacts/0/between/1=7"}, "/contacts/0/between/1: expected a name in /bodies, got 7"},
        {{"/bodies/disk/material=steel"},
         "/bodies/disk/material: no \"steel\" in /materials; expected one of rubber"},
        {{"/bodies/disk/velocity=[1, \"2 kg\"]"}, "/bodies/disk/velocity/1: \"2 kg\" is neither a formula"},
        {{"/bodies/disk/velocity=[1, null]"},
         "/bodies/disk/velocity/1: an initial velocity can't be left free"},
        {{"/boundary_conditions/2/value/0/times/1=0"},
         "/boundary_conditions/2/value/0: a table's times increase"},
        {{"/boundary_conditions/0/on=z_max"},
         "/boundary_conditions/0/on: no face \"z_max\"; expected one of x_min, x_max, y_min, y_max"},
        {{"/boundary_conditions/1/value=[1]"}, "/boundary_conditions/1/value: expected a list of 2 item(s)"},
        {{"/grid/min=[0, 0, 0]"}, "/grid/min: expected a list of 2 numbers (m), got [0,0,0]"},
        {{"/shape_function={\"type\": \"gimp\", \"domain\": \"uniforn\"}"},
         "/shape_function/domain: expected one of contiguous, uniform, got \"uniforn\"; did you mean "
         "\"uniform\"?"},
        {{"/outputs/0/every_steps=2.5"}, "/outputs/0/every_steps: expected a whole number >= 1, got 2.5"},
        {{"/outputs/0/every_steps=2"}, "/outputs/0/every_steps: give `every` or `every_steps`, not both"},
        {{"/matpoint=2"}, "/matpoint: expected a whole number equal to 1, got 2"},
        {{"/space/dimension=4"}, "/space/dimension: expected a whole number >= 1 and <= 3, got 4"},
        {{"/outptus=[]"}, "/outptus: unknown key"},
        {{"/bodies/=3"}, "/bodies/: a name can't be empty"},
        {{"/loads={}"}, "/loads: expected a list of load objects, each with \"type\", got {}"},
        {{"/health={\"enabled\": 1}"}, "/health/enabled: expected true or false, got 1"},
        {{"/materials/rubber/poissons_ratio=0.495"},
         "/materials/rubber/poissons_ratio: too stiff for this material"},
    };
    for (const auto& [settings, expected] : cases) {
        EXPECT_NE(complaints(settings).find(": error: " + expected), std::string::npos)
            << "expected: " << expected << "\ngot: " << complaints(settings);
    }
}

TEST(scene, reports_all_mistakes_at_once_by_line) {
    FakeCatalogue catalogue;
    const char* text = R"({
  "matpoint": 1,
  "space": { "dimension": 2 },
  "grid": { "type": "uniform", "min": [0], "max": [1, 1], "cell_size": 0.1 },
  "time": { "end": -1 },
  "bodies": { "disk": { "material": "rubber", "geometry": { "type": "bxo" } } },
  "time": { "end": -2 },
  "materials": { "ruber": { "type": "neo_hookean", "density": 1, "youngs_modulus": 1, "poissons_ratio": 0.7 } }
})";
    try {
        resolve_scene(parse_document(text, "a.json"), catalogue);
        FAIL();
    } catch (const InputError& e) {
        EXPECT_STREQ(
            e.what(),
            "a.json:4:32: error: /grid/min: expected a list of 2 numbers (m), got [0]\n"
            "a.json:6:25: error: /bodies/disk/material: no \"rubber\" in /materials; did you mean "
            "\"ruber\"?\n"
            "a.json:6:61: error: /bodies/disk/geometry/type: unknown geometry \"bxo\"; did you mean "
            "\"box\"?\n"
            "a.json:7:3: error: /time: given twice: on line 5 and on line 7\n"
            "a.json:7:13: error: /time/end: expected a number > 0 (s), got -2\n"
            "a.json:8:87: error: /materials/ruber/poissons_ratio: expected a number > -1 and < 0.5, got 0.7");
        EXPECT_EQ(e.diagnostics().all().size(), 6u);
    }
}

TEST(scene, warns_without_refusing) {
    EXPECT_EQ(complaints({"/transfer={\"type\": \"apic\"}"}),
              "--set /transfer: warning: /transfer: apic is dissipative with splines\n");
    EXPECT_EQ(complaints({"/transfer={\"type\": \"apic\"}", "/shape_function={\"type\": \"gimp\"}"}), "");
}

TEST(scene, refuses_components_of_other_dimensions) {
    FakeCatalogue catalogue;
    const char* text = R"({ "matpoint": 1, "space": { "dimension": 1 }, "transfer": { "type": "apic" },
        "grid": { "type": "uniform", "min": [0], "max": [1], "cell_size": 0.1 }, "time": { "end": 1 },
        "materials": { "m": { "type": "neo_hookean", "density": 1, "youngs_modulus": 1, "poissons_ratio": 0 } },
        "bodies": { "b": { "material": "m", "particles_per_cell": 5,
                           "geometry": { "type": "box", "min": [0], "max": [1] } } } })";
    Document document = parse_document(text, "a.json");
    try {
        resolve_scene(document, catalogue);
        FAIL();
    } catch (const InputError& e) {
        EXPECT_STREQ(e.what(),
                     "a.json:1:61: error: /transfer/type: \"apic\" works in 2 or 3 dimension(s), and this "
                     "scene has 1");
    }
    apply_set(document, "/transfer/type=flip", document.mistakes);
    const Scene scene = resolve_scene(document, catalogue);
    EXPECT_EQ(scene.space, SpaceId::of<Bar>());
    EXPECT_EQ(scene.resolved["bodies"]["b"]["particles_per_cell"], Json::array({5}));
}

TEST(scene, survives_any_single_value_of_a_wrong_type) {
    FakeCatalogue catalogue;
    // Resolved, because no unit is read then: many scenes are checked here.
    const Document document = parse_document(resolve().resolved.dump(), "a.json");
    for (const auto& [pointer, position] : document.positions) {
        for (const char* wrong : {"null", "[]", "{}", "-1e300", "true", "[[{}]]", ""}) {
            if (pointer.empty()) continue;
            Document changed = document;
            apply_set(changed, pointer + "=" + wrong, changed.mistakes);
            try {
                resolve_scene(changed, catalogue);
            } catch (const InputError& e) {
                for (const Diagnostic& d : e.diagnostics().all()) {
                    EXPECT_TRUE(d.pointer.starts_with(pointer) || pointer.starts_with(d.pointer) ||
                                d.message.starts_with("no \""))
                        << pointer << "=" << wrong << "\n"
                        << to_string(d);
                }
            }
        }
    }
    EXPECT_THROW(resolve_scene(parse_document("[1]", "a.json"), catalogue), InputError);
    EXPECT_THROW(resolve_scene(parse_document("{}", "a.json"), catalogue), InputError);
}

std::string mistakes_of(const std::string& setting) {
    try {
        resolve({setting});
    } catch (const InputError& e) {
        return e.what();
    }
    return "no error";
}

TEST(scene, refuses_what_would_do_nothing_or_never_end) {
    const std::vector<std::pair<std::string, std::string>> cases{
        {"/boundary_conditions/0/on=[]", "a face or a list of faces"},
        {"/checkpoint={\"keep\": 3}", "without one, no state is saved"},
        {"/bodies/disk/particles_per_cell=1e18", "at most 100 per axis"},
        {"/bodies/disk/particles_per_cell=[2, 1e300]", "at most 100 per axis"},
        {"/bodies={\"../disk\": {\"material\": \"rubber\", \"geometry\": {\"type\": \"box\", \"min\": [0, "
         "0], "
         "\"max\": [1, 1]}}}",
         "slashes"},
    };
    for (const auto& [setting, words] : cases)
        EXPECT_NE(mistakes_of(setting).find(words), std::string::npos) << setting << "\n"
                                                                       << mistakes_of(setting);
}

TEST(scene, refuses_outputs_that_write_one_file) {
    const auto complaint = [](const std::string& first, const std::string& second) {
        return complaints({"/outputs=[" + first + ", " + second + "]"});
    };
    const std::string tables = R"({"type": "tables", "name": "p"})";
    const auto probe = [](const std::string& name) {
        return R"({"type": "probe", "name": ")" + name + "\"}";
    };
    const auto clash = [](const std::string& file) {
        return "--set /outputs: error: /outputs/1/name: it would write " + file +
               ", as /outputs/0 does: choose another name";
    };
    EXPECT_EQ(complaint(tables, probe("p_times")), clash("p_times.csv"));
    EXPECT_EQ(complaint(probe("p_times"), tables), clash("p_times.csv"));
    EXPECT_EQ(complaint(tables, probe("p_disk_000017")), clash("p_disk_000017.csv"));
    EXPECT_EQ(complaint(tables, tables), clash("p_disk_000000.csv"));
    EXPECT_EQ(complaint(R"({"type": "tables", "name": "p", "body": "disk"})",
                        R"({"type": "tables", "name": "p", "body": "plane"})"),
              clash("p_times.csv"));
    EXPECT_EQ(complaint(probe("a"), probe("a")), clash("a.csv"));
    for (const char* other : {"p", "p_disk", "p_disk_17", "p_disk_00001x", "p_other_000017", "times"})
        EXPECT_EQ(complaint(tables, probe(other)), "");
    EXPECT_EQ(complaint(tables, R"({"type": "tables", "name": "p_disk"})"), "");
}

TEST(scene, tells_what_only_the_start_of_a_run_reads) {
    EXPECT_EQ(resolve().start_only,
              (std::vector<std::string>{
                  "/space", "/grid", "/materials/rubber/density", "/bodies/disk/particles_per_cell",
                  "/bodies/disk/seeding", "/bodies/disk/velocity", "/bodies/disk/overlaps",
                  "/bodies/disk/geometry", "/bodies/plane/particles_per_cell", "/bodies/plane/seeding",
                  "/bodies/plane/velocity", "/bodies/plane/overlaps", "/bodies/plane/geometry"}));
}

TEST(scene, warns_of_checkpoints_that_never_come) {
    EXPECT_EQ(complaints({"/checkpoint={\"every\": \"10 ms\"}"}), "");
    EXPECT_EQ(complaints({"/checkpoint={\"every\": \"11 ms\"}"}),
              "--set /checkpoint: warning: /checkpoint/every: no state is ever saved: the run ends before\n");
}

}  // namespace
}  // namespace matpoint
