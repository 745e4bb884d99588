#pragma once

#include "config/catalogue.hpp"
#include "config/document.hpp"
#include "config/units.hpp"

#include <matpoint/schema.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace matpoint {

/// Checks the objects of a scene against schemas and resolves them: defaults filled in, quantities
/// in SI, lists where a single item was allowed. Mistakes are collected and none is thrown; what is
/// returned for a wrong value has no meaning.
class Validator {
  public:
    /// `dimension` of the space; 0 if that is itself wrong, so that nothing is said about sizes.
    Validator(const Document& document, Catalogue& catalogue, int dimension, Diagnostics& diagnostics);

    /// `own` is the object found at the JSON pointer `at`.
    Json object(const Schema& schema, const Json& own, const std::string& at);
    /// An object whose "type" names a component of `kind`.
    Json component(const std::string& kind, const Json& own, const std::string& at);

    /// The rules of every component met so far, on the whole resolved scene.
    void check_rules(const Json& scene);
    /// That formulas of t have a value at the start and the end of the run, and in between.
    void check_formulas(const Json& scene);
    /// Pointers of the values met so far that only the start of a run reads.
    const std::vector<std::string>& start_only() const { return start_only_; }

    void error(const std::string& at, std::string message);

  private:
    Json members(const std::vector<const Parameter*>& parameters, const Json& own, const std::string& at,
                 const std::string& kind);
    void unknown_key(const std::string& key, const std::vector<const Parameter*>& parameters, const Json& own,
                     const std::string& at, const std::string& kind);
    Json default_value(const Parameter& parameter) const;

    Json value(const Parameter& parameter, const Json& given, const std::string& at);
    Json number(const ParameterOptions& options, const Json& given, const std::string& at);
    Json numbers_within(const Parameter& parameter, const Json& given, const std::string& at);
    Json integer(const Parameter& parameter, const Json& given, const std::string& at);
    Json choice(const Parameter& parameter, const Json& given, const std::string& at);
    Json file(const Parameter& parameter, const Json& given, const std::string& at);
    Json texts(const Parameter& parameter, const Json& given, const std::string& at);
    Json profile(const Parameter& parameter, const Json& given, const std::string& at);
    Json formula_or_quantity(const Parameter& parameter, const Json& given, const std::string& at);
    Json table(const Parameter& parameter, const Json& given, const std::string& at);
    Json reference(const Parameter& parameter, const Json& given, const std::string& at);
    Json face(const Parameter& parameter, const Json& given, const std::string& at);
    Json place(const Parameter& parameter, const Json& given, const std::string& at);
    Json map(const Parameter& parameter, const Json& given, const std::string& at);
    Json mismatch(const Parameter& parameter, const Json& given, const std::string& at);

    /// A list whose items `check(item, pointer)` resolves; `size` 0: of any length.
    template <class Check>
    Json list(const Parameter& parameter, const Json& given, const std::string& at, int size, Check check);

    struct PendingRules {
        std::string pointer;
        const std::vector<Rule>* rules;
        std::string kind{};  ///< "" if these are not a plugin's
    };

    const Document& document_;
    Catalogue& catalogue_;
    int dimension_;
    Diagnostics& diagnostics_;
    std::filesystem::path folder_;
    Units units_;
    std::vector<PendingRules> pending_;
    std::vector<std::string> formulas_in_time_, start_only_;
};

}  // namespace matpoint
