#include <matpoint/schema.hpp>

#include <algorithm>

namespace matpoint {

Schema& Schema::add(std::string name, ParameterType type, ParameterOptions o) {
    parameters_.push_back({std::move(o), std::move(name), type});
    return *this;
}

Schema& Schema::writes(std::string file) {
    files_.push_back(std::move(file));
    return *this;
}

Schema& Schema::refuse(std::string pointer, std::string reason,
                       std::function<bool(const Json&, const Json&)> applies) {
    rules_.push_back({true, std::move(pointer), std::move(reason), std::move(applies)});
    return *this;
}

Schema& Schema::warn(std::string pointer, std::string reason,
                     std::function<bool(const Json&, const Json&)> applies) {
    rules_.push_back({false, std::move(pointer), std::move(reason), std::move(applies)});
    return *this;
}

const Parameter* Schema::find(std::string_view name) const {
    const auto found = std::find_if(parameters_.begin(), parameters_.end(),
                                    [&](const Parameter& p) { return p.name == name; });
    return found == parameters_.end() ? nullptr : &*found;
}

}  // namespace matpoint
