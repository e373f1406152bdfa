# Third parties as imported targets. What is missing and optional drops the parts that need it, with a
# message; what is missing and needed stops here.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(Eigen3 3.3 REQUIRED NO_MODULE)
find_package(yaml-cpp REQUIRED)
find_package(CLI11 REQUIRED)
find_package(spdlog REQUIRED)
find_package(nlohmann_json REQUIRED)
include(FallenFlann)
pkg_check_modules(ZSTD REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(LZ4 REQUIRED IMPORTED_TARGET liblz4)
find_package(ZLIB REQUIRED)
find_package(PNG REQUIRED)
# Components only: whole PCL drags VTK and Qt into every link.
find_package(PCL 1.12 REQUIRED QUIET COMPONENTS common kdtree search sample_consensus filters features
                                                segmentation io)
find_package(LCM REQUIRED MODULE)     # cmake/FindLCM.cmake: CMake package or pkg-config
find_package(OpenNI2 MODULE)          # cmake/FindOpenNI2.cmake
find_package(SQLite3 QUIET)
pkg_check_modules(MOSQUITTO IMPORTED_TARGET libmosquitto)
find_package(embree 3 CONFIG QUIET)
find_package(assimp CONFIG QUIET)

function(fallen_report name found what)
  if(${found})
    message(STATUS "${name}: found")
  else()
    message(STATUS "${name}: missing, so left out: ${what}")
  endif()
endfunction()
fallen_report("OpenNI2" OpenNI2_FOUND "fallen-depth-capture, .oni input")
fallen_report("SQLite" SQLite3_FOUND "fallen-alarm")
fallen_report("libmosquitto" MOSQUITTO_FOUND "fallen-alarm")
fallen_report("Embree" embree_FOUND "fallen-simulate")
fallen_report("Assimp" assimp_FOUND "fallen-simulate")
