#pragma once

#include <matpoint/particles.hpp>

#include <string>
#include <vector>

namespace matpoint {

/// Fields as outputs and checks name them: those that particles carry, and those computed from them
/// when asked for (displacement, deformation_gradient, density, pressure, von_mises_stress, kinetic_energy).
template <class S>
std::vector<std::string> field_names(const Particles<S>& particles);

/// Number of components; 0 if there is no such field.
template <class S>
int field_components(const Particles<S>& particles, const std::string& field);

/// One component for all particles, in the order of their seeding if they carry ids.
template <class S>
std::vector<double> field_column(const Particles<S>& particles, const std::string& field, int component);

/// Cauchy stress of a particle, Pa; what the space has beyond its plane is the last component.
template <class S>
Eigen::Matrix3d full_stress(const Particles<S>& particles, Index p);

/// The carried field that a name needs, "displacement" -> initial_position; empty if none beyond the basic
/// ones.
std::optional<Field> field_behind(const std::string& name);

}  // namespace matpoint
