# PkgConfig::FLANN, without the HDF5 and MPI that FLANN's pkg-config file names but its library does
# not use. The prefix of pkg_check_modules is not FLANN: PCL would take over the variables, and lose
# the folders of HDF5 and MPI on the way, so that nothing links.
unset(FLANN_LIBRARIES CACHE)
pkg_check_modules(FALLEN_FLANN REQUIRED IMPORTED_TARGET flann)
get_target_property(fallen_flann_libraries PkgConfig::FALLEN_FLANN INTERFACE_LINK_LIBRARIES)
list(FILTER fallen_flann_libraries EXCLUDE REGEX "lib(hdf5|mpi)[.]")
set_target_properties(PkgConfig::FALLEN_FLANN PROPERTIES
                      INTERFACE_LINK_LIBRARIES "${fallen_flann_libraries}")
add_library(PkgConfig::FLANN ALIAS PkgConfig::FALLEN_FLANN)
