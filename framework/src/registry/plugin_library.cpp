#include "registry/plugin_library.hpp"

#include "registry/instruction_set.hpp"

#define BOOST_DLL_USE_STD_FS
#include <dlfcn.h>
#include <fmt/format.h>

#include <boost/core/demangle.hpp>
#include <vector>  // library_info.hpp lacks it

#include <boost/dll/library_info.hpp>
#include <boost/dll/shared_library.hpp>
#include <cstring>
#include <matpoint/plugin.hpp>
#include <string_view>

namespace matpoint {

namespace {

const matpoint_abi_stamp kernel_stamp = MATPOINT_STAMP("kernel", MATPOINT_VERSION);

constexpr const char* rebuild_advice = "rebuild the plugin against this installation's SDK";

/// A text of a stamp, which a foreign plugin need not have ended with a zero.
template <std::size_t N>
std::string text(const char (&characters)[N]) {
    return {characters, strnlen(characters, N)};
}

/// 30400 -> "3.4.0"
std::string version_text(int version) {
    return fmt::format("{}.{}.{}", version / 10000, version / 100 % 100, version % 100);
}

/// The plugin's build for the highest instruction set that the kernel's has all of: <name>.so in the folder
/// x86-64-v4, say, below the plugin's, or the plugin itself.
std::filesystem::path best_build(const std::filesystem::path& plugin) {
    bool kernel_has_it = false;
    for (const std::string_view set : {"x86-64-v4", "x86-64-v3"}) {
        kernel_has_it = kernel_has_it || set == instruction_set();
        const std::filesystem::path build = plugin.parent_path() / set / plugin.filename();
        if (kernel_has_it && std::filesystem::exists(plugin) && std::filesystem::exists(build)) return build;
    }
    return plugin;
}

/// Turns the dynamic linker's reason into one that says what to do.
[[noreturn]] void throw_not_opened(const std::filesystem::path& file, std::string_view reason) {
    constexpr std::string_view undefined = "undefined symbol: ";
    if (const auto at = reason.find(undefined); at != reason.npos) {
        std::string_view symbol = reason.substr(at + undefined.size());
        symbol = symbol.substr(0, symbol.find_first_of(", )\t\n"));
        throw PluginError(fmt::format(
            "plugin {} needs \"{}\", which neither this kernel ({}) nor the libraries that the plugin "
            "is linked to have: {}, or link the library that defines it (target_link_libraries)",
            file.string(), boost::core::demangle(std::string(symbol).c_str()), MATPOINT_VERSION,
            rebuild_advice));
    }
    if (reason.find("cannot open shared object file") != reason.npos)
        throw PluginError(
            fmt::format("plugin {} needs a library that is missing on this machine: install it, or add its "
                        "folder to LD_LIBRARY_PATH ({})",
                        file.string(), reason));
    if (reason.find("CPU ISA level is lower") != reason.npos)
        throw PluginError(fmt::format(
            "plugin {} was built for a better instruction set than this machine's ({}): rebuild it "
            "here, or for all with -DMATPOINT_INSTRUCTION_SETS=all",
            file.string(), instruction_set()));
    throw PluginError(
        fmt::format("{} is not a shared library that can be opened: give the .so file that "
                    "matpoint_add_plugin built ({})",
                    file.string(), reason));
}

boost::dll::shared_library open(const std::filesystem::path& file) {
    using boost::dll::load_mode::type;
    std::error_code status;
    if (!std::filesystem::is_regular_file(file, status))
        throw PluginError(
            fmt::format("plugin {} {}: check the path, or build the plugin first", file.string(),
                        std::filesystem::exists(file, status) ? "is not a file" : "does not exist"));
    try {
        // The dynamic linker would crash on a library that was cut short: its headers are at its end.
        boost::dll::library_info(file).sections();
    } catch (const std::exception&) {
        throw_not_opened(file, "the file is cut short, or not in this machine's binary format");
    }
    try {
        // RTLD_NODELETE keeps a library that was not linked with -z nodelete, too.
        return boost::dll::shared_library(std::filesystem::absolute(file),
                                          boost::dll::load_mode::rtld_now |
                                              boost::dll::load_mode::rtld_local |
                                              static_cast<type>(RTLD_NODELETE));
    } catch (const std::system_error& error) {
        throw_not_opened(file, error.what());
    }
}

void check_stamp(const std::filesystem::path& file, const matpoint_abi_stamp& plugin) {
    std::string differences;
    const auto compare = [&](const char* what, const std::string& kernel_has, const std::string& plugin_has) {
        if (kernel_has != plugin_has)
            differences +=
                fmt::format("\n  {}: the kernel has {}, the plugin has {}", what, kernel_has, plugin_has);
    };
    const matpoint_abi_stamp& kernel = kernel_stamp;
    compare("ABI version", std::to_string(kernel.abi_version), std::to_string(plugin.abi_version));
    compare("compiler", text(kernel.compiler), text(plugin.compiler));
    compare("standard library", text(kernel.standard_library), text(plugin.standard_library));
    compare("Eigen", version_text(kernel.eigen_version), version_text(plugin.eigen_version));
    compare("Eigen's largest alignment in bytes", std::to_string(kernel.eigen_max_align_bytes),
            std::to_string(plugin.eigen_max_align_bytes));
    compare("nlohmann-json", version_text(kernel.json_version), version_text(plugin.json_version));
    if (!differences.empty())
        throw PluginError(fmt::format("plugin {} was built for another binary interface:{}\n  {}",
                                      file.string(), differences, rebuild_advice));
}

}  // namespace

PluginLibrary::PluginLibrary(const std::filesystem::path& plugin)
    : file_(plugin), opened_(best_build(plugin)) {
    const std::filesystem::path& file = opened_;
    const boost::dll::shared_library library = open(file);
    constexpr const char* advice = "a plugin's source has MATPOINT_PLUGIN(\"name\", \"version\") { ... }";
    if (!library.has("matpoint_plugin_stamp"))
        throw PluginError(fmt::format("{} is not a Matpoint plugin: it has no matpoint_plugin_stamp; {}",
                                      file.string(), advice));
    const auto& stamp = library.get<const matpoint_abi_stamp>("matpoint_plugin_stamp");
    if (text(stamp.magic) != kernel_stamp.magic || stamp.stamp_size != kernel_stamp.stamp_size)
        throw PluginError(
            fmt::format("{} is not a Matpoint plugin: its matpoint_plugin_stamp is not one that "
                        "this kernel knows; {}",
                        file.string(), advice));
    check_stamp(file, stamp);
    if (!library.has("matpoint_plugin_register"))
        throw PluginError(
            fmt::format("plugin {} has no function matpoint_plugin_register; {}", file.string(), advice));
    register_ = &library.get<void(Registry&)>("matpoint_plugin_register");
    name_ = text(stamp.plugin);
    version_ = text(stamp.plugin_version);
}

Registry PluginLibrary::components() const {
    Registry registry;
    registry.set_current_plugin(name_, version_);
    try {
        register_(registry);
    } catch (...) {
        throw PluginError(
            fmt::format("plugin \"{}\" {} ({}) failed while it registered its components: \"{}\"", name_,
                        version_, opened_.string(), text_of_exception()));
    }
    return registry;
}

}  // namespace matpoint
