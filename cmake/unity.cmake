# With CMAKE_UNITY_BUILD (the presets `release` and `asan`) the files of a folder are compiled together, a few at once: what
# they include is read once, and its templates are made once. So no two of them give one name to what each keeps to
# itself. Kinds of a family call their schemas alike: each of these is compiled alone, and so is everything with the preset
# `dev`.
function(dda_compile_folders_together target)
  set(most 8)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "[.]cpp$")
  foreach(source ${sources})
    get_filename_component(source ${source} ABSOLUTE)
    file(STRINGS ${source} schema REGEX "^Schema<.*> schema\\(\\)" LIMIT_COUNT 1)
    if(schema)
      continue()
    endif()
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${CMAKE_SOURCE_DIR})
    string(MAKE_C_IDENTIFIER ${folder} group)
    list(LENGTH files_of_${group} before)
    list(APPEND files_of_${group} ${source})
    math(EXPR part "${before} / ${most}")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group}_${part})
  endforeach()
endfunction()
