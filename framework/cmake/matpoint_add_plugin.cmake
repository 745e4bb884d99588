# matpoint_add_plugin(<name> [PORTABLE] <source>...)
#
# A plugin, as users' own projects and this one build it: the library <name>.so and, beside it, its
# index <name>.plugin.json, from which Matpoint knows the plugin's components without opening it.
# Both are put into MATPOINT_PLUGIN_OUTPUT_DIRECTORY, by default the build folder's plugins/, which
# is what the environment variable MATPOINT_PLUGIN_PATH should then name.
#
# Of MATPOINT_INSTRUCTION_SETS, <name>.so is for the lowest. For each higher one, such as x86-64-v3, there is
# x86-64-v3/<name>.so below it; the best for the machine is opened. PORTABLE leaves these out: for plugins in
# which nothing runs for every particle and step. A project of its own builds for this machine alone, unless it
# is told otherwise; on a machine that lacks something, the dynamic linker refuses the plugin.
function(matpoint_add_plugin name)
  cmake_parse_arguments(PARSE_ARGV 1 plugin PORTABLE "" "")
  if(NOT MATPOINT_PLUGIN_OUTPUT_DIRECTORY)
    set(MATPOINT_PLUGIN_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/plugins)
  endif()
  set(folder ${MATPOINT_PLUGIN_OUTPUT_DIRECTORY})
  add_library(${name} MODULE ${plugin_UNPARSED_ARGUMENTS})
  set_target_properties(${name} PROPERTIES
    PREFIX "" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    LIBRARY_OUTPUT_DIRECTORY ${folder}
    INSTALL_RPATH "$ORIGIN/../.."
    MATPOINT_INSTRUCTION_SET "${MATPOINT_PLUGIN_INSTRUCTION_SET}"
    LINK_DEPENDS_NO_SHARED ON)
  target_link_libraries(${name} PRIVATE matpoint::matpoint)
  if(TARGET matpoint_warnings)
    target_link_libraries(${name} PRIVATE matpoint_warnings)
  endif()
  if(TARGET matpoint_plugin_precompiled)
    target_precompile_headers(${name} REUSE_FROM matpoint_plugin_precompiled)
  endif()
  # A plugin's loops run for every particle and step: never unoptimised by oversight.
  target_compile_options(${name} PRIVATE $<$<CONFIG:>:-O3;-DNDEBUG>
    # A mistake in a component is one in every space: the first few tell it.
    $<$<CXX_COMPILER_ID:GNU>:-fmax-errors=3>
    # Or GCC, which counts what it has inlined for all spaces, leaves plain functions of one particle out of line.
    $<$<CXX_COMPILER_ID:GNU>:--param=inline-unit-growth=1000>)
  target_link_options(${name} PRIVATE -Wl,-z,nodelete -Wl,-z,now)
  add_custom_command(TARGET ${name} POST_BUILD
    COMMAND matpoint::matpoint_index $<TARGET_FILE:${name}>
    BYPRODUCTS ${folder}/${name}.plugin.json
    VERBATIM)

  # Those left by another configuration or installation would be opened.
  file(GLOB others ${folder}/x86-64-v*/${name}.so)
  install(CODE "file(GLOB others \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${MATPOINT_PLUGIN_DIR}/x86-64-v*/${name}.so\")
                if(others)
                  file(REMOVE \${others})
                endif()")
  install(TARGETS ${name} LIBRARY DESTINATION ${MATPOINT_PLUGIN_DIR})
  install(FILES ${folder}/${name}.plugin.json DESTINATION ${MATPOINT_PLUGIN_DIR})
  if(NOT plugin_PORTABLE)
    foreach(set IN LISTS MATPOINT_HIGHER_INSTRUCTION_SETS)
      list(REMOVE_ITEM others ${folder}/${set}/${name}.so)
      # When all has been said about the target, by target_link_libraries and the like.
      cmake_language(EVAL CODE "cmake_language(DEFER CALL matpoint_add_plugin_build [[${name}]] [[${set}]])")
    endforeach()
  endif()
  if(others)
    file(REMOVE ${others})
  endif()
endfunction()

# matpoint_add_plugin_build(<name> <instruction set>): the plugin's library for one of the higher ones.
function(matpoint_add_plugin_build name instruction_set)
  set(build ${name}.${instruction_set})
  get_target_property(sources ${name} SOURCES)
  get_target_property(folder ${name} LIBRARY_OUTPUT_DIRECTORY)
  add_library(${build} MODULE ${sources})
  if(TARGET matpoint_plugin_precompiled.${instruction_set})
    target_precompile_headers(${build} REUSE_FROM matpoint_plugin_precompiled.${instruction_set})
  endif()
  foreach(property IN ITEMS COMPILE_DEFINITIONS COMPILE_FEATURES COMPILE_OPTIONS INCLUDE_DIRECTORIES
                            LINK_DIRECTORIES LINK_LIBRARIES LINK_OPTIONS LINK_DEPENDS_NO_SHARED
                            CXX_VISIBILITY_PRESET VISIBILITY_INLINES_HIDDEN CXX_EXTENSIONS CXX_STANDARD PREFIX)
    get_target_property(value ${name} ${property})
    if(NOT value MATCHES "-NOTFOUND$")
      set_property(TARGET ${build} PROPERTY ${property} "${value}")
    endif()
  endforeach()
  set_target_properties(${build} PROPERTIES
    OUTPUT_NAME ${name} LIBRARY_OUTPUT_DIRECTORY ${folder}/${instruction_set}
    MATPOINT_INSTRUCTION_SET ${instruction_set} INSTALL_RPATH "$ORIGIN/../../..")
  # The index, which is written after the plugin was built, is for all of them.
  add_dependencies(${name} ${build})
  install(TARGETS ${build} LIBRARY DESTINATION ${MATPOINT_PLUGIN_DIR}/${instruction_set})
endfunction()

# matpoint_add_plugin_tests(<name>)
#
# CTest tests of a plugin in a project of its own: `cases` runs <name>.test.json; `conformance` is
# <name>_conformance.cpp, if there is one, linked with the plugin's objects, GoogleTest and a kit of
# matpoint/conformance.
function(matpoint_add_plugin_tests name)
  set(scene_test ${CMAKE_CURRENT_SOURCE_DIR}/${name}.test.json)
  add_test(NAME ${name}.cases COMMAND matpoint::matpoint_cli test ${scene_test})
  set_tests_properties(${name}.cases PROPERTIES ENVIRONMENT "MATPOINT_PLUGIN_PATH=$<TARGET_FILE_DIR:${name}>")
  if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${name}_conformance.cpp)
    find_package(GTest REQUIRED)
    add_executable(${name}_conformance ${name}_conformance.cpp $<TARGET_OBJECTS:${name}>)
    set_target_properties(${name}_conformance PROPERTIES MATPOINT_INSTRUCTION_SET "${MATPOINT_PLUGIN_INSTRUCTION_SET}")
    target_link_libraries(${name}_conformance PRIVATE matpoint::matpoint GTest::gtest_main)
    add_test(NAME ${name}.conformance COMMAND ${name}_conformance)
  endif()
endfunction()
