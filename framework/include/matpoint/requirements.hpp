#pragma once

#include <matpoint/parameters.hpp>
#include <matpoint/schema.hpp>

#include <concepts>
#include <type_traits>

namespace matpoint {

/// Whether C can be a component of the kind that has this interface. What it lacks is told in a sentence.
template <class C, class Interface>
consteval bool is_component() {
    constexpr bool derives = std::derived_from<C, Interface>;
    static_assert(derives,
                  "a component derives, publicly, from the interface of the kind that it is registered as: "
                  "registry.material<Law>(\"law\") takes a Law that derives from Material<Space>, "
                  "registry.geometry<Shape>(\"shape\") a Shape that derives from Geometry");
    constexpr bool described = requires {
        { C::schema() } -> std::convertible_to<Schema>;
    };
    static_assert(described,
                  "a component describes its parameters: it has a public function "
                  "`static Schema schema() { return Schema(\"What it is\").number(...); }`");
    constexpr bool whole = !derives || !std::is_abstract_v<C>;
    static_assert(
        whole,
        "a component overrides every function that its interface declares with `= 0`, with the same "
        "parameters and `const`; those that are missing are named below");
    if constexpr (!whole) new C;  // the compiler names them
    constexpr bool made = !whole || std::is_constructible_v<C, const Parameters&>;
    static_assert(made,
                  "a component is made from its parameters: it has a public constructor "
                  "`explicit Law(const Parameters& parameters)`");
    if constexpr (derives && described && whole && made) {
        if constexpr (requires { C::is_complete(); }) return C::is_complete();
        return true;
    }
    return false;
}

}  // namespace matpoint
