#pragma once

#include "config/catalogue.hpp"

namespace matpoint {

/// For checking objects that name no components, such as checks and cases.
class NoComponents final : public Catalogue {
  public:
    const Schema* find(const std::string&, const std::string&) override { return nullptr; }
    std::vector<std::string> types(const std::string&) const override { return {}; }
};

}  // namespace matpoint
