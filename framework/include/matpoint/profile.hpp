#pragma once

#include <matpoint/schema.hpp>

#include <array>
#include <memory>

namespace matpoint {

/// A value given as a number, a formula of x, y, z, t (pi is known; sin, exp, min, ?: …), or a
/// table in time, linear between its points and constant outside. Evaluation is not thread-safe.
class Profile {
  public:
    /// From a resolved parameter. Throws std::invalid_argument with the reason if a formula can't
    /// be read or a table's times don't increase.
    explicit Profile(const Json& value);
    Profile(const Profile&);
    Profile(Profile&&) noexcept;
    Profile& operator=(Profile) noexcept;
    ~Profile();

    double operator()(const std::array<double, 3>& position, double time) const;

  private:
    struct Formula;
    double constant_ = 0;
    std::vector<double> times_, values_;
    std::unique_ptr<Formula> formula_;
};

}  // namespace matpoint
