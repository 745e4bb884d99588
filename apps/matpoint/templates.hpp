#pragma once

#include <span>
#include <string_view>

namespace matpoint {

/// A file under templates/, embedded at build time: "material/NAME.cpp" and its text.
struct TemplateFile {
    std::string_view path, text;
};
std::span<const TemplateFile> template_files();

/// The names of the SDK's classes.
std::span<const std::string_view> sdk_names();

}  // namespace matpoint
