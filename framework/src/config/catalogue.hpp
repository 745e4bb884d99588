#pragma once

#include <matpoint/schema.hpp>

#include <string>
#include <vector>

namespace matpoint {

/// The components that there are, as far as checking a scene needs to know them.
class Catalogue {
  public:
    virtual ~Catalogue() = default;
    /// The self-description of a type, opening its plugin if need be; nullptr if there is no such type.
    virtual const Schema* find(const std::string& kind, const std::string& type) = 0;
    /// The names of all types of a kind, opened or not.
    virtual std::vector<std::string> types(const std::string& kind) const = 0;
    /// What messages about a component that is known say of its origin.
    virtual std::string origin(const std::string& kind, const std::string& type) const {
        return kind + " \"" + type + "\"";
    }
};

}  // namespace matpoint
