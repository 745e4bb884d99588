#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// A VTK XML PolyData file (.vtp): points, each with its vertex cell, so that viewers show them as
/// they are, or a surface. The numbers are appended as raw binary blocks that zlib compresses.
class VtpFile {
  public:
    /// Coordinates, three a point; `single` stores floating point numbers in 32 bits.
    VtpFile(const std::vector<double>& points, double time, bool single);
    /// Of the points, three coordinates each, `corners` a cell: vertices (1), lines (2) or polygons.
    VtpFile(const std::vector<double>& points, const std::vector<std::int64_t>& cells, int corners,
            double time, bool single);

    void add_point_data(const std::string& name, int components, const std::vector<double>& values);
    void add_point_data(const std::string& name, const std::vector<std::int32_t>& values);
    void write(const std::filesystem::path& file) const;

  private:
    std::string real_array(const std::string& name, int components, const std::vector<double>& values);
    template <class T>
    std::string array(const char* type, const std::string& name, int components,
                      const std::vector<T>& values);

    bool single_;
    std::size_t count_, cell_count_;
    int corners_;
    double time_;
    std::string points_, cells_, point_data_;  // XML
    std::string appended_;
};
