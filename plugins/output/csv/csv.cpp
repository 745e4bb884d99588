#include <fmt/format.h>

#include <matpoint/background_writer.hpp>
#include <matpoint/field_shape.hpp>
#include <matpoint/output_file.hpp>
#include <matpoint/plugin.hpp>

namespace matpoint {

/// Particles as tables: a file per body and write, one row per particle in the order of seeding.
class Csv final : public Output {
  public:
    static Schema schema() {
        Schema schema("Particles as CSV tables: one file per body and write, one row per particle.");
        add_file_name(schema,
                      {.doc = "First part of the files' names; <name>_times.csv has the time of each number.",
                       .default_value = "particles"},
                      {"<name>_<body>_<number>.csv", "<name>_times.csv"});
        schema
            .add("fields", ParameterType::texts,
                 {.doc = "Fields written beside the position; a body's files have those that it carries.",
                  .default_value = Json::array({"velocity", "stress"})})
            .add("body", ParameterType::reference,
                 {.doc = "The only body that is written; all if absent.",
                  .optional = true,
                  .section = "bodies"})
            .integer("precision",
                     {.doc = "Most significant digits of a number; 17 read back to the very same number.",
                      .default_value = 17,
                      .at_least = 1,
                      .at_most = 17});
        return schema;
    }

    explicit Csv(const Parameters& p)
        : name_(p.text("name")),
          fields_(p.texts("fields")),
          body_(p.has("body") ? p.text("body") : ""),
          digits_(static_cast<int>(p.integer("precision"))) {}

    std::vector<std::string> required_fields() const override { return fields_; }
    std::string body() const override { return body_; }

    void open(const RunView& run, const std::filesystem::path& folder, double resumed_at) override {
        folder_ = folder;
        for (const std::string& field : fields_) expect_field(run, observed_bodies(run, body_), field);
        times_.open(folder / (name_ + "_times.csv"), {"time", "step", "index"}, resumed_at);
        for (const std::string& body : observed_bodies(run, body_))
            remove_numbered(folder, fmt::format("{}_{}_", name_, body), ".csv", times_.rows());
    }

    void write(const RunView& run) override {
        writer_.wait();
        if (times_.ends_at(run.time())) return;
        std::vector<Table> tables;
        for (const std::string& body : observed_bodies(run, body_)) tables.push_back(copy_of(run, body));
        writer_.submit([this, taken = std::move(tables), time = run.time(), step = run.step()] {
            const std::size_t index = times_.rows();
            for (const Table& table : taken)
                write_file(table, folder_ / fmt::format("{}_{}_{:06}.csv", name_, table.body, index));
            times_.append(time, {std::to_string(step), std::to_string(index)});
        });
    }
    void flush() override { writer_.wait(); }

  private:
    /// What the particles of a body carry at one time, copied out of the run.
    struct Table {
        std::string body;
        std::size_t rows;
        std::vector<std::string> names;
        std::vector<std::vector<double>> columns;
    };

    Table copy_of(const RunView& run, const std::string& body) const {
        const int dimension = run.space().dimension();
        Table table{
            body, run.particle_count(body), component_names(FieldShape::vector, dimension, run.space()), {}};
        for (int a = 0; a < dimension; ++a) table.columns.push_back(run.column(body, "position", a));
        for (const std::string& field : fields_) {
            if (!has_field(run, body, field)) continue;
            const int components = run.components(body, field);
            for (std::string& name : column_names(field, components, run.space()))
                table.names.push_back(std::move(name));
            for (int c = 0; c < components; ++c) table.columns.push_back(run.column(body, field, c));
        }
        return table;
    }

    void write_file(const Table& table, const std::filesystem::path& path) const {
        OutputFile file(path);
        file.write(fmt::format("{}\n", fmt::join(table.names, ",")));
        std::string row;
        for (std::size_t p = 0; p < table.rows; ++p) {
            row.clear();
            for (const std::vector<double>& column : table.columns) {
                if (!row.empty()) row += ',';
                row += number_text(column[p], digits_);
            }
            row += '\n';
            file.write(row);
        }
        file.commit();
    }

    std::string name_;
    std::vector<std::string> fields_;
    std::string body_;
    int digits_;
    std::filesystem::path folder_;
    TimeTable times_;
    BackgroundWriter writer_;
};

}  // namespace matpoint

MATPOINT_PLUGIN("csv", "1.0.0") {
    registry.output<matpoint::Csv>("csv");
}
