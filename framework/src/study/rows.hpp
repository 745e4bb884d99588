#pragma once

#include "study/measurement.hpp"

namespace matpoint {

/// The rows of study.json: what was measured of each variant, and how they compare.
class Rows {
  public:
    Rows(const StudyFile& study, const Measurement& measurement) : study_(study), measurement_(measurement) {}

    void add(const Variant& variant, const Outcome& outcome);
    /// When all are there: errors against the finest, orders of convergence, the Pareto fronts.
    void compare();

    const Json& json() const { return rows_; }
    /// What study.json says about the accuracy: the reference values are in it.
    const Json& accuracy() const { return accuracy_; }

  private:
    using Line = std::vector<std::size_t>;
    std::vector<Line> lines() const;
    void take_errors();
    void refer_to_finest(const std::vector<Line>& lines);
    void find_orders(const std::vector<Line>& lines);
    void find_front(const char* cost, const char* key);

    const StudyFile& study_;
    const Measurement& measurement_;
    Json rows_ = Json::array();
    std::vector<double> sizes_;  ///< of the rows along the axis that refines; NaN if it isn't varied
    Json accuracy_;
};

/// Throws InputError if it is known before anything runs that a variant will have no such error.
void check_accuracy(const StudyFile& study, const std::vector<Variant>& variants);

}  // namespace matpoint
