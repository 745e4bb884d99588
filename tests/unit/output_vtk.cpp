#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <regex>

#include "output_fixture.hpp"

namespace matpoint {
namespace {

/// An array of a .vtp file, decompressed as VTK's description of the format says.
template <class T>
std::vector<T> array_of(const std::string& file, const std::string& name, const std::string& type,
                        int components) {
    const std::regex tag("<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
                         std::to_string(components) + "\" format=\"appended\" offset=\"(\\d+)\"/>");
    std::smatch match;
    const std::size_t appended = file.find("<AppendedData encoding=\"raw\">");
    const std::string xml = file.substr(0, appended);
    if (!std::regex_search(xml, match, tag)) throw std::runtime_error("no array " + name + " in " + xml);
    const char* at = file.data() + file.find('_', appended) + 1 + std::stoul(match[1]);
    const auto next = [&at] {
        std::uint64_t value = 0;
        std::memcpy(&value, at, sizeof value);
        at += sizeof value;
        return value;
    };
    const std::uint64_t blocks = next(), full = next(), last = next();
    std::vector<std::uint64_t> compressed(blocks);
    for (std::uint64_t& size : compressed) size = next();
    std::string bytes;
    for (std::uint64_t b = 0; b < blocks; ++b) {
        const std::uint64_t expected = b + 1 == blocks && last > 0 ? last : full;
        std::string block(expected, '\0');
        uLongf size = expected;
        const int status = uncompress(reinterpret_cast<Bytef*>(block.data()), &size,
                                      reinterpret_cast<const Bytef*>(at), compressed[b]);
        if (status != Z_OK || size != expected) throw std::runtime_error("a block of " + name + " is broken");
        at += compressed[b];
        bytes += block;
    }
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
}

using Doubles = std::vector<double>;

TEST_F(OutputTest, VtkHasAllBodiesInOneFile) {
    const auto vtk =
        make({{"type", "vtk"}, {"fields", {"velocity", "stress", "deformation_gradient", "plastic_strain"}}});
    vtk->open(run, folder, -1);
    write_at(*vtk, 0.125, 4);
    const std::string file = text_of("particles_000000.vtp");
    EXPECT_SAYS(file, "NumberOfPoints=\"4\" NumberOfVerts=\"4\"");
    EXPECT_SAYS(file, "Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">0.125<");
    EXPECT_EQ(array_of<double>(file, "Points", "Float64", 3),
              (Doubles{.1, 1.1, 0, .2, 1.2, 0, .3, 1.3, 0, 9, 8, 0}));
    EXPECT_EQ(array_of<double>(file, "velocity", "Float64", 3),
              (Doubles{1.0 / 3, 4, 0, -2, 5, 0, 3, 6e-300, 0, -7, -6, 0}));
    EXPECT_EQ(array_of<double>(file, "stress", "Float64", 6),
              (Doubles{11, 21, 31, 41, 0, 0, 12, 22, 32, 42, 0, 0, 13, 23, 33, 43, 0, 0, 1, 2, 3, 4, 0, 0}));
    EXPECT_EQ(array_of<std::int32_t>(file, "body", "Int32", 1), (std::vector<std::int32_t>{0, 0, 0, 1}));
    EXPECT_EQ(array_of<std::int64_t>(file, "connectivity", "Int64", 1),
              (std::vector<std::int64_t>{0, 1, 2, 3}));
    EXPECT_EQ(array_of<std::int64_t>(file, "offsets", "Int64", 1), (std::vector<std::int64_t>{1, 2, 3, 4}));
    // Stored by column, written by row; the body `plane` carries none.
    const Doubles gradient = array_of<double>(file, "deformation_gradient", "Float64", 9);
    EXPECT_EQ(Doubles(gradient.begin(), gradient.begin() + 9), (Doubles{1, 7, 0, 4, 10, 0, 0, 0, 0}));
    EXPECT_TRUE(std::isnan(gradient[27]) && std::isnan(gradient[35]));
    const Doubles strain = array_of<double>(file, "plastic_strain", "Float64", 1);
    EXPECT_EQ(strain[2], 0.125);
    EXPECT_TRUE(std::isnan(strain[3]));
}

TEST_F(OutputTest, VtkWritesSinglePrecisionOfSingleScenesOrWhenAsked) {
    const auto halved = make({{"type", "vtk"}, {"name", "halved"}, {"precision", "single"}});
    run.id.single = true;
    const auto of_scene = make({{"type", "vtk"}, {"name", "own"}});
    for (const auto& vtk : {halved, of_scene}) {
        vtk->open(run, folder, -1);
        write_at(*vtk, 0, 0);
    }
    for (const char* name : {"halved_000000.vtp", "own_000000.vtp"})
        EXPECT_EQ(array_of<float>(text_of(name), "velocity", "Float32", 3)[0], 1.0f / 3);
}

TEST_F(OutputTest, VtkTensorsOfOtherSpaces) {
    run.id = {Mode::solid, false};
    run.data = {{"b",
                 {{"mass", {{1}}},
                  {"position", {{1}, {2}, {3}}},
                  {"stress", {{1}, {2}, {3}, {4}, {5}, {6}}},
                  {"velocity_gradient", {{1}, {2}, {3}, {4}, {5}, {6}, {7}, {8}, {9}}}}}};
    const auto solid =
        make({{"type", "vtk"}, {"name", "solid"}, {"fields", {"stress", "velocity_gradient"}}});
    solid->open(run, folder, -1);
    write_at(*solid, 0, 0);
    EXPECT_EQ(array_of<double>(text_of("solid_000000.vtp"), "stress", "Float64", 6),
              (Doubles{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(array_of<double>(text_of("solid_000000.vtp"), "velocity_gradient", "Float64", 9),
              (Doubles{1, 4, 7, 2, 5, 8, 3, 6, 9}));

    run.id = {Mode::axisymmetric, false};
    run.data = {
        {"b",
         {{"mass", {{1}}}, {"position", {{1}, {2}}}, {"deformation_gradient", {{1}, {2}, {3}, {4}, {5}}}}}};
    const auto ring = make({{"type", "vtk"}, {"name", "ring"}, {"fields", {"deformation_gradient"}}});
    ring->open(run, folder, -1);
    write_at(*ring, 0, 0);
    EXPECT_EQ(array_of<double>(text_of("ring_000000.vtp"), "deformation_gradient", "Float64", 9),
              (Doubles{1, 3, 0, 2, 4, 0, 0, 0, 5}));

    run.id = {Mode::bar, false};
    run.data = {{"b",
                 {{"mass", {{1}}},
                  {"position", {{7}}},
                  {"velocity", {{8}}},
                  {"stress", {{9}}},
                  {"density", {{10}}}}}};
    const auto bar = make({{"type", "vtk"}, {"name", "bar"}, {"fields", {"velocity", "stress", "density"}}});
    bar->open(run, folder, -1);
    write_at(*bar, 0, 0);
    const std::string file = text_of("bar_000000.vtp");
    EXPECT_EQ(array_of<double>(file, "Points", "Float64", 3), (Doubles{7, 0, 0}));
    EXPECT_EQ(array_of<double>(file, "velocity", "Float64", 3), (Doubles{8, 0, 0}));
    EXPECT_EQ(array_of<double>(file, "stress", "Float64", 6), (Doubles{9, 0, 0, 0, 0, 0}));
    EXPECT_EQ(array_of<double>(file, "density", "Float64", 1), (Doubles{10}));
}

TEST_F(OutputTest, VtkSplitsLongArraysIntoBlocks) {
    for (const std::size_t count : {0ul, 1ul, 32768ul, 50000ul}) {  // 32768 doubles fill a block exactly
        std::vector<double> values(count);
        for (std::size_t p = 0; p < count; ++p) values[p] = std::sin(static_cast<double>(p));
        run.data = {{"b", {{"mass", {values}}, {"position", {values, values}}}}};
        const auto vtk = make({{"type", "vtk"}, {"fields", {"mass"}}});
        vtk->open(run, folder, -1);
        write_at(*vtk, 0, 0);
        EXPECT_EQ(array_of<double>(text_of("particles_000000.vtp"), "mass", "Float64", 1), values) << count;
    }
}

TEST_F(OutputTest, VtkSeriesIsWholeAfterEveryWriteAndGoesOnAfterTheCheckpoint) {
    const Json own{{"type", "vtk"}, {"name", "s"}, {"body", "plane"}};
    auto vtk = make(own);
    vtk->open(run, folder, -1);
    const auto entry = [](const char* time, const char* number) {
        return std::string("<DataSet timestep=\"") + time + "\" part=\"0\" file=\"s_00000" + number +
               ".vtp\"/>";
    };
    write_at(*vtk, 0, 0);
    EXPECT_SAYS(text_of("s.pvd"), entry("0", "0"));
    EXPECT_SAYS(text_of("s.pvd"), "</VTKFile>");
    write_at(*vtk, 1.0 / 3, 1);
    write_at(*vtk, 2.0 / 3, 2);
    EXPECT_SAYS(text_of("s.pvd"), entry("0.6666666666666666", "2"));

    vtk = make(own);
    vtk->open(run, folder, 1.0 / 3);
    write_at(*vtk, 1.0 / 3, 1);  // written before
    run.data["plane"]["velocity"] = {{42}, {43}};
    write_at(*vtk, 0.75, 3);
    const std::string series = text_of("s.pvd");
    EXPECT_SAYS(series,
                entry("0.3333333333333333", "1") + "\n    " + entry("0.75", "2") + "\n  </Collection>");
    EXPECT_EQ(array_of<double>(text_of("s_000002.vtp"), "velocity", "Float64", 3), (Doubles{42, 43, 0}));
    EXPECT_EQ(array_of<std::int32_t>(text_of("s_000002.vtp"), "body", "Int32", 1),
              std::vector<std::int32_t>{1});
    EXPECT_FALSE(exists("s_000003.vtp"));
}

TEST_F(OutputTest, VtkHasToolsAsASecondPartOfTheSeries) {
    run.contact_names = {"pair", "indenter", "die"};
    auto vtk = make({{"type", "vtk"}});
    vtk->open(run, folder, -1);
    write_at(*vtk, 0.25, 0);
    write_at(*vtk, 0.5, 1);
    const std::string file = text_of("particles_tools_000001.vtp");
    EXPECT_SAYS(file,
                "NumberOfPoints=\"4\" NumberOfVerts=\"0\" NumberOfLines=\"2\" NumberOfStrips=\"0\" "
                "NumberOfPolys=\"0\"");
    EXPECT_SAYS(file, "      </Lines>");
    EXPECT_EQ(array_of<double>(file, "Points", "Float64", 3),
              (Doubles{0, 0, 0, 1, .5, 0, 0, 0, 0, 1, .5, 0}));
    EXPECT_EQ(array_of<std::int64_t>(file, "connectivity", "Int64", 1),
              (std::vector<std::int64_t>{1, 0, 3, 2}));
    EXPECT_EQ(array_of<std::int64_t>(file, "offsets", "Int64", 1), (std::vector<std::int64_t>{2, 4}));
    EXPECT_EQ(array_of<std::int32_t>(file, "tool", "Int32", 1), (std::vector<std::int32_t>{0, 0, 1, 1}));
    const auto entry = [](const char* time, const char* part, const char* name) {
        return std::string("<DataSet timestep=\"") + time + "\" part=\"" + part + "\" file=\"" + name +
               ".vtp\"/>";
    };
    vtk = make({{"type", "vtk"}});
    vtk->open(run, folder, 0.25);  // the second is written again
    EXPECT_FALSE(exists("particles_tools_000001.vtp"));
    write_at(*vtk, 0.75, 1);
    EXPECT_SAYS(text_of("particles.pvd"), entry("0.25", "0", "particles_000000") + "\n    " +
                                              entry("0.25", "1", "particles_tools_000000") + "\n    " +
                                              entry("0.75", "0", "particles_000001") + "\n    " +
                                              entry("0.75", "1", "particles_tools_000001"));
}

TEST_F(OutputTest, FilesOfAnEarlierRunGoAndOthersStay) {
    for (const char* file :
         {"s_000000.vtp", "s_000007.vtp", "s_1000000.vtp", "s_000008.vtp.tmp", "s_00001.vtp", "s_000000.vtu",
          "other_000000.vtp", "s_x_000000.vtp", "t_disk_000003.csv", "t_plane_000004.csv.tmp",
          "t_third_000003.csv", "t_disk_notes.csv"})
        std::ofstream(folder / file) << "old";
    const auto vtk = make({{"type", "vtk"}, {"name", "s"}}), csv = make({{"type", "csv"}, {"name", "t"}});
    for (const auto& output : {vtk, csv}) {
        output->open(run, folder, -1);
        write_at(*output, 0, 0);
        write_at(*output, 1, 1);
    }
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        files.push_back(entry.path().filename().string());
    std::sort(files.begin(), files.end());
    EXPECT_EQ(files,
              (std::vector<std::string>{"other_000000.vtp", "s.pvd", "s_000000.vtp", "s_000000.vtu",
                                        "s_000001.vtp", "s_00001.vtp", "s_x_000000.vtp", "t_disk_000000.csv",
                                        "t_disk_000001.csv", "t_disk_notes.csv", "t_plane_000000.csv",
                                        "t_plane_000001.csv", "t_third_000003.csv", "t_times.csv"}));
    // One that resumes keeps what was before.
    for (const auto& output :
         {make({{"type", "vtk"}, {"name", "s"}}), make({{"type", "csv"}, {"name", "t"}})})
        output->open(run, folder, 0.5);
    EXPECT_TRUE(exists("s_000000.vtp") && exists("t_disk_000000.csv") && exists("t_plane_000000.csv"));
    EXPECT_FALSE(exists("s_000001.vtp") || exists("t_disk_000001.csv") || exists("t_plane_000001.csv"));
}

}  // namespace
}  // namespace matpoint
