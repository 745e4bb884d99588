#pragma once

#include <matpoint/profile.hpp>
#include <matpoint/schema.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace matpoint {

/// A factor in time, by which a load is multiplied:
/// {"type": "step", "start": s}, {"type": "pulse", "start": s, "duration": s},
/// {"type": "ramp", "start": s, "duration": s}, {"type": "table", "times": [s], "values": []} or
/// {"type": "formula", "value": "sin(2*pi*t)"}.
class History {
  public:
    explicit History(const Json& value) : type_(value.at("type").get<std::string>()) {
        if (type_ == "table")
            profile_ = Profile(Json{{"times", value.at("times")}, {"values", value.at("values")}});
        if (type_ == "formula") profile_ = Profile(value.at("value"));
        start_ = value.value("start", 0.0);
        if (type_ == "pulse" || type_ == "ramp") duration_ = value.at("duration").get<double>();
    }

    /// Declares the parameter `history`, a step at time 0 by default.
    static Schema& declare(Schema& schema) {
        auto nested = std::make_shared<Schema>("Factor in time of a load");
        nested
            ->choice("type", {.doc = "Shape of the history",
                              .default_value = "step",
                              .choices = {"step", "ramp", "pulse", "table", "formula"}})
            .number(
                "start",
                {.unit = "s", .doc = "Time before which a step, ramp or pulse is 0", .default_value = 0.0})
            .number("duration", {.unit = "s",
                                 .doc = "Length of a pulse; time in which a ramp goes smoothly from 0 to 1",
                                 .optional = true,
                                 .greater_than = 0})
            .add("times", ParameterType::numbers, {.unit = "s", .doc = "Times of a table", .optional = true})
            .add("values", ParameterType::numbers, {.doc = "Factors of a table", .optional = true})
            .profile("value", {.doc = "Factor as a formula of t", .optional = true, .variables = "t"});
        only_with(*nested, "duration", {"pulse", "ramp"});
        only_with(*nested, "times", {"table"});
        only_with(*nested, "values", {"table"});
        only_with(*nested, "value", {"formula"});
        nested->refuse(
            "/start", "belongs to types \"step\", \"ramp\" and \"pulse\"", [](const Json& own, const Json&) {
                return (own.at("type") == "table" || own.at("type") == "formula") && own.at("start") != 0;
            });
        nested->warn("/start", "the load never acts: the run ends before",
                     [](const Json& own, const Json& scene) {
                         return own.at("start").get<double>() >= scene.at("time").at("end").get<double>();
                     });
        nested->refuse(
            "/times", "a table needs as many times as values, and times that increase",
            [](const Json& own, const Json&) { return own.at("type") == "table" && !is_table(own); });
        return schema.add(
            "history", ParameterType::object,
            {.doc = "Factor in time", .default_value = Json{{"type", "step"}}, .nested = nested});
    }

    /// The factor during the step that starts at `time` (s). A pulse ends at the first step whose start
    /// reaches its end; times that differ by rounding alone are the same.
    double operator()(double time) const {
        if (profile_) return (*profile_)({0, 0, 0}, time);
        if (type_ == "ramp") {  // with no jump in its first two derivatives
            const double s = std::clamp((time - start_) / *duration_, 0.0, 1.0);
            return s * s * s * (10 - s * (15 - 6 * s));
        }
        const auto reached = [time](double moment) { return time >= moment - 1e-9 * std::abs(moment); };
        if (!reached(start_)) return 0;
        return duration_ && reached(start_ + *duration_) ? 0 : 1;
    }

    /// Time (s) from which on the factor stays as it is; infinite for a formula of t.
    double settled_at() const { return profile_ ? profile_->settled_at() : start_ + duration_.value_or(0); }

  private:
    static bool given(const Json& own, const char* key) {
        return own.contains(key) && !own.at(key).is_null();
    }

    static void only_with(Schema& schema, const char* key, const std::vector<std::string>& types) {
        const std::string pointer = std::string("/") + key, name = std::string("`") + key + "`";
        const auto of_type = [types](const Json& own) {
            return std::ranges::find(types, own.at("type").get<std::string>()) != types.end();
        };
        std::string all;
        for (const std::string& type : types) all += (all.empty() ? "\"" : ", \"") + type + "\"";
        schema.refuse(pointer, all + " needs " + name,
                      [=](const Json& own, const Json&) { return of_type(own) && !given(own, key); });
        schema.refuse(pointer, name + " belongs to type " + all,
                      [=](const Json& own, const Json&) { return !of_type(own) && given(own, key); });
    }

    static bool is_table(const Json& own) {
        if (!given(own, "times") || !given(own, "values")) return true;  // refused already
        const auto times = own.at("times").get<std::vector<double>>();
        for (std::size_t i = 1; i < times.size(); ++i)
            if (!(times[i] > times[i - 1])) return false;
        return !times.empty() && times.size() == own.at("values").size();
    }

    std::string type_;
    double start_ = 0;
    std::optional<double> duration_;
    std::optional<Profile> profile_;
};

}  // namespace matpoint
