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

Schema& Schema::use(UseTable table) {
    for (std::size_t k = 0; k < table.parameters.size(); ++k) {
        const std::string chooser = table.chooser, key = table.parameters[k];
        std::string takers;
        for (const UseTable::Row& row : table.rows)
            if (row.uses[k] != Use::refused) takers += (takers.empty() ? "" : ", ") + row.choice;
        for (const UseTable::Row& row : table.rows) {
            if (row.uses[k] == Use::possible) continue;
            const bool needed = row.uses[k] == Use::needed;
            const auto applies = [=, choice = row.choice](const Json& own, const Json&) {
                return own.at(chooser) == choice && own.contains(key) != needed;
            };
            const std::string who = "the " + chooser + " \"" + row.choice + "\" ";
            if (needed)
                refuse("", who + "needs the key `" + key + "`", applies);
            else
                refuse("/" + key, who + "takes no `" + key + "`; these do: " + takers, applies);
            rules_.back().tabled = true;
        }
    }
    table_ = std::move(table);
    return *this;
}

const Parameter* Schema::find(std::string_view name) const {
    const auto found = std::find_if(parameters_.begin(), parameters_.end(),
                                    [&](const Parameter& p) { return p.name == name; });
    return found == parameters_.end() ? nullptr : &*found;
}

}  // namespace matpoint
