#pragma once

#include <matpoint/exact_solution.hpp>
#include <matpoint/geometry.hpp>

#include "step/engine.hpp"

#include <cmath>
#include <memory>
#include <string>

namespace matpoint {

/// Norms of deviations from the exact solution, over all particles (or nodes) and all steps
/// [Wallstedt & Guilkey 2008, eq. 64, 65].
struct ErrorSums {
    double count = 0, sum = 0, squares = 0, largest = 0;

    void add(double deviation) {
        count += 1;
        sum += deviation;
        squares += deviation * deviation;
        if (std::isnan(deviation) || deviation > largest) largest = deviation;  // not a number stays
    }
    double l1() const { return count > 0 ? sum / count : 0; }
    double l2() const { return count > 0 ? std::sqrt(squares / count) : 0; }
};

/// Compares a run with its scene's exact solution.
template <class S>
class ExactError {
  public:
    /// `own`: the resolved exact_solution; `within` may be null.
    ExactError(std::shared_ptr<ExactSolution> solution, const Json& own, std::shared_ptr<Geometry> within)
        : solution_(std::move(solution)),
          within_(std::move(within)),
          quantity_(own.at("quantity").get<std::string>()),
          relative_(own.at("relative").get<bool>()) {}

    const std::string& quantity() const { return quantity_; }
    bool of_nodes() const { return quantity_ == "nodal_velocity"; }

    /// Displacements and stresses are those at `time`, velocities those at `velocity_time` (s).
    void add_particles(const Particles<S>& particles, double time, double velocity_time,
                       ErrorSums& sums) const;
    /// Nodes that have velocities and move by themselves (`inside`), against the solution at the material
    /// point that is there.
    void add_nodes(const Patch<S>& patch, const std::vector<char>& inside, double time, double velocity_time,
                   ErrorSums& sums) const;

  private:
    bool within(const Eigen::Vector3d& x) const;
    double deviation(const Particles<S>& particles, Index p, double time, double velocity_time) const;

    std::shared_ptr<ExactSolution> solution_;
    std::shared_ptr<Geometry> within_;
    std::string quantity_;
    bool relative_;
};

}  // namespace matpoint
