#pragma once

#include "config/catalogue.hpp"
#include "registry/catalogue.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace matpoint {

/// All components that there are. A plugin that can't be opened is told of on stderr, once, and does
/// not hide the others.
class AllComponents final : public Catalogue {
  public:
    AllComponents();

    const Schema* find(const std::string& kind, const std::string& type) override;
    /// Those whose plugins could be opened.
    std::vector<std::string> types(const std::string& kind) const override;
    /// 3 if a plugin could not be opened.
    int exit_status() const;

  private:
    void report(const std::string& message);

    std::optional<PluginCatalogue> plugins_;
    std::set<std::string> reported_;
};

}  // namespace matpoint
