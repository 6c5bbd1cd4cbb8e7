# Makes a header of texts as string literals, so that the program needs no files:
#   cmake -DOUTPUT=FILE -DNAME=deck_templates "-DTEXTS=beam.yaml;..." -P text_literals.cmake
# gives an array of that name of pairs, the name of each file without its ending and its text.
set(content "#pragma once\n\n#include <array>\n#include <string_view>\n#include <utility>\n\nnamespace dda {\n\n")
list(LENGTH TEXTS count)
string(APPEND content "/// Name and text.\n"
  "inline constexpr std::array<std::pair<std::string_view, std::string_view>, ${count}> ${NAME} = {{\n")
foreach(file IN LISTS TEXTS)
  get_filename_component(name "${file}" NAME_WE)
  file(READ "${file}" text)
  string(APPEND content "{\"${name}\", R\"text(${text})text\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "${content}}};\n\n}  // namespace dda\n")
