#pragma once

#include <memory>
#include <string>
#include <string_view>

struct ut_system;

namespace matpoint {

/// Quantities written with a unit, by udunits2. The database of units is read on the first use.
class Units {
  public:
    /// The value of "70 GPa" in the SI unit `unit` ("" for a dimensionless one); a number without
    /// unit is taken as given. Throws std::invalid_argument with the reason.
    double to_si(std::string_view text, const std::string& unit);

  private:
    std::shared_ptr<ut_system> system_;
};

}  // namespace matpoint
