#pragma once

#include <string>

namespace matpoint {

/// The text with U+FFFD for bytes that are not UTF-8, which JSON can't hold. Names of files may be of any
/// bytes.
std::string as_utf8(const std::string& text);

}  // namespace matpoint
