#include "config/diagnostics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace matpoint {

std::string to_string(const Diagnostic& d) {
    std::string text = d.file;
    if (d.line > 0) text += fmt::format(":{}:{}", d.line, d.column);
    text += d.error ? ": error: " : ": warning: ";
    if (!d.pointer.empty()) text += d.pointer + ": ";
    return text + d.message;
}

void Diagnostics::add(const Diagnostics& others) {
    all_.insert(all_.end(), others.all_.begin(), others.all_.end());
}

bool Diagnostics::has_errors() const {
    return std::any_of(all_.begin(), all_.end(), [](const Diagnostic& d) { return d.error; });
}

std::vector<Diagnostic> Diagnostics::all() const {
    std::vector<Diagnostic> sorted = all_;
    std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return std::tie(a.line, a.column) < std::tie(b.line, b.column);
    });
    return sorted;
}

std::string Diagnostics::text() const {
    std::string text;
    for (const Diagnostic& d : all()) {
        if (!text.empty()) text += '\n';
        text += to_string(d);
    }
    return text;
}

void Diagnostics::throw_if_errors() const {
    if (has_errors()) throw InputError(*this);
}

}  // namespace matpoint
