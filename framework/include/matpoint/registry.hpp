#pragma once

#include <matpoint/component.hpp>
#include <matpoint/parameters.hpp>
#include <matpoint/requirements.hpp>
#include <matpoint/schema.hpp>
#include <matpoint/space.hpp>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>

namespace matpoint {

template <class S>
class ShapeFunction;
template <class S>
class Transfer;
template <class S>
class Integrator;
template <class S>
class Material;
template <class S>
class BoundaryCondition;
template <class S>
class Load;
template <class S>
class Contact;
template <class S>
class Damping;
template <class S>
class Grid;
class ExactSolution;
class Output;

using Factory = std::function<std::shared_ptr<Component>(const Parameters&)>;

/// The components that have been registered, by kind and type. A plugin adds its own:
/// `registry.material<TaitWater>("tait_water")` compiles TaitWater for every space.
class Registry {
  public:
    struct Entry {
        std::string kind;  ///< "material", "shape_function", …
        std::string type;  ///< the name that scenes use
        Schema schema;
        std::string plugin;  ///< the plugin that registered it, and its version
        std::string version;
        std::array<Factory, SpaceId::count> make;  ///< by SpaceId::index()
    };

    template <template <class> class C>
    void shape_function(std::string type) {
        spatial<C, ShapeFunction>("shape_function", std::move(type));
    }
    template <template <class> class C>
    void transfer(std::string type) {
        spatial<C, Transfer>("transfer", std::move(type));
    }
    template <template <class> class C>
    void integrator(std::string type) {
        spatial<C, Integrator>("integrator", std::move(type));
    }
    template <template <class> class C>
    void material(std::string type) {
        spatial<C, Material>("material", std::move(type));
    }
    template <template <class> class C>
    void boundary_condition(std::string type) {
        spatial<C, BoundaryCondition>("boundary_condition", std::move(type));
    }
    template <template <class> class C>
    void load(std::string type) {
        spatial<C, Load>("load", std::move(type));
    }
    template <template <class> class C>
    void contact(std::string type) {
        spatial<C, Contact>("contact", std::move(type));
    }
    template <template <class> class C>
    void damping(std::string type) {
        spatial<C, Damping>("damping", std::move(type));
    }
    template <template <class> class C>
    void grid(std::string type) {
        spatial<C, Grid>("grid", std::move(type));
    }
    /// Geometries, exact solutions and outputs work in double precision and three coordinates, whatever the
    /// space.
    template <class C>
    void geometry(std::string type) {
        plain<C, Geometry>("geometry", std::move(type));
    }
    template <class C>
    void exact_solution(std::string type) {
        plain<C, ExactSolution>("exact_solution", std::move(type));
    }
    template <class C>
    void output(std::string type) {
        plain<C, Output>("output", std::move(type));
    }

    /// Throws std::runtime_error naming both plugins if `kind`/`type` is there already.
    void add(Entry entry);
    const Entry* find(const std::string& kind, const std::string& type) const;
    const std::map<std::pair<std::string, std::string>, Entry>& entries() const { return entries_; }

    /// Makes the component that `own["type"]` names, for the context's space. The entry must exist
    /// (validation has seen to it). `C` is the kind's interface, `pointer` the place of `own` in the scene.
    /// std::invalid_argument tells a mistake in the parameters; all else is a ComponentFailure.
    template <class C>
    std::shared_ptr<C> make(const std::string& kind, const Json& own, const Parameters::Context& context,
                            const std::string& pointer = {}) const {
        return std::static_pointer_cast<C>(make_component(kind, own, context, pointer));
    }

    /// Set by the loader around a plugin's registration, so that entries know where they are from.
    void set_current_plugin(std::string name, std::string version);

  private:
    // A requirement that is not met would be told again for every space.
    template <template <class> class C, template <class> class Interface>
    void spatial(const char* kind, std::string type) {
        if constexpr (is_component<C<PlaneStrain>, Interface<PlaneStrain>>()) {
            Entry entry{kind, std::move(type), C<PlaneStrain>::schema(), plugin_, version_, {}};
#define MATPOINT_ADD_FACTORY(S)                                                                \
    entry.make[static_cast<std::size_t>(SpaceId::of<S>().index())] = [](const Parameters& p) { \
        return std::make_shared<C<S>>(p);                                                      \
    };
            MATPOINT_FOR_EACH_SPACE(MATPOINT_ADD_FACTORY)
#undef MATPOINT_ADD_FACTORY
            add(std::move(entry));
        }
    }
    template <class C, class Interface>
    void plain(const char* kind, std::string type) {
        if constexpr (is_component<C, Interface>()) {
            Entry entry{kind, std::move(type), C::schema(), plugin_, version_, {}};
            entry.make.fill([](const Parameters& p) { return std::make_shared<C>(p); });
            add(std::move(entry));
        }
    }
    std::shared_ptr<Component> make_component(const std::string& kind, const Json& own,
                                              const Parameters::Context& context,
                                              const std::string& pointer) const;

    std::map<std::pair<std::string, std::string>, Entry> entries_;
    std::string plugin_, version_;
};

}  // namespace matpoint
