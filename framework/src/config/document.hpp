#pragma once

#include "config/diagnostics.hpp"

#include <matpoint/schema.hpp>

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace matpoint {

struct Position {
    int line = 0;    ///< from 1
    int column = 0;  ///< from 1, in characters
};

/// A JSON file that remembers where everything stood in its text. Comments are allowed in it.
struct Document {
    std::filesystem::path path;
    Json json;
    /// By JSON pointer: where a member's key, or an array's element, starts.
    std::map<std::string, Position> positions;
    /// JSON pointers whose values came from `--set`.
    std::set<std::string> overrides;
    /// Keys given twice.
    Diagnostics mistakes;

    /// A message about `pointer`, located there or at the nearest object around it.
    Diagnostic diagnostic(const std::string& pointer, std::string message, bool error = true) const;
    /// Of the value at `pointer` and of all in it.
    void forget_positions(const std::string& pointer);
};

/// Throws InputError if the file can't be read or isn't JSON.
Document read_document(const std::filesystem::path& file);
/// The same for a text; `path` is what messages call it.
Document parse_document(std::string_view text, std::filesystem::path path);

/// Applies `/json/pointer=VALUE`; VALUE is text if it isn't JSON. All of the pointer but its last
/// key must exist.
void apply_set(Document& document, std::string_view assignment, Diagnostics& diagnostics);

/// The JSON pointer of a member of the object at `pointer`.
std::string join_pointer(const std::string& pointer, std::string_view key);

}  // namespace matpoint
