#include "checkpoint_fixture.hpp"

namespace matpoint {
namespace {

TEST_F(CheckpointTest, ReadsBackBitForBit) {
    const CheckpointData data = delicate_data();
    write_checkpoint(file, data);
    EXPECT_TRUE(same(data, read_checkpoint(file)));
}

TEST_F(CheckpointTest, TheComparisonOfTheseTestsSeesABit) {
    const CheckpointData data = delicate_data();
    CheckpointData other = data;
    EXPECT_TRUE(same(data, other));
    auto& values = std::get<std::vector<double>>(other.bodies[0].columns[0].values);
    values[0] = std::bit_cast<double>(std::bit_cast<std::uint64_t>(values[0]) ^ 1);
    EXPECT_FALSE(same(data, other));
}

TEST_F(CheckpointTest, NothingAtAllReadsBackToo) {
    write_checkpoint(file, {});
    EXPECT_TRUE(same({}, read_checkpoint(file)));
}

TEST_F(CheckpointTest, LongColumnsSpanSeveralChunks) {
    CheckpointData data;
    std::vector<double> values(500001);
    for (std::size_t p = 0; p < values.size(); ++p) values[p] = 1.0 / static_cast<double>(p);
    data.bodies = {{"b", 500001, {{"mass", 0, values}}, {}, {}, {}}};
    data.scene.assign(3000000, 's');
    write_checkpoint(file, data);
    EXPECT_TRUE(same(data, read_checkpoint(file)));
}

TEST_F(CheckpointTest, TheSameStateGivesTheSameFile) {
    const fs::path other = folder / "other.h5";
    write_checkpoint(file, delicate_data());
    write_checkpoint(other, delicate_data());
    EXPECT_EQ(bytes_of(file), bytes_of(other));
}

TEST_F(CheckpointTest, ANewerOneReplacesTheOld) {
    write_checkpoint(file, delicate_data());
    CheckpointData later = delicate_data();
    later.step = 2;
    write_checkpoint(file, later);
    EXPECT_EQ(read_checkpoint(file).step, 2);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace matpoint
