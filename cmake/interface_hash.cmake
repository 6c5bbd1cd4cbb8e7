# Writes the header with what plugins and the program must have in common, the project's version and a hash of all headers
# that a plugin may include, when that has changed:
#   cmake -DOUTPUT=FILE -DVERSION=0.1.0 -DROOT=FOLDER "-DHEADERS=a.hpp;..." -P interface_hash.cmake
set(contents "")
foreach(header IN LISTS HEADERS)
  file(SHA256 "${ROOT}/${header}" hash)
  string(APPEND contents "${header} ${hash}\n")
endforeach()
string(SHA256 hash "${contents}")
string(SUBSTRING "${hash}" 0 12 hash)
set(text "#pragma once\n\n#define DDA_INTERFACE \"${VERSION}, headers ${hash}\"\n")
if(EXISTS "${OUTPUT}")
  file(READ "${OUTPUT}" before)
endif()
if(NOT "${before}" STREQUAL "${text}")
  file(WRITE "${OUTPUT}" "${text}")
endif()
