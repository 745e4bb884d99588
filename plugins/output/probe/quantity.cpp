#include "quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <matpoint/field_shape.hpp>
#include <matpoint/output_file.hpp>
#include <numbers>
#include <numeric>
#include <stdexcept>

using matpoint::RunView;

namespace {

/// Edge of the square or cube that has the volume of a body's largest particle, m.
double largest_size(const RunView& run, const std::string& body) {
    std::vector<double> volume = run.column(body, "volume", 0);
    if (run.space().mode == matpoint::Mode::axisymmetric) {
        const std::vector<double> radius = run.column(body, "position", 0);
        for (std::size_t p = 0; p < volume.size(); ++p) volume[p] /= 2 * std::numbers::pi * radius[p];
    }
    return std::pow(*std::max_element(volume.begin(), volume.end()), 1.0 / run.space().dimension());
}

}  // namespace

std::vector<std::string> Quantity::required_fields() const {
    std::vector<std::string> fields;
    if (of_field()) fields.push_back(field_);
    if (quantity_ == "particle") fields.push_back("id");
    if (has_at_) fields.push_back("initial_position");
    return fields;
}

Quantity::Quantity(const matpoint::Parameters& p)
    : quantity_(p.text("quantity")),
      body_(p.has("body") ? p.text("body") : ""),
      field_(p.has("field") ? p.text("field") : ""),
      component_(p.has("component") ? p.text("component") : ""),
      boundary_condition_(p.has("boundary_condition") ? p.text("boundary_condition") : ""),
      contact_(p.has("contact") ? p.text("contact") : ""),
      has_at_(p.has("at")) {
    if (p.has("particle")) particle_ = p.integer("particle");
    if (has_at_) at_ = p.vector("at");
}

bool Quantity::is_vector() const {
    return quantity_ == "centroid" || quantity_ == "momentum" || quantity_ == "reaction" || !contact_.empty();
}

void Quantity::find(const RunView& run) {
    find_components(run);
    if (quantity_ == "particle") find_particle(run);
}

void Quantity::find_components(const RunView& run) {
    std::vector<std::string> components{""};
    std::string prefix = quantity_;
    if (is_vector()) {
        components = component_names(matpoint::FieldShape::vector, run.space().dimension(), run.space());
    } else if (of_field()) {
        const std::vector<std::string> bodies = observed_bodies(run, body_);
        expect_field(run, bodies, field_);
        const auto carrier = std::find_if(bodies.begin(), bodies.end(),
                                          [&](const std::string& b) { return has_field(run, b, field_); });
        const int count = run.components(*carrier, field_);
        components = component_names(field_shape(field_, count, run.space()), count, run.space());
        prefix = quantity_ == "particle" ? field_ : quantity_ + "_" + field_;
    }
    const bool about_z = quantity_ == "contact_torque" && run.space().dimension() == 2;
    if (about_z) components = {"z"};
    if (!component_.empty() &&
        std::find(components.begin(), components.end(), component_) == components.end())
        throw std::runtime_error(
            components.front().empty()
                ? fmt::format(
                      "a probe asks for component {} of \"{}\", which has one number only: leave it out",
                      component_, prefix)
                : fmt::format("a probe asks for component {} of \"{}\", which has {}", component_, prefix,
                              fmt::join(components, ", ")));
    components_.clear();
    names_.clear();
    for (std::size_t c = 0; c < components.size(); ++c) {
        if (!component_.empty() && components[c] != component_) continue;
        components_.push_back(about_z ? 2 : static_cast<int>(c));
        names_.push_back(components[c].empty() ? prefix : prefix + "_" + components[c]);
    }
}

