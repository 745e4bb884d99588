#include <matpoint/output.hpp>
#include <matpoint/plugin.hpp>

#include <filesystem>
#include <fstream>
#include <stdexcept>

using namespace matpoint;

/// A table of the scene's energies in time, with the columns that README.md names.
class {{Name}} final : public Output {
  public:
    static Schema schema() {
        return Schema("Table of energies in time")
            .text("name", {.doc = "The file's name, without .txt", .default_value = "energies"})
            .writes("<name>.txt");
    }
    explicit {{Name}}(const Parameters& parameters) : name_(parameters.text("name")) {}

    void open(const RunView&, const std::filesystem::path& folder, double resumed_at) override {
        const std::filesystem::path file = folder / (name_ + ".txt");
        const std::string kept = lines_until(file, resumed_at);
        file_.open(file);
        if (!file_) throw std::runtime_error("can't write " + file.string());
        file_.precision(17);
        file_ << (kept.empty() ? "time kinetic strain external\n" : kept);
    }

    void write(const RunView& run) override {
        const Energies e = run.energies();
        file_ << run.time() << ' ' << e.kinetic << ' ' << e.strain << ' ' << e.external << std::endl;
    }

  private:
    /// The head and the lines up to the time (s) from which a run goes on; nothing for a fresh run.
    static std::string lines_until(const std::filesystem::path& file, double time) {
        std::string kept, line;
        std::ifstream old(file);
        if (time < 0 || !std::getline(old, line)) return kept;
        kept = line + '\n';
        while (std::getline(old, line) && std::stod(line) <= time) kept += line + '\n';
        return kept;
    }

    std::string name_;
    std::ofstream file_;
};

MATPOINT_PLUGIN("{{name}}", "0.1.0") { registry.output<{{Name}}>("{{name}}"); }
