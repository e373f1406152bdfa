# OpenNI2 as `OpenNI2::OpenNI2`; the folder of its driver interface in OpenNI2_INCLUDE_DIR.
find_package(PkgConfig QUIET)
pkg_check_modules(OpenNI2_PC QUIET libopenni2)
find_path(OpenNI2_INCLUDE_DIR OpenNI.h HINTS ${OpenNI2_PC_INCLUDE_DIRS} PATH_SUFFIXES openni2)
find_library(OpenNI2_LIBRARY OpenNI2 HINTS ${OpenNI2_PC_LIBRARY_DIRS})
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenNI2 REQUIRED_VARS OpenNI2_LIBRARY OpenNI2_INCLUDE_DIR
                                  VERSION_VAR OpenNI2_PC_VERSION)
if(OpenNI2_FOUND AND NOT TARGET OpenNI2::OpenNI2)
  add_library(OpenNI2::OpenNI2 UNKNOWN IMPORTED)
  set_target_properties(OpenNI2::OpenNI2 PROPERTIES IMPORTED_LOCATION "${OpenNI2_LIBRARY}")
  # Folders of imported targets are system folders: its headers warn under our flags.
  set_target_properties(OpenNI2::OpenNI2 PROPERTIES INTERFACE_INCLUDE_DIRECTORIES
                        "${OpenNI2_INCLUDE_DIR}")
endif()
