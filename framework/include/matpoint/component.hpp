#pragma once

#include <stdexcept>
#include <string>

namespace matpoint {

/// Where a component comes from; messages about it name that.
struct Origin {
    std::string kind, type;       ///< "material", "tait_water"
    std::string plugin, version;  ///< of the plugin that registered it
    std::string pointer;          ///< JSON pointer to its object in the scene; "" if it was made without one
};

/// material "tait_water" of plugin "tait_water" 0.1.0
std::string to_string(const Origin& origin);

/// Base of everything a plugin makes.
class Component {
  public:
    Component() = default;
    Component(const Component&) = delete;
    Component& operator=(const Component&) = delete;
    virtual ~Component();

    /// Known as soon as the constructor has ended.
    const Origin& origin() const { return origin_; }

  private:
    friend class Registry;
    Origin origin_;
};

/// What a component threw, with where the component is from. what() is all of it; `reason` leaves the pointer
/// out.
class ComponentFailure : public std::runtime_error {
  public:
    ComponentFailure(Origin origin, const std::string& reason, bool out_of_memory);
    ~ComponentFailure() override;

    const Origin& origin() const { return origin_; }
    const std::string& reason() const { return reason_; }
    bool out_of_memory() const { return out_of_memory_; }

  private:
    Origin origin_;
    std::string reason_;
    bool out_of_memory_;
};

/// What the exception in flight says, whatever its type: "std::out_of_range: …", "an int, …".
std::string text_of_exception();

/// Throws the ComponentFailure for the exception in flight, which left `function` of a component.
[[noreturn]] void throw_failure(const Origin& origin, const char* function);

/// Calls a function of a component. Whatever that throws becomes a ComponentFailure; one that comes from a
/// component within it is kept. Costs nothing as long as nothing is thrown.
template <class Call>
decltype(auto) guarded(const Component& component, const char* function, const Call& call) {
    try {
        return call();
    } catch (...) {
        throw_failure(component.origin(), function);
    }
}

}  // namespace matpoint
