# matpoint_add_plugin(<name> <source>...)
#
# A plugin, as users' own projects and this one build it: the library <name>.so and, beside it, its
# index <name>.plugin.json, from which Matpoint knows the plugin's components without opening it.
# Both are put into MATPOINT_PLUGIN_OUTPUT_DIRECTORY, by default the build folder's plugins/, which
# is what the environment variable MATPOINT_PLUGIN_PATH should then name.
function(matpoint_add_plugin name)
  if(NOT MATPOINT_PLUGIN_OUTPUT_DIRECTORY)
    set(MATPOINT_PLUGIN_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/plugins)
  endif()
  add_library(${name} MODULE ${ARGN})
  set_target_properties(${name} PROPERTIES
    PREFIX "" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    LIBRARY_OUTPUT_DIRECTORY ${MATPOINT_PLUGIN_OUTPUT_DIRECTORY}
    INSTALL_RPATH "$ORIGIN/../.."
    LINK_DEPENDS_NO_SHARED ON)
  target_link_libraries(${name} PRIVATE matpoint::matpoint)
  if(TARGET matpoint_warnings)
    target_link_libraries(${name} PRIVATE matpoint_warnings)
  endif()
  # A plugin's loops run for every particle and step: never unoptimised by oversight.
  target_compile_options(${name} PRIVATE $<$<CONFIG:>:-O3;-DNDEBUG>)
  target_link_options(${name} PRIVATE -Wl,-z,nodelete -Wl,-z,now)
  add_custom_command(TARGET ${name} POST_BUILD
    COMMAND matpoint::matpoint_index $<TARGET_FILE:${name}>
    BYPRODUCTS ${MATPOINT_PLUGIN_OUTPUT_DIRECTORY}/${name}.plugin.json
    VERBATIM)
  install(TARGETS ${name} LIBRARY DESTINATION ${MATPOINT_PLUGIN_DIR})
  install(FILES ${MATPOINT_PLUGIN_OUTPUT_DIRECTORY}/${name}.plugin.json DESTINATION ${MATPOINT_PLUGIN_DIR})
endfunction()

# matpoint_add_plugin_tests(<name>)
#
# CTest tests of a plugin in a project of its own: `cases` runs <name>.test.json; `conformance` is
# <name>_conformance.cpp, if there is one, built with the plugin's sources, GoogleTest and a kit of
# matpoint/conformance.
function(matpoint_add_plugin_tests name)
  set(scene_test ${CMAKE_CURRENT_SOURCE_DIR}/${name}.test.json)
  add_test(NAME ${name}.cases COMMAND matpoint::matpoint_cli test ${scene_test})
  set_tests_properties(${name}.cases PROPERTIES ENVIRONMENT "MATPOINT_PLUGIN_PATH=$<TARGET_FILE_DIR:${name}>")
  if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${name}_conformance.cpp)
    find_package(GTest REQUIRED)
    get_target_property(sources ${name} SOURCES)
    add_executable(${name}_conformance ${name}_conformance.cpp ${sources})
    target_link_libraries(${name}_conformance PRIVATE matpoint::matpoint GTest::gtest_main)
    add_test(NAME ${name}.conformance COMMAND ${name}_conformance)
  endif()
endfunction()
