#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dda {

/// Throws InputError unless the name of a figure's file ends with .svg, .png or .pdf.
void require_figure_name(const std::filesystem::path& file);

/// Writes a figure, given as SVG, in the format that the name of its file asks for: .svg as it is, .pdf as vectors and .png
/// with twice as many pixels each way, by librsvg's rsvg-convert. Throws OutputError where that is not installed, or the
/// file cannot be written.
void write_figure(const std::filesystem::path& file, const std::string& svg);

/// Names of the figures that a run may leave as .svg in its folder, or in its `motion` there.
const std::vector<std::string>& names_of_run_figures();

/// One of these of a run, as SVG. Throws InputError where the run has none of the name, and says which it has.
std::string run_figure(const std::filesystem::path& run, const std::string& name);

}  // namespace dda
