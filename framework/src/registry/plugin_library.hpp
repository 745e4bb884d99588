#pragma once

#include <matpoint/registry.hpp>

#include <filesystem>
#include <stdexcept>
#include <string>

struct matpoint_abi_stamp;

namespace matpoint {

/// A plugin is missing, can't be opened, or doesn't fit; the text says which and what to do.
/// The command line ends with exit status 3.
class PluginError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// One plugin's shared library, opened. It stays in memory until the process ends: what it made
/// (components, their virtual tables, schemas) may outlive this object.
class PluginLibrary {
  public:
    /// Opens the library, or its build for the kernel's instruction set, and compares its stamp with the
    /// kernel's before any C++ call into it.
    explicit PluginLibrary(const std::filesystem::path& file);

    const std::filesystem::path& file() const { return file_; }
    /// The build that was opened: file() or one in a folder below it.
    const std::filesystem::path& opened_file() const { return opened_; }
    const std::string& name() const { return name_; }
    const std::string& version() const { return version_; }

    /// The components that the plugin registers.
    Registry components() const;

  private:
    std::filesystem::path file_, opened_;
    std::string name_, version_;
    void (*register_)(Registry&) = nullptr;
};

}  // namespace matpoint
