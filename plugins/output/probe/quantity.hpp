#pragma once

#include <array>
#include <matpoint/output.hpp>
#include <string>
#include <vector>

/// What a probe measures: a few numbers of a run at one time.
class Quantity {
  public:
    /// Adds the parameters, and the rules which of them belong together.
    static void describe(matpoint::Schema& schema);

    explicit Quantity(const matpoint::Parameters& parameters);

    const std::string& body() const { return body_; }
    bool of_balance() const { return quantity_ == "unbalanced_force"; }
    std::vector<std::string> required_fields() const;

    /// Finds the particle and the components in a run that starts; throws std::runtime_error if they are
    /// not there.
    void find(const matpoint::RunView& run);
    /// Names of the numbers: "centroid_x", "stress_xx", "max_von_mises_stress", …
    const std::vector<std::string>& names() const { return names_; }
    std::vector<double> values(const matpoint::RunView& run) const;

  private:
    bool of_field() const { return !field_.empty(); }
    bool is_vector() const;
    void find_components(const matpoint::RunView& run);
    void find_particle(const matpoint::RunView& run);
    double value(const matpoint::RunView& run, int component) const;
    double of_particle(const matpoint::RunView& run, int component) const;
    double over_particles(const matpoint::RunView& run, int component) const;
    double weighted_by_mass(const matpoint::RunView& run, const char* field, int component) const;

    std::string quantity_, body_, field_, component_, boundary_condition_, contact_;
    long particle_ = -1;  // its number given at seeding
    std::array<double, 3> at_{};
    bool has_at_ = false;
    std::vector<int> components_;
    std::vector<std::string> names_;
};
