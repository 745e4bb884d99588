#include "vtp_file.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <matpoint/output_file.hpp>
#include <numeric>
#include <stdexcept>

namespace {

constexpr std::size_t block_bytes = 256 * 1024;

template <class T>
void append_bytes(std::string& to, const T* data, std::size_t count) {
    to.append(reinterpret_cast<const char*>(data), count * sizeof(T));
}

/// VTK's compressed data: number of blocks, bytes of a full block, bytes of a last shorter block (or
/// 0), compressed bytes of each block, all as UInt64; then the blocks.
void append_compressed(std::string& to, const char* bytes, std::size_t size) {
    const std::size_t blocks = (size + block_bytes - 1) / block_bytes;
    std::vector<std::uint64_t> header{blocks, block_bytes, size % block_bytes};
    std::string data;
    std::string buffer(compressBound(block_bytes), '\0');
    for (std::size_t b = 0; b < blocks; ++b) {
        const std::size_t begin = b * block_bytes;
        uLongf length = buffer.size();
        const int status = compress2(reinterpret_cast<Bytef*>(buffer.data()), &length,
                                     reinterpret_cast<const Bytef*>(bytes + begin),
                                     std::min(block_bytes, size - begin), Z_BEST_SPEED);
        if (status != Z_OK)
            throw std::runtime_error("zlib could not compress the output: there is no memory left");
        data.append(buffer, 0, length);
        header.push_back(length);
    }
    append_bytes(to, header.data(), header.size());
    to += data;
}

std::vector<std::int64_t> from_zero(std::size_t count) {
    std::vector<std::int64_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

}  // namespace

VtpFile::VtpFile(const std::vector<double>& points, double time, bool single)
    : VtpFile(points, from_zero(points.size() / 3), 1, time, single) {}

VtpFile::VtpFile(const std::vector<double>& points, const std::vector<std::int64_t>& cells, int corners,
                 double time, bool single)
    : single_(single),
      count_(points.size() / 3),
      cell_count_(cells.size() / static_cast<std::size_t>(corners)),
      corners_(corners),
      time_(time) {
    points_ = real_array("Points", 3, points);
    cells_ = array("Int64", "connectivity", 1, cells);
    std::vector<std::int64_t> ends = from_zero(cell_count_);
    for (std::int64_t& end : ends) end = (end + 1) * corners;
    cells_ += array("Int64", "offsets", 1, ends);
}

void VtpFile::add_point_data(const std::string& name, int components, const std::vector<double>& values) {
    point_data_ += real_array(name, components, values);
}

void VtpFile::add_point_data(const std::string& name, const std::vector<std::int32_t>& values) {
    point_data_ += array("Int32", name, 1, values);
}

std::string VtpFile::real_array(const std::string& name, int components, const std::vector<double>& values) {
    if (!single_) return array("Float64", name, components, values);
    std::vector<float> narrow(values.size());
    std::transform(values.begin(), values.end(), narrow.begin(),
                   [](double v) { return static_cast<float>(v); });
    return array("Float32", name, components, narrow);
}

template <class T>
std::string VtpFile::array(const char* type, const std::string& name, int components,
                           const std::vector<T>& values) {
    const std::size_t offset = appended_.size();
    append_compressed(appended_, reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    return fmt::format(
        "        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
        "offset=\"{}\"/>\n",
        type, name, components, offset);
}

void VtpFile::write(const std::filesystem::path& file) const {
    const char* const kind = corners_ == 1 ? "Verts" : corners_ == 2 ? "Lines" : "Polys";
    const auto count_if = [&](int corners) { return std::min(corners_, 3) == corners ? cell_count_ : 0; };
    matpoint::OutputFile out(file);
    out.write(fmt::format(
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\" "
        "compressor=\"vtkZLibDataCompressor\">\n"
        "  <PolyData>\n"
        "    <FieldData>\n"
        "      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
        "format=\"ascii\">{}</DataArray>\n"
        "    </FieldData>\n"
        "    <Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
        "NumberOfPolys=\"{}\">\n"
        "      <PointData>\n{}      </PointData>\n"
        "      <Points>\n{}      </Points>\n"
        "      <{}>\n{}      </{}>\n"
        "    </Piece>\n"
        "  </PolyData>\n"
        "  <AppendedData encoding=\"raw\">\n_",
        std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian",
        matpoint::number_text(time_), count_, count_if(1), count_if(2), count_if(3), point_data_, points_,
        kind, cells_, kind));
    out.write(appended_);
    out.write("\n  </AppendedData>\n</VTKFile>\n");
    out.commit();
}
