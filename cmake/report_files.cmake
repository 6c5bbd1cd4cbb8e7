# Makes report_files.hpp, the files of the report's page as string literals, so that the program needs no files:
#   cmake -DOUTPUT=FILE -DPAGE=FILE "-DSTYLES=FILE;..." "-DSCRIPTS=FILE;..." -P report_files.cmake

# Compilers need not accept literals of more than 65536 characters (C++20, Annex B).
set(longest 65000)

# The text of a file as a raw string literal.
function(literal_of file result)
  file(SIZE "${file}" size)
  if(size GREATER longest)
    message(FATAL_ERROR "${file}: ${size} bytes; a file of the report's page has at most ${longest}")
  endif()
  file(READ "${file}" text)
  if(text MATCHES "\\)page_file\"" OR (text MATCHES "</script" AND NOT file STREQUAL PAGE))
    message(FATAL_ERROR "${file}: holds a text that would end its literal or its element")
  endif()
  set(${result} "R\"page_file(${text})page_file\"" PARENT_SCOPE)
endfunction()

literal_of("${PAGE}" page)
set(content "#pragma once\n\n#include <array>\n#include <string_view>\n\nnamespace dda::report::files {\n\n")
string(APPEND content "inline constexpr std::string_view page = ${page};\n")
foreach(kind styles scripts)
  string(TOUPPER ${kind} list)
  list(LENGTH ${list} count)
  string(APPEND content "\ninline constexpr std::array<std::string_view, ${count}> ${kind} = {\n")
  foreach(file IN LISTS ${list})
    literal_of("${file}" literal)
    string(APPEND content "${literal},\n")
  endforeach()
  string(APPEND content "};\n")
endforeach()
string(APPEND content "\n}  // namespace dda::report::files\n")
file(WRITE "${OUTPUT}" "${content}")
