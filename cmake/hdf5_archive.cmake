# HDF5 for one process, as an archive where there is one, with its C interface alone: Debian's shared library brings
# along 30 others for files in the network, which take a fifth of the start of a program, and the parallel one MPI.
# Else, and for Python's module, since Debian's archives are for programs alone, dda_hdf5 is the shared library.
set(DDA_IS_PROGRAM $<NOT:$<STREQUAL:$<TARGET_PROPERTY:TYPE>,MODULE_LIBRARY>>)
find_library(HDF5_SERIAL_ARCHIVE libhdf5.a PATHS ${HDF5_LIBRARY_DIRS} NO_DEFAULT_PATH)
find_library(SZIP_LIBRARY sz)

add_library(dda_hdf5 INTERFACE)
if(HDF5_SERIAL_ARCHIVE AND SZIP_LIBRARY)
  target_include_directories(dda_hdf5 SYSTEM INTERFACE ${HDF5_INCLUDE_DIRS})
  list(REMOVE_ITEM HDF5_LIBRARIES hdf5)
  target_link_libraries(dda_hdf5 INTERFACE
    "$<${DDA_IS_PROGRAM}:${HDF5_SERIAL_ARCHIVE};${HDF5_LIBRARIES};${SZIP_LIBRARY};ZLIB::ZLIB;${CMAKE_DL_LIBS};m>"
    "$<$<NOT:${DDA_IS_PROGRAM}>:PkgConfig::HDF5>")
  # gmsh's libraries bring HDF5 as well, perhaps another one; neither may find the other's functions.
  target_link_options(dda_hdf5 INTERFACE LINKER:--exclude-libs,libhdf5.a)
else()
  target_link_libraries(dda_hdf5 INTERFACE PkgConfig::HDF5)
endif()
