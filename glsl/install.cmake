# cmake --install BUILD --component gnomon: this folder as include/gnomon (headers and GLSL side by side, as they lie here), the compiled examples as
# share/gnomon/spirv, and find_package(gnomon) for them. Nothing else is needed: no GLM, no library to link.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
install(DIRECTORY ${CMAKE_CURRENT_LIST_DIR}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gnomon COMPONENT gnomon
  PATTERN "*.cmake*" EXCLUDE PATTERN ".clang-format" EXCLUDE)
install(DIRECTORY ${PROJECT_BINARY_DIR}/host_min/spirv DESTINATION ${CMAKE_INSTALL_DATADIR}/gnomon COMPONENT gnomon FILES_MATCHING PATTERN "*.spv"
  PATTERN "*.counters.spv" EXCLUDE PATTERN hello EXCLUDE)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/gnomonConfig.cmake.in ${PROJECT_BINARY_DIR}/gnomonConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/gnomon PATH_VARS CMAKE_INSTALL_INCLUDEDIR CMAKE_INSTALL_DATADIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/gnomonConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gnomonConfig.cmake ${PROJECT_BINARY_DIR}/gnomonConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/gnomon COMPONENT gnomon)
