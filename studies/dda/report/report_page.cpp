#include <string_view>

#include "report_files.hpp"
#include "studies/dda/figures/stability_lines.hpp"
#include "studies/dda/report/report.hpp"

namespace dda::report {

std::string embedded(const Json& data) {
  // Bytes that are no UTF-8 become replacement characters, instead of an exception.
  const std::string text = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    // In JSON these three stand in strings only, so an escape is always possible.
    if (c == '<')
      out += "\\u003c";
    else if (c == '>')
      out += "\\u003e";
    else if (c == '&')
      out += "\\u0026";
    else
      out += c;
  }
  return out;
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string filled(const std::string& page, const std::vector<std::pair<std::string, std::string>>& values) {
  std::string out;
  for (std::size_t i = 0; i < page.size();) {
    bool found = false;
    for (const auto& [name, value] : values) {
      const std::string mark = "@" + name + "@";
      if (page.compare(i, mark.size(), mark) != 0) continue;
      out += value;
      i += mark.size();
      found = true;
      break;
    }
    if (!found) out += page[i++];
  }
  return out;
}

/// What the page's figures share with those of files.
Json style_of_figures() {
  Json out = svg::page_style();
  for (const StabilityLine& line : stability_lines) {
    Json dash = Json::array();
    if (line.dashed || line.dotted) dash = line.dotted ? svg::dots : svg::dashes;
    out["stability"].push_back({{"colour", line.colour}, {"dash", dash}, {"note", line.explanation}});
  }
  return out;
}

std::string page_of(const Json& data) {
  std::string styles, scripts = "const STYLE = " + embedded(style_of_figures()) + ";\n";
  for (const std::string_view part : files::styles) styles += part;
  for (const std::string_view part : files::scripts) scripts += part;
  return filled(std::string(files::page), {{"title", escaped(data.value("title", ""))},
                                           {"styles", styles},
                                           {"scripts", scripts},
                                           {"data", embedded(data)}});
}

}  // namespace dda::report
