# The functions that formulas know are compared with the page that documents them.
find_package(muparser REQUIRED)
target_link_libraries(test_config PRIVATE muparser::muparser)
target_compile_definitions(test_config PRIVATE MATPOINT_FORMULAS_PAGE="${CMAKE_SOURCE_DIR}/framework/docs/formulas.md")
