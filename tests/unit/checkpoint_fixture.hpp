#pragma once

#include "run/checkpoint_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace matpoint {

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << "in: " << (text)

namespace fs = std::filesystem;

class CheckpointTest : public testing::Test {
  protected:
    CheckpointTest() {
        std::string name = (fs::temp_directory_path() / "matpoint_checkpoint_XXXXXX").string();
        folder = mkdtemp(name.data());
        file = folder / "checkpoint_00000042.h5";
    }
    ~CheckpointTest() override { fs::remove_all(folder); }

    static std::string bytes_of(const fs::path& path) {
        std::ifstream stream(path, std::ios::binary);
        std::ostringstream text;
        text << stream.rdbuf();
        return text.str();
    }
    static void put(const fs::path& path, const std::string& bytes) {
        std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
    }

    /// What the call throws; empty if it throws nothing.
    template <class Call>
    static std::string error_of(Call&& call) {
        try {
            call();
        } catch (const CheckpointError& error) {
            return error.what();
        }
        return "";
    }
    std::string error_of_reading() const {
        return error_of([&] { read_checkpoint(file); });
    }

    fs::path folder, file;
};

/// Numbers that a sloppy conversion would change: payload of a NaN, sign of a zero, denormals.
inline std::vector<double> delicate_doubles() {
    using Limits = std::numeric_limits<double>;
    return {std::bit_cast<double>(0x7ff8dead0000beefULL),
            std::bit_cast<double>(0xfff0000000000001ULL),
            -0.0,
            Limits::denorm_min(),
            -Limits::infinity(),
            Limits::max(),
            0.1,
            1.0 / 3};
}

inline CheckpointData delicate_data() {
    CheckpointData data;
    data.scene = "{ \"title\": \"Größe // \\u0000\" }\n";
    data.folder = "/home/user/scenes with blanks";
    data.step = 1234567890123L;
    data.time = 0.1 + 0.2;
    data.numbers = {{"external_work", -0.0},
                    {"energy drift", std::bit_cast<double>(0x7ff8000000000123ULL)},
                    {"next", 1e-310}};
    for (int k = 0; k < 40; ++k) data.numbers["accumulator_" + std::to_string(k)] = 1.0 / (k + 3);
    data.plugins = {{"gimp", "1.0.0"}, {"unnamed", ""}};
    const std::vector<double> doubles = delicate_doubles();
    const std::vector<float> floats{
        std::bit_cast<float>(0x7fc00bedU), -0.0f, std::numeric_limits<float>::denorm_min(), 0.1f, 3, 4, 5, 6};
    data.bodies = {
        {"disk",
         8,
         {{"position", 0, doubles}, {"stress", 3, floats}, {"position", 1, doubles}},
         {7, 6, 5, 4, 3, 2, 1, 4294967295u},
         {-3, 9},
         {0, 5, 9223372036854775807}},
        {"a/b", 0, {{"velocity", 0, std::vector<double>{}}, {"mass", 0, std::vector<float>{}}}, {}, {}, {}}};
    return data;
}

/// Equality of every bit.
inline bool same(const CheckpointData& a, const CheckpointData& b) {
    const auto same_list = [](const auto& x, const auto& y) {
        return x.size() == y.size() &&
               (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof x[0]) == 0);
    };
    const auto bits = [](double v) { return std::bit_cast<std::uint64_t>(v); };
    bool equal = a.scene == b.scene && a.folder == b.folder && a.step == b.step &&
                 bits(a.time) == bits(b.time) && a.plugins == b.plugins &&
                 a.numbers.size() == b.numbers.size() && a.bodies.size() == b.bodies.size();
    for (const auto& [name, value] : a.numbers)
        equal = equal && b.numbers.contains(name) && bits(value) == bits(b.numbers.at(name));
    for (std::size_t k = 0; equal && k < a.bodies.size(); ++k) {
        const CheckpointData::Body &x = a.bodies[k], &y = b.bodies[k];
        equal = x.name == y.name && x.size == y.size && x.ids == y.ids &&
                x.block_numbers == y.block_numbers && x.block_begins == y.block_begins &&
                x.columns.size() == y.columns.size();
        for (std::size_t c = 0; equal && c < x.columns.size(); ++c) {
            const CheckpointData::Column &p = x.columns[c], &q = y.columns[c];
            equal = p.field == q.field && p.component == q.component &&
                    p.values.index() == q.values.index() &&
                    std::visit(
                        [&](const auto& v) {
                            return same_list(v, std::get<std::decay_t<decltype(v)>>(q.values));
                        },
                        p.values);
        }
    }
    return equal;
}

}  // namespace matpoint
