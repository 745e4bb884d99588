#pragma once

#include <matpoint/parameters.hpp>
#include <matpoint/registry.hpp>

#include "config/scene.hpp"
#include "run/scene_checks.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace matpoint {

/// Makes a scene's components and turns what they complain of into diagnostics.
class Maker {
  public:
    Maker(const Scene& scene, const Registry& registry);

    template <class C>
    std::shared_ptr<C> make(const std::string& kind, const std::string& pointer) {
        std::shared_ptr<C> made;
        pointer_ = pointer;
        attempt(pointer, [&] { made = registry_.make<C>(kind, json(pointer), context_, pointer); });
        return made;
    }
    void attempt(const std::string& pointer, const std::function<void()>& action);
    /// The same for what is up to a component: it may complain, or fail.
    void attempt(const std::string& pointer, const Component& component, const char* function,
                 const std::function<void()>& action);
    void mistake(const std::string& pointer, const std::string& text) {
        diagnostics_.add(scene_.document.diagnostic(pointer, text));
    }
    const Json& json(const std::string& pointer) const {
        return scene_.resolved.at(Json::json_pointer(pointer));
    }
    void add(const Findings& findings);
    void throw_if_errors() const { diagnostics_.throw_if_errors(); }
    /// In the order of the scene's text.
    std::vector<std::string> warnings() const;

  private:
    const Scene& scene_;
    const Registry& registry_;
    Parameters::Context context_;
    std::string pointer_;  ///< of what is being made
    Diagnostics diagnostics_;
};

}  // namespace matpoint
