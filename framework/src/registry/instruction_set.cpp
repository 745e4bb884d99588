#include "registry/instruction_set.hpp"

namespace matpoint {

std::string_view instruction_set() {
    return MATPOINT_INSTRUCTION_SET;
}

}  // namespace matpoint
