# CHOLMOD and OpenBLAS as archives where there are: of the shared ones the dynamic loader looks up 13 000 entries, a third
# of the start of a program. Else, and for Python's module, dda_cholmod is the shared libraries.
find_library(OPENBLAS_LIBRARY openblas REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
find_library(OPENBLAS_ARCHIVE libopenblas.a)
find_library(METIS_LIBRARY NAMES metis libmetis.so.5)  # what CHOLMOD brings along, its -dev package or not
set(DDA_CHOLMOD_ARCHIVES "")
foreach(part cholmod amd colamd ccolamd camd suitesparseconfig)
  find_library(${part}_ARCHIVE lib${part}.a)
  list(APPEND DDA_CHOLMOD_ARCHIVES ${${part}_ARCHIVE})
endforeach()

add_library(dda_cholmod INTERFACE)
set(shared ${OPENBLAS_LIBRARY} ${CHOLMOD_LIBRARY})  # OpenBLAS first: its entries are looked up in the libraries' order
if(OPENBLAS_ARCHIVE AND METIS_LIBRARY AND NOT DDA_CHOLMOD_ARCHIVES MATCHES "NOTFOUND")
  target_link_libraries(dda_cholmod INTERFACE
    "$<${DDA_IS_PROGRAM}:${DDA_CHOLMOD_ARCHIVES};${METIS_LIBRARY};${OPENBLAS_ARCHIVE}>" "$<$<NOT:${DDA_IS_PROGRAM}>:${shared}>")
else()
  target_link_libraries(dda_cholmod INTERFACE ${shared})
endif()
target_link_libraries(dda_cholmod INTERFACE gomp)
