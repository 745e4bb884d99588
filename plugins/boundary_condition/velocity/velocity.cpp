#include <matpoint/boundary_condition.hpp>
#include <matpoint/plugin.hpp>

#include <algorithm>
#include <limits>
#include <optional>

namespace matpoint {

/// A velocity given by position and time.
template <class S>
class Velocity final : public BoundaryCondition<S> {
  public:
    using typename BoundaryCondition<S>::Vector;
    using typename BoundaryCondition<S>::Position;

    explicit Velocity(const Parameters& parameters) {
        for (const Json& component : parameters.json().at("velocity"))
            velocity_.push_back(component.is_null() ? std::nullopt : std::optional<Profile>(component));
    }

    static Schema schema() {
        Schema schema("Components of velocity are prescribed", "[Chen & Brannon 2002, sec. 2]");
        return schema
            .add("velocity", ParameterType::profiles,
                 {.unit = "m/s",
                  .doc = "Numbers, tables of t, or formulas of x, y, z, t; null leaves one free"})
            .refuse("/velocity", "every component is left free: the condition prescribes nothing",
                    [](const Json& own, const Json&) {
                        return std::ranges::all_of(own.at("velocity"),
                                                   [](const Json& component) { return component.is_null(); });
                    });
    }

    std::array<bool, 3> prescribes(int) const override {
        std::array<bool, 3> prescribed{};
        for (std::size_t a = 0; a < velocity_.size(); ++a) prescribed[a] = velocity_[a].has_value();
        return prescribed;
    }

    Vector velocity(const Position& position, double time) const override {
        std::array<double, 3> x{};
        std::copy_n(position.data(), S::dimension, x.begin());
        Vector v = Vector::Zero();
        for (int a = 0; a < S::dimension; ++a)
            if (const auto& component = velocity_[static_cast<std::size_t>(a)])
                v[a] = static_cast<typename S::Real>((*component)(x, time));
        return v;
    }

    double settled_at() const override {
        double time = 0;
        for (const auto& component : velocity_)
            if (component) time = std::max(time, component->zero_from());
        return time;
    }

  private:
    std::vector<std::optional<Profile>> velocity_;
};

}  // namespace matpoint

MATPOINT_PLUGIN("velocity", "1.0.0") {
    registry.boundary_condition<matpoint::Velocity>("velocity");
}
