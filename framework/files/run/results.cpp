#include "framework/files/run/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

namespace dda {
namespace fs = std::filesystem;

std::string step_file(int step) { return fmt::format("{}/{:06}.h5", fields_folder, step); }

std::optional<int> step_of(const fs::path& file) {
  const std::string name = file.filename().string();
  int step = -1;
  std::from_chars(name.data(), name.data() + name.size(), step);
  const bool is_step = step >= 0 && file.parent_path().filename() / name == step_file(step);
  return is_step ? std::optional(step) : std::nullopt;
}

std::vector<int> stored_steps(const fs::path& run_folder) {
  std::vector<int> steps;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(run_folder / fields_folder, none))
    if (const auto step = step_of(entry.path())) steps.push_back(*step);
  std::ranges::sort(steps);
  return steps;
}

std::string dataset_of(const std::string& field, FieldPlace place) {
  switch (place) {
    case FieldPlace::block:
    case FieldPlace::block_vertex:
      break;
    case FieldPlace::segment:
    case FieldPlace::segment_end:
      return "/segments/" + field;
    case FieldPlace::part:
    case FieldPlace::part_vertex:
      return "/parts/" + field;
    case FieldPlace::crack:
    case FieldPlace::crack_end:
      return "/cracks/" + field;
  }
  return "/" + field;
}

}  // namespace dda
