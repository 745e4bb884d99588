#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <matpoint/background_writer.hpp>
#include <matpoint/field_shape.hpp>
#include <matpoint/output_file.hpp>
#include <matpoint/plugin.hpp>
#include <optional>
#include <utility>

#include "pvd_file.hpp"
#include "vtp_file.hpp"

namespace matpoint {

namespace {

/// Components of a field in a VTK file: vectors have three, symmetric tensors six in the order
/// XX YY ZZ XY YZ XZ (which is that of the kernel), other tensors nine by row.
int vtk_components(FieldShape shape, int components) {
    switch (shape) {
        case FieldShape::vector:
            return 3;
        case FieldShape::symmetric:
            return 6;
        case FieldShape::matrix:
            return 9;
        case FieldShape::scalar:
        case FieldShape::list:
            break;
    }
    return components;
}

/// Place in a VTK file of a stored component.
int vtk_place(FieldShape shape, int component, int dimension) {
    if (shape != FieldShape::matrix) return component;
    if (component == dimension * dimension) return 8;  // hoop, stored after the in-plane components by column
    return component % dimension * 3 + component / dimension;
}

/// A field of some bodies at one time, copied out of the run.
struct FieldCopy {
    struct Part {
        std::size_t particles;
        std::vector<int> places;  ///< of the columns in a VTK file; none if the body does not carry the field
        std::vector<std::vector<double>> columns;
    };
    std::string name;
    int width = 1;  ///< components in a VTK file
    std::vector<Part> bodies;
};

FieldCopy copy_of(const RunView& run, const std::vector<std::string>& bodies, const std::string& field) {
    FieldCopy copy{field, 1, {}};
    for (const std::string& body : bodies) {
        FieldCopy::Part& part = copy.bodies.emplace_back();
        part.particles = run.particle_count(body);
        if (!has_field(run, body, field)) continue;
        const int components = run.components(body, field);
        const FieldShape shape = field_shape(field, components, run.space());
        copy.width = std::max(copy.width, vtk_components(shape, components));
        for (int c = 0; c < components; ++c) {
            part.places.push_back(vtk_place(shape, c, run.space().dimension()));
            part.columns.push_back(run.column(body, field, c));
        }
    }
    return copy;
}

/// Its values for the particles of all bodies, one particle after the other.
std::vector<double> interleaved(const FieldCopy& field) {
    const auto stride = static_cast<std::size_t>(field.width);
    std::vector<double> all;
    for (const FieldCopy::Part& part : field.bodies) {
        const std::size_t first = all.size();
        all.resize(first + part.particles * stride,
                   part.columns.empty() ? std::numeric_limits<double>::quiet_NaN() : 0.0);
        for (std::size_t c = 0; c < part.columns.size(); ++c) {
            double* value = all.data() + first + part.places[c];
            for (std::size_t p = 0; p < part.particles; ++p) value[p * stride] = part.columns[c][p];
        }
    }
    return all;
}

/// All that goes into a .vtp file.
struct Snapshot {
    double time;  // s
    FieldCopy position;
    std::vector<std::int32_t> body_numbers;
    std::vector<FieldCopy> fields;
    std::optional<SurfaceMesh> tools;
    std::vector<std::int32_t> tool_numbers;  ///< by point of the tools
};

/// Adds the surfaces of all tools, and which each point belongs to, from 0.
void add_tools(const RunView& run, Snapshot& snapshot) {
    std::int32_t number = 0;
    for (const std::string& contact : run.contacts()) {
        const SurfaceMesh own = run.tool_surface(contact);
        if (own.points.empty()) continue;
        SurfaceMesh& all = snapshot.tools ? *snapshot.tools : snapshot.tools.emplace();
        const auto first = static_cast<std::int64_t>(all.points.size() / 3);
        all.corners = own.corners;
        all.points.insert(all.points.end(), own.points.begin(), own.points.end());
        for (const std::int64_t point : own.cells) all.cells.push_back(first + point);
        snapshot.tool_numbers.resize(all.points.size() / 3, number++);
    }
}

}  // namespace

/// Particles for ParaView, and tools: a .vtp file per write with all bodies, one with all tools, and a .pvd
/// file with the times.
class Vtk final : public Output {
  public:
    static Schema schema() {
        Schema schema(
            "Particles as VTK files for ParaView: one .vtp file per write, one with the surfaces of tools, "
            "one .pvd file for the times.");
        add_file_name(schema,
                      {.doc = "First part of the files' names; <name>.pvd is ParaView's list of all.",
                       .default_value = "particles"},
                      {"<name>.pvd", "<name>_<number>.vtp", "<name>_tools_<number>.vtp"});
        schema
            .add("fields", ParameterType::texts,
                 {.doc = "Fields written for each particle; NaN where a body does not carry one.",
                  .default_value = Json::array({"velocity", "stress"})})
            .add("body", ParameterType::reference,
                 {.doc = "The only body that is written; all if absent.",
                  .optional = true,
                  .section = "bodies"})
            .choice("precision",
                    {.doc = "Floating point numbers in the files: the scene's own, or 32 bits, which "
                            "halve the size of the files.",
                     .default_value = "scene",
                     .choices = {"scene", "single"}});
        return schema;
    }

