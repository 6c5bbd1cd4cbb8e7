# Writes dda_version.hpp for the target: the project's version and, inside a repository, git's description of it.
function(dda_version_header target)
  set(DDA_GIT_DESCRIPTION "")
  find_package(Git QUIET)
  if(GIT_FOUND)
    execute_process(COMMAND ${GIT_EXECUTABLE} describe --always --dirty --tags
      WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
      OUTPUT_VARIABLE DDA_GIT_DESCRIPTION OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  endif()
  # A new commit configures again, so that the header is not stale.
  if(EXISTS ${PROJECT_SOURCE_DIR}/.git/logs/HEAD)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/.git/logs/HEAD)
  endif()
  configure_file(${CMAKE_CURRENT_SOURCE_DIR}/messages/version.hpp.in ${CMAKE_CURRENT_BINARY_DIR}/generated/dda_version.hpp @ONLY)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/generated)
endfunction()
