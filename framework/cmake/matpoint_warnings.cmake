# Warnings for the project's own code; they are not exported to users' plugins.
# GCC 12 sees overlapping copies in std::string's operator+ that aren't there (its bug 105651).
add_library(matpoint_warnings INTERFACE)
target_compile_options(matpoint_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
  $<$<BOOL:${MATPOINT_WARNINGS_AS_ERRORS}>:-Werror>)
