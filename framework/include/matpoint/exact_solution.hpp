#pragma once

#include <matpoint/registry.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <string>
#include <vector>

namespace matpoint {

/// The motion of some bodies, known exactly. It gives them their initial state, and errors are measured
/// against it. Points X are those of the reference configuration, that of the geometries in the scene (m);
/// coordinates that the scene's space lacks are zero. Tensors are 3 x 3; where the space has a normal (2D),
/// it is the last component. Double precision in every space.
class ExactSolution : public Component {
  public:
    using Vector = Eigen::Vector3d;
    using Matrix = Eigen::Matrix3d;

    /// Parameters of every solution beside its own: `body`, `quantity`, `relative`, `within`.
    explicit ExactSolution(const Parameters& parameters) : bodies_(parameters.texts("body")) {}
    /// The bodies that it is a solution for.
    const std::vector<std::string>& bodies() const { return bodies_; }
    bool covers(const std::string& body) const { return std::ranges::find(bodies_, body) != bodies_.end(); }

    /// u(X, t), m.
    virtual Vector displacement(const Vector& reference, double time) const = 0;
    /// du/dt, m/s.
    virtual Vector velocity(const Vector& reference, double time) const = 0;
    /// F = I + du/dX.
    virtual Matrix deformation_gradient(const Vector& reference, double time) const = 0;
    /// Cauchy stress, Pa.
    virtual Matrix stress(const Vector& reference, double time) const = 0;
    /// Acceleration b, m/s^2, that makes it a solution: Div P + rho_0 b = rho_0 a
    /// [Wallstedt & Guilkey 2008, eq. 52]. The load `manufactured` applies it.
    virtual Vector body_force(const Vector&, double) const { return Vector::Zero(); }

  private:
    std::vector<std::string> bodies_;
};

/// Constants of the material of a solution's (first) body.
struct ElasticConstants {
    double density;         ///< kg/m^3
    double youngs_modulus;  ///< Pa
    double poissons_ratio;
    double lambda, mu;  ///< Pa; of a bar with free sides in 1D: 0 and E/2, as in Lame<Space>
    /// sqrt(E / rho), m/s
    double bar_speed() const;
};
ElasticConstants elastic_constants(const Parameters& parameters);

/// Refuses bodies of other materials than these types.
Schema& refuse_other_materials(Schema& schema, std::vector<std::string> types);
/// Warns if the scene lacks the load `manufactured`, without which the bodies don't move as the solution
/// says.
Schema& warn_without_body_force(Schema& schema);

}  // namespace matpoint
