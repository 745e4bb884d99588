#pragma once

#include <string>
#include <vector>

namespace matpoint {

/// A verb of the command line: gets the arguments after its name, returns the exit status.
using Verb = int(const std::vector<std::string>& arguments);

Verb run;
Verb restart;
Verb validate;
Verb list;
Verb describe;
Verb schema;
Verb test;
Verb study;
Verb limits;

// What the exit status says (SCENE.md).
inline constexpr int exit_done = 0, exit_failed = 1, exit_bad_input = 2, exit_missing = 3;

}  // namespace matpoint
