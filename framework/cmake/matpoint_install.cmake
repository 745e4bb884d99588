# The SDK: kernel, headers, conformance kits, command line, index tool, and the package that
# find_package(matpoint) reads. Plugins install themselves (matpoint_add_plugin).
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/matpoint)

install(TARGETS matpoint matpoint_headers matpoint_index matpoint_cli EXPORT matpoint_targets)
# None may be left from an earlier installation: the dynamic linker would take it.
install(CODE "file(GLOB left_over \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/glibc-hwcaps/*/libmatpoint.so*\")
              if(left_over)
                file(REMOVE \${left_over})
              endif()")
foreach(set IN LISTS MATPOINT_HIGHER_INSTRUCTION_SETS)
  install(TARGETS matpoint.${set} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/glibc-hwcaps/${set} NAMELINK_SKIP)
endforeach()
install(EXPORT matpoint_targets NAMESPACE matpoint:: DESTINATION ${package_dir})
install(DIRECTORY ${CMAKE_SOURCE_DIR}/framework/include/matpoint DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${CMAKE_SOURCE_DIR}/tests/conformance/
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/matpoint/conformance FILES_MATCHING PATTERN *.hpp PATTERN plugins.hpp EXCLUDE)

configure_package_config_file(
  ${CMAKE_SOURCE_DIR}/framework/cmake/matpoint-config.cmake.in ${CMAKE_BINARY_DIR}/matpoint-config.cmake
  INSTALL_DESTINATION ${package_dir})
# Before 1.0, a minor release may change the SDK.
write_basic_package_version_file(${CMAKE_BINARY_DIR}/matpoint-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/matpoint-config.cmake ${CMAKE_BINARY_DIR}/matpoint-config-version.cmake
              ${CMAKE_SOURCE_DIR}/framework/cmake/matpoint_add_plugin.cmake
        DESTINATION ${package_dir})
