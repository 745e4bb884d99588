#include "config/formula_places.hpp"

#include "config/document.hpp"

namespace matpoint {
namespace {

void find(const Json& value, const std::string& formula, const std::string& at,
          std::vector<std::string>& found) {
    if (value == formula) found.push_back(at);
    if (!value.is_structured()) return;
    for (const auto& item : value.items()) {
        const std::string place = join_pointer(at, item.key());
        if (place != "/checks") find(item.value(), formula, place, found);
    }
}

}  // namespace

std::vector<std::string> formula_places(const Json& scene, const std::string& formula) {
    std::vector<std::string> found;
    find(scene, formula, "", found);
    return found;
}

}  // namespace matpoint
