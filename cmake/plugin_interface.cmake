# The headers that a plugin may include: all but those of the modules, which see Trilinos.
file(GLOB_RECURSE DDA_HEADERS CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}
  ${PROJECT_SOURCE_DIR}/framework/*.hpp ${PROJECT_SOURCE_DIR}/meshing/*.hpp
  ${PROJECT_SOURCE_DIR}/models/*.hpp ${PROJECT_SOURCE_DIR}/continuation/*.hpp)
list(FILTER DDA_HEADERS EXCLUDE REGEX "^continuation/modules/|^meshing/(gmsh|geos)/")

# framework/plugin/interface.hpp is made anew when one of them has changed.
set(DDA_INTERFACE_FOLDER ${CMAKE_BINARY_DIR}/generated)
set(interface_header ${DDA_INTERFACE_FOLDER}/framework/plugin/interface.hpp)
set(interface_stamp ${CMAKE_BINARY_DIR}/generated/interface.stamp)
list(TRANSFORM DDA_HEADERS PREPEND ${PROJECT_SOURCE_DIR}/ OUTPUT_VARIABLE header_files)
add_custom_command(OUTPUT ${interface_stamp} BYPRODUCTS ${interface_header}
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${interface_header} -DVERSION=${PROJECT_VERSION} -DROOT=${PROJECT_SOURCE_DIR}
          "-DHEADERS=${DDA_HEADERS}" -P ${PROJECT_SOURCE_DIR}/cmake/interface_hash.cmake
  COMMAND ${CMAKE_COMMAND} -E touch ${interface_stamp}
  DEPENDS ${header_files} ${PROJECT_SOURCE_DIR}/cmake/interface_hash.cmake
  COMMENT "Hashing the headers for plugins" VERBATIM)
add_custom_target(dda_interface DEPENDS ${interface_stamp})
