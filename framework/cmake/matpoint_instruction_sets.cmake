# Instruction sets, values of -march, that kernel and plugins are built for, lowest first. The lowest is
# for all code; what runs for every particle and step is built for each, and a machine uses the highest
# that it has. More than one must be levels that the dynamic linker knows (glibc-hwcaps).
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(sets x86-64-v2 x86-64-v3 x86-64-v4)
endif()
set(MATPOINT_INSTRUCTION_SETS "${sets}" CACHE STRING
    "Values of -march to build for, lowest first; the machine's best is used. native: this machine's best. Empty: the compiler's default")
set(MATPOINT_HIGHER_INSTRUCTION_SETS ${MATPOINT_INSTRUCTION_SETS})
if(MATPOINT_INSTRUCTION_SETS STREQUAL "native")
  # The dynamic linker lists, best first, the levels that it knows.
  set(MATPOINT_HIGHER_INSTRUCTION_SETS "")
  if(sets)
    execute_process(COMMAND /lib64/ld-linux-x86-64.so.2 --help OUTPUT_VARIABLE levels ERROR_QUIET)
    set(MATPOINT_HIGHER_INSTRUCTION_SETS x86-64-v2)
    if(levels MATCHES "(x86-64-v[234]) \\(supported")
      set(MATPOINT_HIGHER_INSTRUCTION_SETS ${CMAKE_MATCH_1})
    endif()
  endif()
endif()
if(NOT CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")  # presets name those of x86
  list(FILTER MATPOINT_HIGHER_INSTRUCTION_SETS EXCLUDE REGEX "^x86-64")
endif()
list(POP_FRONT MATPOINT_HIGHER_INSTRUCTION_SETS MATPOINT_LOWEST_INSTRUCTION_SET)
foreach(set IN LISTS MATPOINT_HIGHER_INSTRUCTION_SETS)
  if(NOT set MATCHES "^x86-64-v[34]$")
    message(FATAL_ERROR "MATPOINT_INSTRUCTION_SETS: \"${set}\" can't be chosen at run time, x86-64-v3 and x86-64-v4 can")
  endif()
endforeach()
