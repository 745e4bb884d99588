#pragma once

#include <nlohmann/json.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace matpoint {

using Json = nlohmann::ordered_json;
class Schema;

/// What a user may write for a parameter, and what a component then finds in its Parameters.
enum class ParameterType {
    number,      ///< a number, or a string with a unit; resolved to SI
    integer,     ///< a whole number
    boolean,     ///< true or false
    text,        ///< any string
    file,        ///< a path, relative to the scene's folder
    choice,      ///< one of `choices`
    vector,      ///< one number per dimension of the space
    per_axis,    ///< a number for all axes, or one per dimension; resolved to one per dimension
    numbers,     ///< a list of numbers of any length
    texts,       ///< a string or a list of strings; resolved to a list
    profile,     ///< a number, a formula of `variables`, or {"times": [...], "values": [...]}
    profiles,    ///< one profile per dimension; null leaves that component free
    reference,   ///< a name in the scene's section `section` ("bodies", "materials")
    references,  ///< a name or a list of names there; resolved to a list
    place,  ///< a grid face ("x_min"), a list of faces, a geometry object, or a part of a body ({"body": …,
            ///< "within": geometry}); resolved to a list of faces or the object
    component,   ///< an object with "type", of kind `kind`
    components,  ///< a list of such objects
    object,      ///< an object described by `nested`
    objects,     ///< a list of such objects
    map,  ///< an object of at least `at_least` names of the user's: each a component of `kind`, or an object
          ///< described by `nested`
    any,  ///< kept as given; with a unit, numbers in lists are resolved to SI
};

/// One parameter's description. Written with designated initialisers: {.unit = "Pa", .doc = "…"}.
struct ParameterOptions {
    std::string unit{};                   ///< SI unit; "" for none
    std::string doc{};                    ///< one sentence
    std::string paper{};                  ///< where the symbol comes from, "[Author Year, eq. n]"
    std::optional<Json> default_value{};  ///< absent: the parameter must be given, unless `optional`
    bool optional = false;                ///< may be absent, with no default
    bool start_only = false;              ///< what the start makes of it is kept: a restart can't change it
    std::optional<double> at_least{};
    std::optional<double> at_most{};
    std::optional<double> greater_than{};
    std::optional<double> less_than{};
    /// For ParameterType::choice; of a number, an object or references, words that may stand in their place.
    std::vector<std::string> choices{};
    std::string variables = "xyzt";    ///< for profile(s): what a formula may depend on
    std::string section{};             ///< for reference(s): "bodies" or "materials"
    std::string kind{};                ///< for component(s): the kind, "geometry"
    std::shared_ptr<Schema> nested{};  ///< for object
};

struct Parameter : ParameterOptions {
    std::string name;
    ParameterType type;
};

/// A combination that a component knows to be wrong, or doubtful: the one place for misfits.
struct Rule {
    bool refuses;         ///< true: a mistake; false: a warning
    std::string pointer;  ///< the parameter to blame, relative to the component ("/pic_fraction"), or ""
    std::string reason;   ///< what is wrong and what to do instead
    /// Whether the misfit is there. `own`: the component's resolved object; `scene`: the resolved scene.
    std::function<bool(const Json& own, const Json& scene)> applies;
    bool tabled = false;  ///< whether the schema's table tells it
};

enum class Use { refused, possible, needed };

/// Which of the optional parameters go with each choice of another one.
struct UseTable {
    struct Row {
        std::string choice;
        std::vector<Use> uses;  ///< by parameter
    };
    std::string chooser;  ///< a parameter of type choice
    std::vector<std::string> parameters;
    std::vector<Row> rows;
};

/// A component's self-description, declared once; validation, `describe`, the JSON Schema and the
/// reference pages are all derived from it.
class Schema {
  public:
    explicit Schema(std::string doc = {}, std::string paper = {})
        : doc_(std::move(doc)), paper_(std::move(paper)) {}

    Schema& number(std::string name, ParameterOptions o) {
        return add(std::move(name), ParameterType::number, std::move(o));
    }
    Schema& integer(std::string name, ParameterOptions o) {
        return add(std::move(name), ParameterType::integer, std::move(o));
    }
    Schema& boolean(std::string name, ParameterOptions o) {
        return add(std::move(name), ParameterType::boolean, std::move(o));
    }
    Schema& text(std::string name, ParameterOptions o) {
        return add(std::move(name), ParameterType::text, std::move(o));
    }
    Schema& choice(std::string name, ParameterOptions o) {
        return add(std::move(name), ParameterType::choice, std::move(o));
    }
    Schema& vector(std::string name, ParameterOptions o) {
        return add(std::move(name), ParameterType::vector, std::move(o));
    }
    Schema& profile(std::string name, ParameterOptions o) {
        return add(std::move(name), ParameterType::profile, std::move(o));
    }
    /// Any other type of parameter.
    Schema& add(std::string name, ParameterType type, ParameterOptions o);

    /// Dimensions (1, 2, 3) the component works in; all by default.
    Schema& dimensions(std::vector<int> d) {
        dimensions_ = std::move(d);
        return *this;
    }
    /// A file of an output in the run's folder, "<name>_<body>_<number>.csv": <body> is each body that it
    /// writes, <number> six digits or more, and any other <key> the text of a parameter.
    Schema& writes(std::string file);
    Schema& refuse(std::string pointer, std::string reason,
                   std::function<bool(const Json&, const Json&)> applies);
    Schema& warn(std::string pointer, std::string reason,
                 std::function<bool(const Json&, const Json&)> applies);
    /// Adds the rules that a table holds.
    Schema& use(UseTable table);

    const std::string& doc() const { return doc_; }
    const std::string& paper() const { return paper_; }
    const std::vector<Parameter>& parameters() const { return parameters_; }
    const std::vector<int>& dimensions() const { return dimensions_; }
    const std::vector<std::string>& files() const { return files_; }
    const std::vector<Rule>& rules() const { return rules_; }
    const std::optional<UseTable>& table() const { return table_; }
    const Parameter* find(std::string_view name) const;

  private:
    std::string doc_;
    std::string paper_;
    std::vector<Parameter> parameters_;
    std::vector<int> dimensions_{1, 2, 3};
    std::vector<std::string> files_;
    std::vector<Rule> rules_;
    std::optional<UseTable> table_;
};

}  // namespace matpoint
