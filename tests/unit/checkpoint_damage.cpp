#include "checkpoint_fixture.hpp"
#include "run/hdf5_file.hpp"
#include "run/seal.hpp"

namespace matpoint {
namespace {

TEST_F(CheckpointTest, AMissingFileAndAFolderAreToldApart) {
    EXPECT_SAYS(error_of_reading(), "checkpoint_00000042.h5: there is no such file");
    EXPECT_SAYS(error_of([&] { read_checkpoint(folder); }), "is a folder");
}

TEST_F(CheckpointTest, AForeignFileIsNotACheckpoint) {
    for (const std::string& bytes : {std::string(), std::string("{}"), std::string(100000, '\0')}) {
        put(file, bytes);
        EXPECT_SAYS(error_of_reading(), "is not even an HDF5 file");
    }
}

TEST_F(CheckpointTest, HDF5OfOthersIsToldFromOurs) {
    hdf5::MemoryFile others;
    const std::span<char> image = others.finish();
    put(file, {image.begin(), image.end()});
    EXPECT_SAYS(error_of_reading(), "an HDF5 file, but not a checkpoint that Matpoint wrote");
}

TEST_F(CheckpointTest, AnotherFormatNamesBothVersions) {
    for (const auto& [version, said] :
         {std::pair{7, "format version 7, and this Matpoint reads versions up to 2"},
          std::pair{1, "format version 1, whose particles carry other fields"}}) {
        hdf5::MemoryFile other(seal_size);
        hdf5::write_attribute(other, "version", std::int64_t{version});
        const std::span<char> image = other.finish();
        seal(image);
        put(file, {image.begin(), image.end()});
        EXPECT_SAYS(error_of_reading(), said);
    }
}

TEST_F(CheckpointTest, AWholeFileWithoutItsPartsIsSaid) {
    hdf5::MemoryFile empty(seal_size);
    hdf5::write_attribute(empty, "version", std::int64_t{2});
    const std::span<char> image = empty.finish();
    seal(image);
    put(file, {image.begin(), image.end()});
    EXPECT_SAYS(error_of_reading(), "can't be read");
}

TEST_F(CheckpointTest, CutAtAnyLengthItIsRefused) {
    write_checkpoint(file, delicate_data());
    const std::string bytes = bytes_of(file);
    for (std::size_t length = 0; length < bytes.size(); length += 509) {
        put(file, bytes.substr(0, length));
        EXPECT_SAYS(error_of_reading(), length < 50 ? "not even an HDF5 file" : "is cut short");
    }
    put(file, bytes.substr(0, bytes.size() - 1));
    EXPECT_SAYS(error_of_reading(), "is cut short");
    put(file, bytes + '\0');
    EXPECT_SAYS(error_of_reading(), "is damaged");
}

TEST_F(CheckpointTest, WithAnyByteChangedItIsRefused) {
    write_checkpoint(file, delicate_data());
    std::string bytes = bytes_of(file);
    for (std::size_t at = 0; at < bytes.size(); at += at < 600 ? 1 : 37) {
        const char original = bytes[at];
        bytes[at] = static_cast<char>(original ^ (1 << at % 8));
        put(file, bytes);
        const std::string error = error_of_reading();
        EXPECT_NE(error, "") << "byte " << at;
        if (at >= seal_size) {
            EXPECT_SAYS(error, "its checksum is wrong");
        }
        bytes[at] = original;
    }
}

TEST_F(CheckpointTest, ErrorsOfHDF5AreNotPrinted) {
    hdf5::MemoryFile empty(seal_size);
    const std::span<char> image = empty.finish();
    seal(image);
    put(file, {image.begin(), image.end()});
    testing::internal::CaptureStderr();
    EXPECT_NE(error_of_reading(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace matpoint
