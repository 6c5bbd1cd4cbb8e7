# Makes deck_templates.hpp, the decks of `dda new` as string literals:
#   cmake -DOUTPUT=FILE "-DTEMPLATES=beam.yaml;..." -P deck_templates.cmake
set(content "#pragma once\n\n#include <array>\n#include <string_view>\n#include <utility>\n\nnamespace dda {\n\n")
list(LENGTH TEMPLATES count)
string(APPEND content "/// Name and text.\n"
  "inline constexpr std::array<std::pair<std::string_view, std::string_view>, ${count}> deck_templates = {{\n")
foreach(file IN LISTS TEMPLATES)
  get_filename_component(name "${file}" NAME_WE)
  file(READ "${file}" text)
  string(APPEND content "{\"${name}\", R\"deck(${text})deck\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "${content}}};\n\n}  // namespace dda\n")
