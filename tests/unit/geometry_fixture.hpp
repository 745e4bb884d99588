#pragma once

#include "registry/catalogue.hpp"

#include <gtest/gtest.h>
#include <unistd.h>
#include <matpoint/geometry.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace matpoint {

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << "in: " << (text)

/// Makes geometries from their plugins, and has a folder of its own for their files.
class GeometryTest : public testing::Test {
  protected:
    GeometryTest() {
        std::string name = (std::filesystem::temp_directory_path() / "matpoint_geometry_XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~GeometryTest() override { std::filesystem::remove_all(folder); }

    std::shared_ptr<Geometry> make(Json own, int dimension = 3) {
        return make(std::move(own), dimension == 1   ? Mode::bar
                                    : dimension == 2 ? Mode::plane_strain
                                                     : Mode::solid);
    }
    std::shared_ptr<Geometry> make(Json own, Mode mode) {
        fill_defaults(own);
        const SpaceId space{mode, false};
        const auto warn = [this](const std::string& text) { warnings.push_back(text); };
        return catalogue.registry().make<Geometry>("geometry", own,
                                                   {space, folder, &catalogue.registry(), nullptr, warn});
    }

    /// What make() throws; empty if it throws nothing.
    std::string error_of(const Json& own, int dimension = 3) {
        try {
            make(own, dimension);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "";
    }

    /// Pointer of the parameter that a rule of the type refuses; empty if none does.
    std::string refused(Json own) {
        fill_defaults(own);
        for (const Rule& rule : schema_of(own).rules())
            if (rule.refuses && rule.applies(own, Json())) return rule.pointer;
        return "";
    }

    std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name, std::ios::binary) << text;
        return folder / name;
    }

    std::filesystem::path folder;
    PluginCatalogue catalogue;
    std::vector<std::string> warnings;

  private:
    const Schema& schema_of(const Json& own) {
        const Schema* schema = catalogue.find("geometry", own.at("type").get<std::string>());
        if (!schema) throw std::logic_error("no plugin for the geometry " + own.at("type").dump());
        return *schema;
    }
    void fill_defaults(Json& own) {
        for (const Parameter& parameter : schema_of(own).parameters()) {
            if (parameter.default_value && !own.contains(parameter.name))
                own[parameter.name] = *parameter.default_value;
            if (parameter.type == ParameterType::components)
                for (Json& nested : own[parameter.name]) fill_defaults(nested);
        }
    }
};

/// The particles that a geometry lists, a few at a time.
inline std::vector<PointCloud::Point> listed(const Geometry& geometry) {
    const PointCloud& cloud = *geometry.points();
    std::vector<PointCloud::Point> points(static_cast<std::size_t>(cloud.size()));
    constexpr std::size_t part = 7;
    for (std::size_t first = 0; first < points.size(); first += part)
        cloud.read(static_cast<Index>(first),
                   std::span(points).subspan(first, std::min(part, points.size() - first)));
    return points;
}

/// Points at the middle of cells of size h that cover the geometry's bounds, in its dimensions.
inline std::vector<Eigen::Vector3d> lattice(const Geometry& geometry, double h, int dimension) {
    Eigen::Vector3i n = Eigen::Vector3i::Ones();
    const Geometry::Bounds bounds = geometry.bounds();
    for (int a = 0; a < dimension; ++a)
        n[a] = static_cast<int>(std::ceil((bounds.max[a] - bounds.min[a]) / h - 1e-9));
    std::vector<Eigen::Vector3d> points;
    for (int k = 0; k < n[2]; ++k)
        for (int j = 0; j < n[1]; ++j)
            for (int i = 0; i < n[0]; ++i) {
                Eigen::Vector3d x = bounds.min + h * Eigen::Vector3d(i + 0.5, j + 0.5, k + 0.5);
                for (int a = dimension; a < 3; ++a) x[a] = 0;
                points.push_back(x);
            }
    return points;
}

/// Volume (area, length) of the cells of size h whose middle is in the geometry.
inline double measured_volume(const Geometry& geometry, double h, int dimension) {
    double count = 0;
    for (const char inside : geometry.contains(lattice(geometry, h, dimension))) count += inside;
    return count * std::pow(h, dimension);
}

}  // namespace matpoint
