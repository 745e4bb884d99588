#include "study/study_file.hpp"

#include "config/expected.hpp"
#include "config/utf8.hpp"
#include "config/validate.hpp"
#include "study/study_schema.hpp"
#include "verify/no_components.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matpoint {
namespace {

/// More than anybody waits for; a range with a slip of the pen has more.
constexpr double most_variants = 100'000;

class Reader {
  public:
    explicit Reader(const std::filesystem::path& file)
        : document_(std::make_shared<const Document>(read_document(file))),
          mistakes_(document_->mistakes),
          validator_(*document_, none_, 0, mistakes_) {}

    StudyFile read(const Schema& schema) {
        Json resolved = validator_.object(schema, document_->json, "");
        StudyFile study;
        study.document = document_;
        study.set = settings("/set");
        read_sets(study);
        read_axes(study);
        Json plots = read_plots();
        mistakes_.throw_if_errors();
        if (!plots.empty()) resolved["plots"] = std::move(plots);
        validator_.check_rules(resolved);
        mistakes_.throw_if_errors();
        make_axes(study);
        check(study, resolved);
        mistakes_.throw_if_errors();
        study.title = resolved.value("title", as_utf8(document_->path.stem().string()));
        study.scene = resolved.at("scene").get<std::string>();
        study.json = std::move(resolved);
        return study;
    }

  private:
    const Json& section(const std::string& at) {
        static const Json nothing = Json::object();
        const Json::json_pointer pointer(at);
        if (!document_->json.contains(pointer)) return nothing;
        const Json& given = document_->json.at(pointer);
        if (given.is_object()) return given;
        validator_.error(at, fmt::format("expected an object, got {}", shown(given)));
        return nothing;
    }

    bool is_scene_pointer(const std::string& pointer, const std::string& at) {
        try {
            if (!pointer.empty() && Json::json_pointer(pointer).to_string() == pointer) return true;
        } catch (const Json::exception&) {
            // Told below.
        }
        validator_.error(at, "expected a JSON pointer into the scene, such as \"/time/end\"");
        return false;
    }

    std::vector<Setting> settings(const std::string& at) {
        std::vector<Setting> found;
        for (const auto& [pointer, value] : section(at).items()) {
            const std::string from = join_pointer(at, pointer);
            if (is_scene_pointer(pointer, from)) found.push_back({pointer, value, from});
        }
        return found;
    }

    void read_sets(StudyFile& study) {
        for (const auto& [name, own] : section("/variants").items()) {
            const std::string at = join_pointer("/variants", name);
            if (name.empty()) validator_.error(at, "a name can't be empty");
            study.sets.push_back({name, settings(at)});
        }
        if (study.sets.empty()) study.sets.push_back({});
    }

    void read_axes(StudyFile& study) {
        for (const auto& [pointer, given] : section("/vary").items()) {
            const std::string at = join_pointer("/vary", pointer);
            if (!is_scene_pointer(pointer, at)) continue;
            if (given.is_object()) {
                static const Schema schema = range_schema();
                validator_.object(schema, given, at);
            } else if (!given.is_array() || given.empty()) {
                validator_.error(at, fmt::format("expected a list of values or a range {{\"from\", \"to\", "
                                                 "\"step\" or \"factor\"}}, got {}",
                                                 shown(given)));
            }
            for (const NamedSettings& set : study.sets)
                for (const Setting& setting : set.settings)
                    if (setting.pointer == pointer) validator_.error(setting.from, "is varied too, in /vary");
            study.axes.push_back({.pointer = pointer, .label = {}, .values = {}, .value_labels = {}});
        }
    }

    Json read_plots() {
        static const Schema schema = plot_schema();
        Json plots = Json::array();
        if (!document_->json.is_object() || !document_->json.contains("plots")) return plots;
        const Json& given = document_->json.at("plots");
        if (!given.is_array()) {
            validator_.error("/plots", fmt::format("expected a list of plots, got {}", shown(given)));
            return plots;
        }
        for (std::size_t i = 0; i < given.size(); ++i)
            plots.push_back(validator_.object(schema, given[i], fmt::format("/plots/{}", i)));
        for (std::size_t i = 0; i < plots.size(); ++i)
            if (plots[i].is_object() && !plots[i].value("where", Json::object()).is_object())
                validator_.error(fmt::format("/plots/{}/where", i),
                                 "expected an object of values by JSON pointer");
        return plots;
    }

