#pragma once

#include "config/catalogue.hpp"

namespace matpoint {

/// JSON Schema (draft 7) of a scene file, for editors: keys, types, ranges, names of types. What
/// one key says about another (references, sizes by dimension, rules) is left out.
Json json_schema(Catalogue& catalogue);

}  // namespace matpoint