void Quantity::find_particle(const RunView& run) {
    const std::vector<double> ids = run.column(body_, "id", 0);
    if (has_at_) {
        std::vector<std::vector<double>> x;  // m, by axis
        for (int a = 0; a < run.space().dimension(); ++a)
            x.push_back(run.column(body_, "initial_position", a));
        const auto distance = [&](std::size_t p) {
            double squared = 0;
            for (std::size_t a = 0; a < x.size(); ++a) squared += (x[a][p] - at_[a]) * (x[a][p] - at_[a]);
            return std::sqrt(squared);
        };
        std::size_t nearest = 0;
        for (std::size_t p = 1; p < ids.size(); ++p)
            if (distance(p) < distance(nearest)) nearest = p;
        particle_ = static_cast<long>(ids.at(nearest));
        constexpr double far =
            3;  // particles' sizes: beyond the corner of any particle that is not very flat
        if (distance(nearest) <= far * largest_size(run, body_)) return;
        std::vector<double> place;
        for (const std::vector<double>& axis : x) place.push_back(axis[nearest]);
        throw std::runtime_error(
            fmt::format("a probe's `at` ({:.6g}) is far from body \"{}\": the nearest particle, number {} at "
                        "({:.6g}), is {:.4g} m away",
                        fmt::join(at_.begin(), at_.begin() + static_cast<std::ptrdiff_t>(x.size()), ", "),
                        body_, particle_, fmt::join(place, ", "), distance(nearest)));
    } else if (!ids.empty() && static_cast<double>(particle_) > ids.back()) {
        throw std::runtime_error(
            fmt::format("a probe asks for particle {} of body \"{}\", whose particles are 0 to {}", particle_,
                        body_, ids.back()));
    }
}

std::vector<double> Quantity::values(const RunView& run) const {
    std::vector<double> all;
    for (const int component : components_) all.push_back(value(run, component));
    return all;
}

double Quantity::value(const RunView& run, int component) const {
    const auto c = static_cast<std::size_t>(component);
    if (quantity_ == "particle") return of_particle(run, component);
    if (of_field()) return over_particles(run, component);
    if (quantity_ == "reaction") return run.reaction(boundary_condition_)[c];
    if (quantity_ == "contact_force") return run.contact(contact_).force[c];
    if (quantity_ == "contact_torque") return run.contact(contact_).torque[c];
    if (quantity_ == "position") return run.contact(contact_).position[c];
    if (quantity_ == "strain_energy") return run.energies().strain;
    if (quantity_ == "external_work") return run.energies().external;
    if (quantity_ == "total_energy") return run.energies().total();
    if (quantity_ == "contact_energy") return run.energies().contact;
    if (quantity_ == "damped_energy") return run.energies().damped;
    if (quantity_ == "unbalanced_force") return run.unbalanced_force();
    if (quantity_ == "noise") return run.noise();

    double mass = 0;  // kg
    for (const std::string& body : observed_bodies(run, body_)) {
        const std::vector<double> m = run.column(body, "mass", 0);
        mass = std::accumulate(m.begin(), m.end(), mass);
    }
    if (quantity_ == "centroid") return weighted_by_mass(run, "position", component) / mass;
    if (quantity_ == "mass") return body_.empty() ? run.mass() : mass;
    if (quantity_ == "momentum")
        return body_.empty() ? run.momentum()[c] : weighted_by_mass(run, "velocity", component);

    if (body_.empty()) return run.energies().kinetic;
    double energy = 0;  // J
    const std::vector<double> m = run.column(body_, "mass", 0);
    for (int a = 0; a < run.space().dimension(); ++a) {
        const std::vector<double> v = run.column(body_, "velocity", a);
        for (std::size_t p = 0; p < m.size(); ++p) energy += 0.5 * m[p] * v[p] * v[p];
    }
    return energy;
}

// A particle that has been deleted has no value.
double Quantity::of_particle(const RunView& run, int component) const {
    const std::vector<double> ids = run.column(body_, "id", 0);
    const auto id = static_cast<double>(particle_);
    const auto place = std::lower_bound(ids.begin(), ids.end(), id);
    if (place == ids.end() || *place != id) return std::numeric_limits<double>::quiet_NaN();
    return run.column(body_, field_, component)[static_cast<std::size_t>(place - ids.begin())];
}

double Quantity::over_particles(const RunView& run, int component) const {
    std::vector<double> all;
    for (const std::string& body : observed_bodies(run, body_)) {
        if (!has_field(run, body, field_)) continue;
        const std::vector<double> column = run.column(body, field_, component);
        all.insert(all.end(), column.begin(), column.end());
    }
    if (all.empty()) return std::numeric_limits<double>::quiet_NaN();
    if (quantity_ == "min") return *std::min_element(all.begin(), all.end());
    if (quantity_ == "max") return *std::max_element(all.begin(), all.end());
    return std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
}

double Quantity::weighted_by_mass(const RunView& run, const char* field, int component) const {
    double sum = 0;
    for (const std::string& body : observed_bodies(run, body_)) {
        const std::vector<double> m = run.column(body, "mass", 0);
        const std::vector<double> values = run.column(body, field, component);
        sum = std::inner_product(m.begin(), m.end(), values.begin(), sum);
    }
    return sum;
}
