#include <cstring>

#include "output_fixture.hpp"

namespace matpoint {
namespace {

TEST_F(OutputTest, CsvHasARowPerParticleAndAFilePerBodyAndWrite) {
    const auto csv =
        make({{"type", "csv"}, {"name", "state"}, {"fields", {"velocity", "stress", "plastic_strain"}}});
    csv->open(run, folder, -1);
    write_at(*csv, 0, 0);
    write_at(*csv, 0.25, 3);
    EXPECT_EQ(text_of("state_disk_000001.csv"),
              "x,y,velocity_x,velocity_y,stress_xx,stress_yy,stress_zz,stress_xy,plastic_strain\n"
              "0.1,1.1,0.3333333333333333,4,11,21,31,41,0.5\n"
              "0.2,1.2,-2,5,12,22,32,42,0.25\n"
              "0.3,1.3,3,6e-300,13,23,33,43,0.125\n");
    EXPECT_EQ(text_of("state_plane_000000.csv"),
              "x,y,velocity_x,velocity_y,stress_xx,stress_yy,stress_zz,stress_xy\n9,8,-7,-6,1,2,3,4\n");
    EXPECT_EQ(text_of("state_times.csv"), "time,step,index\n0,0,0\n0.25,3,1\n");
}

TEST_F(OutputTest, CsvReadsBackBitForBit) {
    std::vector<double> values;
    unsigned long long bits = 88172645463325252ULL;
    while (values.size() < 1000) {  // xorshift: all signs, exponents and mantissas
        bits ^= bits << 13;
        bits ^= bits >> 7;
        bits ^= bits << 17;
        double value = 0;
        std::memcpy(&value, &bits, sizeof value);
        if (value == value) values.push_back(value);
    }
    run.data = {{"b", {{"mass", {values}}, {"position", {values, values}}}}};
    const auto csv = make({{"type", "csv"}, {"fields", {"mass"}}});
    csv->open(run, folder, -1);
    write_at(*csv, 0, 0);
    std::istringstream lines(text_of("particles_b_000000.csv"));
    std::string line;
    std::getline(lines, line);
    for (const double value : values) {
        std::getline(lines, line);
        const double read = std::strtod(line.substr(line.rfind(',') + 1).c_str(), nullptr);
        EXPECT_EQ(std::memcmp(&read, &value, sizeof value), 0) << line;
    }
}

TEST_F(OutputTest, CsvKeepsToItsBodyAndDigits) {
    const auto csv = make({{"type", "csv"}, {"body", "disk"}, {"fields", {"velocity"}}, {"precision", 3}});
    EXPECT_EQ(csv->body(), "disk");
    EXPECT_EQ(csv->required_fields(), std::vector<std::string>{"velocity"});
    csv->open(run, folder, -1);
    write_at(*csv, 0, 0);
    EXPECT_SAYS(text_of("particles_disk_000000.csv"), "\n0.1,1.1,0.333,4\n");
    EXPECT_FALSE(exists("particles_plane_000000.csv"));
}

TEST_F(OutputTest, CsvGoesOnAfterTheCheckpoint) {
    const Json own{{"type", "csv"}, {"fields", {"mass"}}};
    auto csv = make(own);
    csv->open(run, folder, -1);
    for (int k = 0; k < 4; ++k) write_at(*csv, 0.1 * k, k);
    csv = make(own);
    csv->open(run, folder, 0.1);
    write_at(*csv, 0.1, 1);  // written before
    run.data["disk"]["mass"] = {{100, 200, 300}};
    write_at(*csv, 0.5, 9);
    EXPECT_EQ(text_of("particles_times.csv"), "time,step,index\n0,0,0\n0.1,1,1\n0.5,9,2\n");
    EXPECT_SAYS(text_of("particles_disk_000001.csv"), ",5\n");
    EXPECT_SAYS(text_of("particles_disk_000002.csv"), ",300\n");
}

TEST_F(OutputTest, CsvSaysWhichFieldsThereAre) {
    const auto csv = make({{"type", "csv"}, {"fields", {"plastic_stran"}}});
    const std::string error = error_of([&] { csv->open(run, folder, -1); });
    EXPECT_SAYS(error, "\"plastic_stran\"");
    EXPECT_SAYS(error, "plastic_strain, position, stress, velocity");
    const auto of_plane = make({{"type", "csv"}, {"body", "plane"}, {"fields", {"plastic_strain"}}});
    EXPECT_SAYS(error_of([&] { of_plane->open(run, folder, -1); }), "body \"plane\" does not carry");
}

TEST_F(OutputTest, NamesOfFilesMustBePlain) {
    EXPECT_TRUE(refusals({{"type", "csv"}, {"name", "a-b_1.x"}}).empty());
    for (const char* name : {"", "../x", "a b", "a<b"})
        EXPECT_EQ(refusals({{"type", "csv"}, {"name", name}}).size(), 1u) << name;
}

}  // namespace
}  // namespace matpoint
