#pragma once

#include <matpoint/schema.hpp>

namespace matpoint {

/// The whole file of `matpoint study`. What stands in `set`, `variants`, `vary` and `plots` is looked at
/// by read_study_file.
Schema study_schema();
/// That of `matpoint limits`.
Schema limits_schema();
/// An item of `plots`.
Schema plot_schema();

}  // namespace matpoint
