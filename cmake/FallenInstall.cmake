# find_package(FallenPersonDetector) for others: targets fallen::ndt, fallen::detection, ...
include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/FallenPersonDetector")
install(EXPORT FallenPersonDetectorTargets NAMESPACE fallen:: DESTINATION "${package_dir}")
configure_package_config_file(cmake/FallenPersonDetectorConfig.cmake.in
  "${PROJECT_BINARY_DIR}/FallenPersonDetectorConfig.cmake" INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/FallenPersonDetectorConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/FallenPersonDetectorConfig.cmake"
              "${PROJECT_BINARY_DIR}/FallenPersonDetectorConfigVersion.cmake"
              cmake/FindLCM.cmake cmake/FindOpenNI2.cmake cmake/FallenFlann.cmake
        DESTINATION "${package_dir}")
install(DIRECTORY config models DESTINATION "${CMAKE_INSTALL_DATADIR}/fallen")
