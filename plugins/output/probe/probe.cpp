#include <matpoint/output_file.hpp>
#include <matpoint/plugin.hpp>

#include "quantity.hpp"

namespace matpoint {

/// A few numbers over time, in one table.
class Probe final : public Output {
  public:
    static Schema schema() {
        Schema schema("A quantity over time: a table <name>.csv with the time and one column per number.");
        add_file_name(schema, {.doc = "The table is <name>.csv; checks refer to the probe by this name."},
                      {"<name>.csv"});
        Quantity::describe(schema);
        return schema;
    }

    explicit Probe(const Parameters& p) : name_(p.text("name")), quantity_(p) {}

    std::vector<std::string> required_fields() const override { return quantity_.required_fields(); }
    std::string body() const override { return quantity_.body(); }
    bool observes_balance() const override { return quantity_.of_balance(); }

    void check(const RunView& run) override { quantity_.find(run); }

    void open(const RunView&, const std::filesystem::path& folder, double resumed_at) override {
        std::vector<std::string> columns = quantity_.names();
        columns.insert(columns.begin(), "time");
        table_.open(folder / (name_ + ".csv"), columns, resumed_at);
    }

    void write(const RunView& run) override {
        std::vector<std::string> row;
        for (const double value : quantity_.values(run)) row.push_back(number_text(value));
        table_.append(run.time(), row);
    }

  private:
    std::string name_;
    Quantity quantity_;
    TimeTable table_;
};

}  // namespace matpoint

MATPOINT_PLUGIN("probe", "1.0.0") {
    registry.output<matpoint::Probe>("probe");
}
