#include "run/maker.hpp"

#include "config/formula_places.hpp"
#include "run/resource_error.hpp"

#include <new>
#include <stdexcept>

namespace matpoint {

Maker::Maker(const Scene& scene, const Registry& registry)
    : scene_(scene),
      registry_(registry),
      context_{.space = scene.space,
               .folder = scene.folder,
               .registry = &registry,
               .scene = &scene.resolved,
               .warn = [this](const std::string& text) {
                   diagnostics_.add(scene_.document.diagnostic(pointer_, text, false));
               }} {
    for (const Diagnostic& warning : scene.warnings) diagnostics_.add(warning);
}

void Maker::attempt(const std::string& pointer, const std::function<void()>& action) {
    try {
        action();
    } catch (const std::invalid_argument& wrong) {
        mistake(pointer, wrong.what());
    } catch (const FormulaError& wrong) {
        for (const std::string& place : formula_places(scene_.resolved, wrong.formula()))
            mistake(place, wrong.what());
    } catch (const ComponentFailure& failure) {
        if (failure.out_of_memory()) throw;
        mistake(failure.origin().pointer, failure.reason());
    }
}

void Maker::attempt(const std::string& pointer, const Component& component, const char* function,
                    const std::function<void()>& action) {
    attempt(pointer, [&] {
        try {
            action();
        } catch (const std::invalid_argument&) {
            throw;
        } catch (const std::bad_alloc&) {
            throw;  // hardly the component's
        } catch (const ResourceError&) {
            throw;
        } catch (...) {
            throw_failure(component.origin(), function);
        }
    });
}

void Maker::add(const Findings& findings) {
    for (const Finding& finding : findings)
        diagnostics_.add(scene_.document.diagnostic(finding.pointer, finding.text, finding.error));
}

std::vector<std::string> Maker::warnings() const {
    std::vector<std::string> texts;
    for (const Diagnostic& diagnostic : diagnostics_.all()) texts.push_back(to_string(diagnostic));
    return texts;
}

}  // namespace matpoint