    /// When all of `vary` is known to make sense.
    void make_axes(StudyFile& study) {
        std::vector<std::string> pointers;
        for (const Axis& axis : study.axes) pointers.push_back(axis.pointer);
        const std::vector<std::string> labels = pointer_labels(pointers);
        auto total = static_cast<double>(study.sets.size());
        for (std::size_t i = 0; i < study.axes.size(); ++i) {
            Axis& axis = study.axes[i];
            const Json& given = document_->json.at("vary").at(axis.pointer);
            total *= given.is_array() ? static_cast<double>(given.size()) : range_count(given);
            if (total > most_variants) {
                return validator_.error(
                    "/vary",
                    fmt::format("makes more than {:.0f} variants, which is the most", most_variants));
            }
            axis.label = labels[i];
            axis.values = given.is_array() ? given.get<std::vector<Json>>() : range_values(given);
            axis.value_labels = value_labels(axis.values);
        }
    }

    void check(const StudyFile& study, Json& resolved) {
        if (study.axes.empty() && study.sets.front().name.empty() && !resolved.contains("search"))
            validator_.error("", "says nothing to vary: give `vary`, `variants` or both");
        if (resolved.contains("search")) {
            const std::string pointer = resolved.at("search").at("pointer");
            is_scene_pointer(pointer, "/search/pointer");
            if (std::ranges::any_of(study.axes, [&](const Axis& a) { return a.pointer == pointer; }))
                validator_.error(join_pointer("/vary", pointer),
                                 "is searched along, and can't be varied too");
        }
        if (resolved.contains("accuracy") && resolved.at("accuracy").contains("reference"))
            check_along(study, resolved.at("accuracy").at("along"));
        if (resolved.contains("plots")) check_plots(study, resolved.at("plots"));
    }

    void check_along(const StudyFile& study, const std::string& along) {
        const auto is_along = [&](const Axis& axis) { return axis.pointer == along; };
        const auto axis = std::ranges::find_if(study.axes, is_along);
        if (axis == study.axes.end())
            return validator_.error("/accuracy",
                                    fmt::format("the finest along {0} is the reference: {0} must "
                                                "be in /vary",
                                                along));
        if (axis->values.size() < 2)
            validator_.error(join_pointer("/vary", along),
                             "needs two values or more, the finest a reference");
    }

    void check_plots(const StudyFile& study, Json& plots) {
        std::vector<std::string> varied;
        for (const Axis& axis : study.axes) varied.push_back(axis.pointer);
        for (const NamedSettings& set : study.sets)
            for (const Setting& setting : set.settings)
                if (std::ranges::find(varied, setting.pointer) == varied.end())
                    varied.push_back(setting.pointer);
        // A label stands for its pointer, but for those of `where`.
        const auto replace = [&](Json& name, const std::vector<std::string>& others, const std::string& at) {
            for (const Axis& axis : study.axes)
                if (name == axis.label) name = axis.pointer;
            std::vector<std::string> known = varied;
            known.insert(known.end(), others.begin(), others.end());
            if (std::ranges::find(known, name.get<std::string>()) == known.end())
                validator_.error(at, fmt::format("{} is neither varied nor measured{}", shown(name),
                                                 did_you_mean(name.get<std::string>(), known)));
        };
        for (std::size_t i = 0; i < plots.size(); ++i) {
            const std::string at = fmt::format("/plots/{}", i);
            replace(plots[i].at("x"), plotted_quantities(), at + "/x");
            replace(plots[i].at("y"), plotted_quantities(), at + "/y");
            Json lines = plots[i].value("lines", Json::array());
            for (std::size_t k = 0; k < lines.size(); ++k)
                replace(lines[k], {"variant"}, fmt::format("{}/lines/{}", at, k));
            if (plots[i].contains("lines")) plots[i]["lines"] = lines;
            const Json where = plots[i].value("where", Json::object());
            for (const auto& entry : where.items()) {
                Json key = entry.key();
                replace(key, {"variant"}, join_pointer(at + "/where", entry.key()));
            }
        }
    }

    std::shared_ptr<const Document> document_;
    NoComponents none_;
    Diagnostics mistakes_;
    Validator validator_;
};

}  // namespace

StudyFile read_study_file(const std::filesystem::path& file) {
    return Reader(file).read(study_schema());
}

StudyFile read_limits_file(const std::filesystem::path& file) {
    return Reader(file).read(limits_schema());
}

const std::vector<std::string>& plotted_quantities() {
    static const std::vector<std::string> names{
        "error", "value",       "cost",         "particle_steps", "steps",
        "order", "cpu_seconds", "wall_seconds", "particles",      "peak_memory_bytes"};
    return names;
}

}  // namespace matpoint
