#pragma once

#include "config/catalogue.hpp"
#include "study/study_file.hpp"

namespace matpoint {

/// A setting of a component's "type", such as "/shape_function/type", leaves over parameters of the type that
/// was there before. It becomes a setting of the whole component, with those that the new type has too. Other
/// settings stay as they are.
Setting without_leftovers(const Setting& setting, const Json& scene, Catalogue& catalogue);

}  // namespace matpoint
