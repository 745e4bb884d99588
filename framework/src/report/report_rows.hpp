#pragma once

#include <matpoint/schema.hpp>

#include "report/plot_style.hpp"

#include <optional>
#include <string>
#include <vector>

namespace matpoint {

/// What a variant of study.json has under a key: an entry of its own ("cost") or a setting
/// ("/time/cfl", also where it sets the object around it); null if it has none.
Json value_of(const Json& variant, const std::string& key);

/// If it is a finite number.
std::optional<double> number_of(const Json& variant, const std::string& key);

/// If it is a text, else "".
std::string text_of(const Json& variant, const std::string& key);

/// "/grid/cell_size" as "cell size", "/shape_function/type" as "shape function".
std::string key_label(const std::string& key);

/// A setting in few words: "bspline (degree 3)".
std::string value_label(const Json& value);

struct VariantGroup {
    std::string name;
    PlotStyle style;
    std::vector<const Json*> variants;
};

/// Variants that agree on every key, in the order of their appearance. The first key chooses the
/// colour, the others the shape of marks; a single key chooses both.
std::vector<VariantGroup> grouped(const std::vector<const Json*>& variants,
                                  const std::vector<std::string>& keys);

/// Keys that tell variants apart by kind, not by a number: the named variant, the shape function, other
/// settings of words and objects; only those that don't follow from the ones before.
std::vector<std::string> kind_keys(const std::vector<const Json*>& variants);

/// The variants of study.json or limits.json.
std::vector<const Json*> variants_of(const Json& study);

}  // namespace matpoint
