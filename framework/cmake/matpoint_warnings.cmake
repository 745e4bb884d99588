# Warnings for the project's own code; they are not exported to users' plugins.
# GCC 12 sees copies in std::string's operator+ that overlap, have no end or go beyond an array (its bug 105651), and numbers without a value
# where it splits the vectors of plugins for a processor that lacks ones of 32 bytes; in their other builds it may look.
set(split "$<NOT:$<OR:$<BOOL:$<TARGET_PROPERTY:MATPOINT_INSTRUCTION_SET>>,$<STREQUAL:${MATPOINT_LOWEST_INSTRUCTION_SET},x86-64-v3>>>")
add_library(matpoint_warnings INTERFACE)
target_compile_options(matpoint_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict$<SEMICOLON>-Wno-stringop-overflow$<SEMICOLON>-Wno-stringop-overread$<SEMICOLON>-Wno-array-bounds>
  $<$<AND:$<STREQUAL:$<TARGET_PROPERTY:TYPE>,MODULE_LIBRARY>,${split}>:-Wno-maybe-uninitialized>
  $<$<BOOL:${MATPOINT_WARNINGS_AS_ERRORS}>:-Werror>)
