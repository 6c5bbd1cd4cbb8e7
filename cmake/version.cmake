# Writes dda_version.hpp for the target: the project's version, inside a repository git's description of it, and the
# versions of the libraries (library_versions.cmake).
include(library_versions)
function(dda_version_header target)
  set(DDA_GIT_DESCRIPTION "")
  find_package(Git QUIET)
  if(GIT_FOUND)
    execute_process(COMMAND ${GIT_EXECUTABLE} describe --always --dirty --tags
      WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
      OUTPUT_VARIABLE DDA_GIT_DESCRIPTION OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    execute_process(COMMAND ${GIT_EXECUTABLE} rev-parse --path-format=absolute --git-path logs/HEAD
      WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
      OUTPUT_VARIABLE head OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  endif()
  # A new commit configures again, so that the header is not stale.
  if(head AND EXISTS ${head})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${head})
  endif()
  dda_library_versions(DDA_LIBRARIES)
  configure_file(${CMAKE_CURRENT_SOURCE_DIR}/messages/version.hpp.in ${CMAKE_CURRENT_BINARY_DIR}/generated/dda_version.hpp @ONLY)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/generated)
endfunction()
