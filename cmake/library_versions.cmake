# "Trilinos 13.2.0, gmsh 4.8.4, ...": the versions that the libraries' packages and headers tell.

# The texts or numbers of a header's macros, joined by dots; "" when one of them is not there.
function(dda_version_of_macros header result)
  set(version "")
  file(STRINGS "${header}" lines REGEX "^[ \t]*#[ \t]*define[ \t]")
  foreach(macro IN LISTS ARGN)
    set(value "")
    foreach(line IN LISTS lines)
      if(line MATCHES "define[ \t]+${macro}[ \t]+\"?([0-9.]+)")
        set(value "${CMAKE_MATCH_1}")
      endif()
    endforeach()
    list(APPEND version "${value}")
  endforeach()
  string(REPLACE ";" "." version "${version}")
  set(${result} "${version}" PARENT_SCOPE)
endfunction()

function(dda_library_versions result)
  find_file(DDA_GMSH_HEADER gmshc.h REQUIRED)
  find_file(DDA_GEOS_HEADER geos_c.h REQUIRED)
  find_file(DDA_CHOLMOD_HEADER cholmod_core.h PATH_SUFFIXES suitesparse REQUIRED)
  find_file(DDA_MUMPS_HEADER dmumps_c.h REQUIRED)
  find_package(Trilinos QUIET REQUIRED COMPONENTS Teuchos)
  find_package(MPI QUIET REQUIRED COMPONENTS CXX)
  find_package(CLI11 QUIET REQUIRED)
  pkg_check_modules(DDA_OPENBLAS QUIET openblas)
  dda_version_of_macros(${DDA_GMSH_HEADER} gmsh
    GMSH_API_VERSION_MAJOR GMSH_API_VERSION_MINOR GMSH_API_VERSION_PATCH)
  dda_version_of_macros(${DDA_GEOS_HEADER} geos GEOS_VERSION_MAJOR GEOS_VERSION_MINOR GEOS_VERSION_PATCH)
  dda_version_of_macros(${DDA_CHOLMOD_HEADER} cholmod
    CHOLMOD_MAIN_VERSION CHOLMOD_SUB_VERSION CHOLMOD_SUBSUB_VERSION)
  dda_version_of_macros(${DDA_MUMPS_HEADER} mumps MUMPS_VERSION)
  set(${result}
    "Trilinos ${Trilinos_VERSION}, gmsh ${gmsh}, GEOS ${geos}, HDF5 ${HDF5_VERSION}, CHOLMOD ${cholmod}, \
MUMPS ${mumps}, OpenBLAS ${DDA_OPENBLAS_VERSION}, MPI ${MPI_CXX_VERSION}, Eigen ${Eigen3_VERSION}, fmt ${fmt_VERSION}, \
nlohmann-json ${nlohmann_json_VERSION}, libyaml ${YAML_VERSION}, zlib ${ZLIB_VERSION_STRING}, CLI11 ${CLI11_VERSION}"
    PARENT_SCOPE)
endfunction()