    explicit Vtk(const Parameters& p)
        : name_(p.text("name")),
          fields_(p.texts("fields")),
          body_(p.has("body") ? p.text("body") : ""),
          single_(p.text("precision") == "single" || p.context().space.single) {}

    std::vector<std::string> required_fields() const override { return fields_; }
    std::string body() const override { return body_; }

    void open(const RunView& run, const std::filesystem::path& folder, double resumed_at) override {
        folder_ = folder;
        for (const std::string& field : fields_) expect_field(run, observed_bodies(run, body_), field);
        series_.open(folder / (name_ + ".pvd"), resumed_at);
        for (const char* part : {"_", "_tools_"})
            remove_numbered(folder, name_ + part, ".vtp", series_.size());
    }

    void write(const RunView& run) override {
        writer_.wait();
        if (series_.ends_at(run.time())) return;
        const std::vector<std::string> bodies = observed_bodies(run, body_);
        Snapshot snapshot{run.time(), copy_of(run, bodies, "position"), body_numbers(run, bodies), {}, {},
                          {}};
        for (const std::string& field : fields_) snapshot.fields.push_back(copy_of(run, bodies, field));
        add_tools(run, snapshot);
        writer_.submit([this, taken = std::move(snapshot)]() mutable { write_file(taken); });
    }
    void flush() override { writer_.wait(); }

  private:
    /// Number of the body in the scene, from 0, for each particle.
    static std::vector<std::int32_t> body_numbers(const RunView& run,
                                                  const std::vector<std::string>& bodies) {
        const std::vector<std::string> all = run.bodies();
        std::vector<std::int32_t> numbers;
        for (const std::string& body : bodies) {
            const auto number = std::find(all.begin(), all.end(), body) - all.begin();
            numbers.insert(numbers.end(), run.particle_count(body), static_cast<std::int32_t>(number));
        }
        return numbers;
    }

    /// In the background; what has gone into the file is freed on the way.
    void write_file(Snapshot& snapshot) {
        VtpFile file(interleaved(std::exchange(snapshot.position, {})), snapshot.time, single_);
        file.add_point_data("body", snapshot.body_numbers);
        for (FieldCopy& next : snapshot.fields) {
            const FieldCopy field = std::exchange(next, {});
            file.add_point_data(field.name, field.width, interleaved(field));
        }
        std::vector<std::string> files{fmt::format("{}_{:06}.vtp", name_, series_.size())};
        file.write(folder_ / files[0]);
        if (const auto& tools = snapshot.tools) {
            VtpFile surfaces(tools->points, tools->cells, tools->corners, snapshot.time, single_);
            surfaces.add_point_data("tool", snapshot.tool_numbers);
            files.push_back(fmt::format("{}_tools_{:06}.vtp", name_, series_.size()));
            surfaces.write(folder_ / files[1]);
        }
        series_.add(snapshot.time, files);
    }

    std::string name_;
    std::vector<std::string> fields_;
    std::string body_;
    bool single_;
    std::filesystem::path folder_;
    PvdFile series_;
    BackgroundWriter writer_;
};

}  // namespace matpoint

MATPOINT_PLUGIN("vtk", "1.0.0") {
    registry.output<matpoint::Vtk>("vtk");
}
