# The kinds of target that this project has.

# Sources say `#include "fallen/ndt/ndt_map.hpp"`, in the tree as after installation: in the build
# folder, `include/fallen` is a link to `common/`.
file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/include")
file(CREATE_LINK "${PROJECT_SOURCE_DIR}/common" "${PROJECT_BINARY_DIR}/include/fallen" SYMBOLIC)

add_library(fallen_warnings INTERFACE)
target_compile_options(fallen_warnings INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor
                       -Woverloaded-virtual -Wconversion -Wno-sign-conversion -Wno-float-conversion
                       # False alarms of GCC 12 on std::string (GCC bug 105651).
                       -Wno-restrict
                       $<$<BOOL:${FALLEN_WERROR}>:-Werror>)
# Results must be the same in every process and on every x86-64: no contraction to fused operations.
target_compile_options(fallen_warnings INTERFACE -ffp-contract=off)

# fallen_library(<name> SOURCES <file>... DEPENDS <public target>... PRIVATE <private target>...)
# makes fallen_<name>, alias fallen::<name>, installed and exported; its headers are those of its folder. A
# library without sources is a header-only one.
function(fallen_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE" ${ARGN})
  set(target fallen_${name})
  if(ARG_SOURCES)
    add_library(${target} STATIC ${ARG_SOURCES})
    set(scope PUBLIC)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:fallen_warnings> ${ARG_PRIVATE})
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(fallen::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(${target} ${scope} cxx_std_20)
  target_include_directories(${target} ${scope}
    $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(${target} ${scope} ${ARG_DEPENDS})
  install(TARGETS ${target} EXPORT FallenPersonDetectorTargets)
  get_filename_component(folder "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
  install(DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/fallen/${folder}"
          FILES_MATCHING PATTERN "*.hpp")
endfunction()

# fallen_tool_library(<name> SOURCES <file>... DEPENDS <public target>... PRIVATE <private target>...) makes
# fallen_<name>: code that command lines share, not installed. Sources say
# `#include "tools/common/tool.hpp"`.
function(fallen_tool_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE" ${ARGN})
  set(target fallen_${name})
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(fallen::${name} ALIAS ${target})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${target} PUBLIC ${ARG_DEPENDS} PRIVATE fallen_warnings ${ARG_PRIVATE})
endfunction()

# fallen_executable(<output name> SOURCES <file>... DEPENDS <target>...) makes an installed program.
function(fallen_executable name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_compile_features(${name} PRIVATE cxx_std_20)
  target_link_libraries(${name} PRIVATE fallen_warnings ${ARG_DEPENDS})
  install(TARGETS ${name} RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
endfunction()

# fallen_service(<name> [PROGRAM <program>] SOURCES <file>... DEPENDS <target>...) makes fallen_<name>_service,
# which tests link, and of it and main.cpp the installed program, fallen-<name> unless told. Sources say
# `#include "services/<name>/<name>_service.hpp"`.
function(fallen_service name)
  cmake_parse_arguments(ARG "" "PROGRAM" "SOURCES;DEPENDS" ${ARGN})
  set(target fallen_${name}_service)
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(fallen::${name}_service ALIAS ${target})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${target} PUBLIC fallen::service ${ARG_DEPENDS} PRIVATE fallen_warnings)
  string(REPLACE "_" "-" program "fallen-${name}")
  if(ARG_PROGRAM)
    set(program ${ARG_PROGRAM})
  endif()
  fallen_executable(${program} SOURCES main.cpp DEPENDS ${target})
endfunction()

# fallen_test(<name> SOURCES <file>... DEPENDS <target>...) makes a GoogleTest program and registers
# each of its tests. Tests find the repository in FALLEN_SOURCE_DIR and programs in FALLEN_BIN_DIR.
function(fallen_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;LABELS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_compile_features(${name} PRIVATE cxx_std_20)
  target_compile_definitions(${name} PRIVATE FALLEN_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                             FALLEN_BIN_DIR="${PROJECT_BINARY_DIR}/bin")
  target_link_libraries(${name} PRIVATE fallen_warnings ${ARG_DEPENDS} GTest::gmock_main)
  # Saves a fifth of the compiling. Libraries are optimised as shipped, but for what headers define.
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests")
  # NO_PRETTY_VALUES: a parameter has its name; its bytes would differ from build to build.
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 NO_PRETTY_VALUES PROPERTIES TIMEOUT 300 LABELS "${ARG_LABELS}")
endfunction()
