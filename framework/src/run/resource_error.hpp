#pragma once

#include <stdexcept>

namespace matpoint {

/// The machine lacks what the input asks for, or somebody else has it: memory, a folder. Says what to do.
class ResourceError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace matpoint
