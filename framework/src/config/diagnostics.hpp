#pragma once

#include "config/nearest.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace matpoint {

/// One thing to tell the user about an input file.
struct Diagnostic {
    bool error = true;      ///< false: a warning
    std::string file{};     ///< the file, or `--set /pointer` for a value from the command line
    int line = 0;           ///< from 1; 0: not in a file's text
    int column = 0;         ///< from 1, in characters
    std::string pointer{};  ///< JSON pointer
    std::string message{};
};

/// `scene.json:14:31: error: /materials/rubber/poissons_ratio: expected a number < 0.5, got 0.7`
std::string to_string(const Diagnostic& diagnostic);

/// Collects, so that all mistakes are reported in one go.
class Diagnostics {
  public:
    void add(Diagnostic diagnostic) { all_.push_back(std::move(diagnostic)); }
    void add(const Diagnostics& others);
    bool has_errors() const;
    bool empty() const { return all_.empty(); }
    /// By line and column.
    std::vector<Diagnostic> all() const;
    /// One a line, by line and column.
    std::string text() const;
    /// Throws InputError if there is an error.
    void throw_if_errors() const;

  private:
    std::vector<Diagnostic> all_;
};

/// The user's input can't be used; what() has every mistake, one a line.
class InputError : public std::runtime_error {
  public:
    explicit InputError(Diagnostics diagnostics)
        : std::runtime_error(diagnostics.text()), diagnostics_(std::move(diagnostics)) {}
    const Diagnostics& diagnostics() const { return diagnostics_; }

  private:
    Diagnostics diagnostics_;
};

}  // namespace matpoint
