# matpoint_precompile(<name> <instruction set> <header>...)
#
# Most of the time that a file takes to compile goes into the headers of libraries. They are read once, by the
# target <name>, for all targets with the same options, which say
# target_precompile_headers(<target> REUSE_FROM <name>). <instruction set> is empty for the lowest. Programs,
# which are compiled otherwise than libraries, take them from matpoint_precompile_for_programs(<name> <header>...).
function(matpoint_precompile name instruction_set)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(GENERATE OUTPUT ${source} CONTENT "")
  add_library(${name} OBJECT ${source})
  set_target_properties(${name} PROPERTIES MATPOINT_INSTRUCTION_SET "${instruction_set}")
  target_link_libraries(${name} PRIVATE matpoint_headers matpoint_warnings)
  target_precompile_headers(${name} PRIVATE
    <nlohmann/json.hpp> <Eigen/Core> <Eigen/Geometry>
    <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <optional> <span> <stdexcept> <string> <vector>
    ${ARGN})
endfunction()

function(matpoint_precompile_for_programs name)
  matpoint_precompile(${name} "" <fmt/format.h> <fmt/ranges.h> ${ARGN})
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
  target_compile_options(${name} PRIVATE -fPIE)
  target_link_libraries(${name} PRIVATE fmt::fmt)
endfunction()
