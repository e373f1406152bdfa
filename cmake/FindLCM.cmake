# LCM behind one target: `LCM::lcm`, and its generator in LCM_GEN_EXECUTABLE.
# LCM >= 1.4 brings a CMake package; 1.3.1 (Debian 12) has pkg-config only, and its .pc file needs
# libglib2.0-dev.
# Not from the registry of build trees: a build of LCM that somebody tried once is no installation.
find_package(lcm CONFIG QUIET NO_CMAKE_PACKAGE_REGISTRY)
if(TARGET lcm)
  set(LCM_VERSION "${lcm_VERSION}")
  add_library(LCM::lcm INTERFACE IMPORTED)
  set_target_properties(LCM::lcm PROPERTIES INTERFACE_LINK_LIBRARIES lcm)
elseif(TARGET lcm::lcm)
  set(LCM_VERSION "${lcm_VERSION}")
  add_library(LCM::lcm INTERFACE IMPORTED)
  set_target_properties(LCM::lcm PROPERTIES INTERFACE_LINK_LIBRARIES lcm::lcm)
else()
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(LCM_PC QUIET IMPORTED_TARGET lcm)
  if(LCM_PC_FOUND)
    set(LCM_VERSION "${LCM_PC_VERSION}")
    add_library(LCM::lcm INTERFACE IMPORTED)
    set_target_properties(LCM::lcm PROPERTIES INTERFACE_LINK_LIBRARIES PkgConfig::LCM_PC)
  endif()
endif()

if(TARGET lcm-gen)
  get_target_property(LCM_GEN_EXECUTABLE lcm-gen LOCATION)
elseif(TARGET lcm::lcm-gen)
  get_target_property(LCM_GEN_EXECUTABLE lcm::lcm-gen LOCATION)
else()
  find_program(LCM_GEN_EXECUTABLE lcm-gen)
endif()

set(LCM_TARGET "")
if(TARGET LCM::lcm)
  set(LCM_TARGET LCM::lcm)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LCM REQUIRED_VARS LCM_TARGET LCM_GEN_EXECUTABLE VERSION_VAR LCM_VERSION
  REASON_FAILURE_MESSAGE "install liblcm-dev liblcm-bin libglib2.0-dev")
