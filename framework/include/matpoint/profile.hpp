#pragma once

#include <matpoint/schema.hpp>

#include <array>
#include <memory>
#include <stdexcept>
#include <string>

namespace matpoint {

/// A formula has no finite value at a place and time, as 1/t has none at t = 0; what() says all three.
class FormulaError : public std::domain_error {
  public:
    FormulaError(std::string formula, const std::string& what)
        : std::domain_error(what), formula_(std::move(formula)) {}
    const std::string& formula() const { return formula_; }

  private:
    std::string formula_;
};

/// A value given as a number, a formula of x, y, z, t (docs/formulas.md), or a table in time, linear
/// between its points and constant outside. Evaluation is not thread-safe.
class Profile {
  public:
    /// From a resolved parameter. Throws std::invalid_argument with the reason if a formula can't
    /// be read or a table's times don't increase.
    explicit Profile(const Json& value);
    Profile(const Profile&);
    Profile(Profile&&) noexcept;
    Profile& operator=(Profile) noexcept;
    ~Profile();

    /// Throws FormulaError where a formula has no finite value.
    double operator()(const std::array<double, 3>& position, double time) const;
    /// Time (s) from which on the value stays as it is; infinite for a formula of t.
    double settled_at() const;
    /// Time (s) from which on the value is 0; infinite for a formula and where it never is.
    double zero_from() const;
    /// Those of x, y, z and t that the value depends on: "xt".
    std::string variables() const;

  private:
    struct Formula;
    double constant_ = 0;
    std::vector<double> times_, values_;
    std::unique_ptr<Formula> formula_;
};

}  // namespace matpoint
