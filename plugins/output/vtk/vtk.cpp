#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <matpoint/field_shape.hpp>
#include <matpoint/output_file.hpp>
#include <matpoint/plugin.hpp>

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

}  // namespace

/// Particles for ParaView: a .vtp file per write with all bodies, and a .pvd file with the times.
class Vtk final : public Output {
  public:
    static Schema schema() {
        Schema schema(
            "Particles as VTK files for ParaView: one .vtp file per write, one .pvd file for the times.");
        add_file_name(schema, {.doc = "First part of the files' names: <name>.pvd, <name>_000000.vtp, …",
                               .default_value = "particles"});
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
    }

    void write(const RunView& run) override {
        if (series_.ends_at(run.time())) return;
        const std::vector<std::string> bodies = observed_bodies(run, body_);
        VtpFile file(values(run, bodies, "position"), run.time(), single_);
        file.add_point_data("body", body_numbers(run, bodies));
        for (const std::string& field : fields_)
            file.add_point_data(field, width(run, bodies, field), values(run, bodies, field));
        const std::string file_name = fmt::format("{}_{:06}.vtp", name_, series_.size());
        file.write(folder_ / file_name);
        series_.add(run.time(), file_name);
    }

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

    static int width(const RunView& run, const std::vector<std::string>& bodies, const std::string& field) {
        for (const std::string& body : bodies) {
            if (!has_field(run, body, field)) continue;
            const int components = run.components(body, field);
            return vtk_components(field_shape(field, components, run.space()), components);
        }
        return 1;
    }

    /// Values of a field for the particles of all bodies, one particle after the other.
    static std::vector<double> values(const RunView& run, const std::vector<std::string>& bodies,
                                      const std::string& field) {
        const auto stride = static_cast<std::size_t>(width(run, bodies, field));
        std::vector<double> all;
        for (const std::string& body : bodies) {
            const std::size_t first = all.size();
            const bool carried = has_field(run, body, field);
            all.resize(first + run.particle_count(body) * stride,
                       carried ? 0.0 : std::numeric_limits<double>::quiet_NaN());
            if (!carried) continue;
            const int components = run.components(body, field);
            const FieldShape shape = field_shape(field, components, run.space());
            for (int c = 0; c < components; ++c) {
                const std::vector<double> column = run.column(body, field, c);
                double* value = all.data() + first + vtk_place(shape, c, run.space().dimension());
                for (std::size_t p = 0; p < column.size(); ++p) value[p * stride] = column[p];
            }
        }
        return all;
    }

    std::string name_;
    std::vector<std::string> fields_;
    std::string body_;
    bool single_;
    std::filesystem::path folder_;
    PvdFile series_;
};

}  // namespace matpoint

MATPOINT_PLUGIN("vtk", "1.0.0") {
    registry.output<matpoint::Vtk>("vtk");
}
