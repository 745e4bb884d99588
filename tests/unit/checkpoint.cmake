find_package(PkgConfig REQUIRED)
pkg_check_modules(hdf5 REQUIRED IMPORTED_TARGET hdf5-serial)
target_link_libraries(test_checkpoint PRIVATE PkgConfig::hdf5)
