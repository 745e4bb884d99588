#include "output_fixture.hpp"

namespace matpoint {
namespace {

class ProbeTest : public OutputTest {
  protected:
    /// The table after one write at time 0.5.
    std::string table(Json own) {
        own["type"] = "probe";
        own["name"] = "p";
        const auto probe = make(own);
        probe->check(run);
        probe->open(run, folder, -1);
        write_at(*probe, 0.5, 5);
        return text_of("p.csv");
    }
    std::vector<std::string> refused(Json own) {
        own["type"] = "probe";
        own["name"] = "p";
        return refusals(own);
    }
};

TEST_F(ProbeTest, MeasuresEveryQuantity) {
    // Masses 1 2 5: (0.1 + 0.4 + 1.5) / 8.
    EXPECT_EQ(table({{"quantity", "centroid"}, {"body", "disk"}, {"component", "x"}}),
              "time,centroid_x\n0.5,0.25\n");
    EXPECT_EQ(table({{"quantity", "centroid"}, {"component", "x"}}), "time,centroid_x\n0.5,2\n");
    EXPECT_EQ(table({{"quantity", "reaction"}, {"boundary_condition", "wall"}}),
              "time,reaction_x,reaction_y\n0.5,-1,-2\n");
    EXPECT_EQ(table({{"quantity", "kinetic_energy"}}), "time,kinetic_energy\n0.5,1.5\n");
    EXPECT_EQ(table({{"quantity", "kinetic_energy"}, {"body", "plane"}}), "time,kinetic_energy\n0.5,85\n");
    EXPECT_EQ(table({{"quantity", "strain_energy"}}), "time,strain_energy\n0.5,2.5\n");
    EXPECT_EQ(table({{"quantity", "external_work"}}), "time,external_work\n0.5,0.25\n");
    EXPECT_EQ(table({{"quantity", "total_energy"}}), "time,total_energy\n0.5,3.875\n");
    EXPECT_EQ(table({{"quantity", "damped_energy"}}), "time,damped_energy\n0.5,0.125\n");
    EXPECT_EQ(table({{"quantity", "unbalanced_force"}}), "time,unbalanced_force\n0.5,0.01\n");
    EXPECT_EQ(table({{"quantity", "noise"}}), "time,noise\n0.5,0.02\n");
    EXPECT_EQ(table({{"quantity", "momentum"}}), "time,momentum_x,momentum_y\n0.5,7,8\n");
    EXPECT_EQ(table({{"quantity", "momentum"}, {"body", "plane"}, {"component", "y"}}),
              "time,momentum_y\n0.5,-12\n");
    EXPECT_EQ(table({{"quantity", "mass"}}), "time,mass\n0.5,77\n");
    EXPECT_EQ(table({{"quantity", "mass"}, {"body", "disk"}}), "time,mass\n0.5,8\n");
    EXPECT_EQ(table({{"quantity", "min"}, {"field", "velocity"}}),
              "time,min_velocity_x,min_velocity_y\n0.5,-7,-6\n");
    EXPECT_EQ(table({{"quantity", "max"}, {"field", "stress"}, {"component", "xy"}}),
              "time,max_stress_xy\n0.5,43\n");
    EXPECT_EQ(table({{"quantity", "mean"}, {"field", "stress"}, {"body", "disk"}, {"component", "zz"}}),
              "time,mean_stress_zz\n0.5,32\n");
    EXPECT_EQ(table({{"quantity", "max"}, {"field", "plastic_strain"}}),
              "time,max_plastic_strain\n0.5,0.5\n");
    EXPECT_EQ(table({{"quantity", "particle"}, {"body", "disk"}, {"particle", 2}, {"field", "position"}}),
              "time,position_x,position_y\n0.5,0.3,1.3\n");
    EXPECT_EQ(table({{"quantity", "particle"},
                     {"body", "disk"},
                     {"at", {0.9, 1.4}},
                     {"field", "stress"},
                     {"component", "xx"}}),
              "time,stress_xx\n0.5,12\n");
    EXPECT_EQ(
        table(
            {{"quantity", "particle"}, {"body", "disk"}, {"particle", 0}, {"field", "deformation_gradient"}}),
        "time,deformation_gradient_xx,deformation_gradient_yx,deformation_gradient_xy,deformation_gradient_"
        "yy\n"
        "0.5,1,4,7,10\n");
}

TEST_F(ProbeTest, ADeletedParticleHasNoValueAndOthersKeepTheirs) {
    const auto probe = make({{"type", "probe"},
                             {"name", "p"},
                             {"quantity", "particle"},
                             {"body", "disk"},
                             {"particle", 1},
                             {"field", "plastic_strain"}});
    probe->check(run);
    probe->open(run, folder, -1);
    run.data["disk"]["id"] = {{1, 2}};
    run.data["disk"]["plastic_strain"] = {{0.25, 0.125}};
    write_at(*probe, 0, 0);
    run.data["disk"]["id"] = {{2}};
    run.data["disk"]["plastic_strain"] = {{0.125}};
    write_at(*probe, 1, 1);
    EXPECT_EQ(text_of("p.csv"), "time,plastic_strain\n0,0.25\n1,nan\n");
}

TEST_F(ProbeTest, APlaceFarFromEveryParticleIsRefused) {
    const auto at = [&](double x, double y) {
        return error_of([&] {
            table({{"quantity", "particle"}, {"body", "disk"}, {"at", {x, y}}, {"field", "velocity"}});
        });
    };
    // Particles of size 1 at (0, 0), (1, 1), (2, 2): "far" is beyond three sizes.
    EXPECT_EQ(at(2, 4.99), "");
    EXPECT_SAYS(
        at(2, 5.5),
        "`at` (2, 5.5) is far from body \"disk\": the nearest particle, number 2 at (2, 2), is 3.5 m away");
    run.data["disk"]["volume"] = {{0.25, 1e-6, 0.25}};  // cut ones are no measure
    EXPECT_EQ(at(2, 3.49), "");
    EXPECT_SAYS(at(2, 3.51), "is 1.51 m away");
    // A ring's volume is not its size.
    run.id = {Mode::axisymmetric, false};
    run.data["disk"]["position"] = {{100, 101, 102}, {0, 1, 2}};
    run.data["disk"]["initial_position"] = run.data["disk"]["position"];
    run.data["disk"]["volume"] = {{2 * 3.14159265 * 100, 2 * 3.14159265 * 101, 2 * 3.14159265 * 102}};
    EXPECT_EQ(at(102, 4.99), "");
    EXPECT_SAYS(at(102, 5.01), "is 3.01 m away");
}

TEST_F(ProbeTest, AParticleThatWasDeletedIsNotReplacedOnResumption) {
    const Json by_number{{"type", "probe"}, {"name", "p"},   {"quantity", "particle"},
                         {"body", "disk"},  {"particle", 2}, {"field", "plastic_strain"}};
    Json by_place = by_number;
    by_place.erase("particle");
    by_place["at"] = {2, 2};
    for (const Json& own : {by_number, by_place}) {
        FakeRun started = run;
        const auto probe = make(own);
        probe->check(started);
        started.data["disk"]["id"] = {{0, 1}};
        started.data["disk"]["plastic_strain"] = {{0.5, 0.25}};
        started.data["disk"]["initial_position"] = {{0, 1}, {0, 1}};
        probe->open(started, folder, 1);
        started.now = 2;
        probe->write(started);
        EXPECT_SAYS(text_of("p.csv"), "\n2,nan\n");
    }
}

TEST_F(ProbeTest, AsksForTheFieldsItNeeds) {
    using Names = std::vector<std::string>;
    EXPECT_EQ(make({{"type", "probe"}, {"name", "p"}, {"quantity", "max"}, {"field", "displacement"}})
                  ->required_fields(),
              Names{"displacement"});
    EXPECT_EQ(make({{"type", "probe"},
                    {"name", "p"},
                    {"quantity", "particle"},
                    {"body", "disk"},
                    {"at", {0, 0}},
                    {"field", "velocity"}})
                  ->required_fields(),
              (Names{"velocity", "id", "initial_position"}));
    EXPECT_EQ(make({{"type", "probe"}, {"name", "p"}, {"quantity", "mass"}})->required_fields(), Names{});
}

TEST_F(ProbeTest, KeysThatDoNotGoTogetherAreRefused) {
    EXPECT_TRUE(refused({{"quantity", "mass"}}).empty());
    EXPECT_TRUE(
        refused({{"quantity", "reaction"}, {"boundary_condition", "wall"}, {"component", "y"}}).empty());
    EXPECT_TRUE(refused({{"quantity", "particle"}, {"body", "disk"}, {"particle", 0}, {"field", "velocity"}})
                    .empty());
    const auto only = [&](const Json& own, const std::string& expected) {
        const std::vector<std::string> reasons = refused(own);
        ASSERT_EQ(reasons.size(), 1u) << own;
        EXPECT_SAYS(reasons[0], expected);
    };
    only({{"quantity", "total_energy"}, {"body", "disk"}},
         "/body: the quantity \"total_energy\" takes no `body`");
    only({{"quantity", "mass"}, {"component", "x"}}, "takes no `component`; these do: particle, centroid");
    only({{"quantity", "max"}}, "needs the key `field`");
    only({{"quantity", "reaction"}}, "needs the key `boundary_condition`");
    only({{"quantity", "reaction"}, {"boundary_condition", "wal"}}, "no boundary condition has this name");
    only({{"quantity", "centroid"}, {"component", "z"}}, "as many as the space has dimensions");
    only({{"quantity", "centroid"}, {"component", "xx"}}, "as many as the space has dimensions");
    only({{"quantity", "particle"}, {"body", "disk"}, {"field", "velocity"}}, "either `particle` or `at`");
    only({{"quantity", "particle"}, {"body", "disk"}, {"field", "velocity"}, {"particle", 0}, {"at", {0, 0}}},
         "either `particle` or `at`");
}

TEST_F(ProbeTest, WhatTheRunLacksIsNamed) {
    EXPECT_SAYS(error_of([&] {
                    table({{"quantity", "max"}, {"field", "stress"}, {"component", "yz"}});
                }),
                "component yz of \"max_stress\", which has xx, yy, zz, xy");
    EXPECT_SAYS(error_of([&] {
                    table({{"quantity", "max"}, {"field", "plastic_strain"}, {"component", "x"}});
                }),
                "one number only");
    EXPECT_SAYS(
        error_of([&] {
            table({{"quantity", "particle"}, {"body", "disk"}, {"particle", 3}, {"field", "velocity"}});
        }),
        "particles are 0 to 2");
}

TEST_F(ProbeTest, ARowIsOnTheDiskAtOnceAndLaterOnesAreCutOnResumption) {
    const Json own{{"type", "probe"}, {"name", "p"}, {"quantity", "mass"}, {"body", "disk"}};
    const auto opened = [&](double resumed_at) {
        const auto probe = make(own);
        probe->check(run);
        probe->open(run, folder, resumed_at);
        return probe;
    };
    const auto probe = opened(-1);
    for (int k = 0; k < 4; ++k) {
        write_at(*probe, k / 3.0, k);
        EXPECT_SAYS(text_of("p.csv"), k == 1 ? "0.3333333333333333,8\n" : ",8\n");
    }
    write_at(*probe, 1.0, 3);  // the end, which was due too
    EXPECT_EQ(text_of("p.csv"), "time,mass\n0,8\n0.3333333333333333,8\n0.6666666666666666,8\n1,8\n");

    std::ofstream(folder / "p.csv", std::ios::app) << "1.33";  // killed while it wrote
    const auto resumed = opened(2 / 3.0);
    run.data["disk"]["mass"] = {{3}};
    write_at(*resumed, 2 / 3.0, 2);
    write_at(*resumed, 5, 6);
    EXPECT_EQ(text_of("p.csv"), "time,mass\n0,8\n0.3333333333333333,8\n0.6666666666666666,8\n5,3\n");

    opened(-1);
    EXPECT_EQ(text_of("p.csv"), "time,mass\n");
    std::ofstream(folder / "p.csv") << "time,centroid_x\n";
    EXPECT_SAYS(error_of([&] { opened(1); }), "has the columns time,centroid_x");
}

TEST_F(ProbeTest, AHalfWrittenRowIsDropped) {
    std::ofstream(folder / "p.csv") << "time,mass\n0,8\n1,12";
    const auto probe = make({{"type", "probe"}, {"name", "p"}, {"quantity", "mass"}});
    probe->check(run);
    probe->open(run, folder, 1);
    EXPECT_EQ(text_of("p.csv"), "time,mass\n0,8\n");
}

}  // namespace
}  // namespace matpoint
