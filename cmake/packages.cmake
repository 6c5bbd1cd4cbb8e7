# Every third-party library, found once. A folder links only what architecture allows it to see.
include(FindPkgConfig)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
pkg_check_modules(YAML REQUIRED IMPORTED_TARGET yaml-0.1)
pkg_check_modules(HDF5 REQUIRED IMPORTED_TARGET hdf5-serial)
find_package(ZLIB REQUIRED)
pkg_check_modules(MUPARSER REQUIRED IMPORTED_TARGET muparser)
include(hdf5_archive)
include(cholmod_archive)
find_library(GMSH_LIBRARY gmsh REQUIRED)
find_library(SECCOMP_LIBRARY seccomp REQUIRED)  # keeps gmsh to reading and computing
find_library(GEOS_C_LIBRARY geos_c REQUIRED)
