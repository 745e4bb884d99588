# The outputs are tested as plugins.
find_package(ZLIB REQUIRED)
target_link_libraries(test_output PRIVATE ZLIB::ZLIB)
add_dependencies(test_output vtk csv probe)
