#pragma once

#include <filesystem>
#include <string>

namespace dda {

/// Throws InputError unless the name of a figure's file ends with .svg, .png or .pdf.
void require_figure_name(const std::filesystem::path& file);

/// Writes a figure, given as SVG, in the format that the name of its file asks for: .svg as it is, .pdf as vectors and .png
/// with twice as many pixels each way, by librsvg's rsvg-convert. Throws OutputError where that is not installed, or the
/// file cannot be written.
void write_figure(const std::filesystem::path& file, const std::string& svg);

}  // namespace dda
