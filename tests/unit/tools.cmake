target_sources(test_tools PRIVATE ${CMAKE_SOURCE_DIR}/plugins/contact/rigid_tool/motion.cpp)
target_include_directories(test_tools PRIVATE ${CMAKE_SOURCE_DIR}/plugins/contact/rigid_tool)
