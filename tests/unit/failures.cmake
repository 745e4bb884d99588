add_dependencies(test_failures faulty)
target_compile_definitions(test_failures PRIVATE TEST_PLUGINS="${CMAKE_BINARY_DIR}/tests/plugins")
