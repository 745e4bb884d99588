#pragma once

#include <string_view>

namespace matpoint {

/// What this kernel's code for every particle and step was compiled for, such as "x86-64-v3". There is a
/// kernel library for each instruction set, and the dynamic linker takes the machine's best.
std::string_view instruction_set();

}  // namespace matpoint
