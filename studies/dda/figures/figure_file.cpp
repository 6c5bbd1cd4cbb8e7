#include "studies/dda/figures/figure_file.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

#include "framework/base/errors.hpp"
#include "framework/files/whole_file.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

/// What rsvg-convert is asked for, by the end of the file's name.
const std::map<std::string, std::array<const char*, 2>>& options() {
  static const std::map<std::string, std::array<const char*, 2>> all{{".png", {"--format=png", "--zoom=2"}},
                                                                     {".pdf", {"--format=pdf", "--zoom=1"}}};
  return all;
}

/// Exit code of a program that is looked for in PATH; 127 where there is none.
int run(std::array<const char*, 7> words) {
  pid_t process = 0;
  if (posix_spawnp(&process, words[0], nullptr, nullptr, const_cast<char**>(words.data()), environ) != 0)
    return 127;
  int status = 0;
  waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

fs::path file_of(const fs::path& run, const std::string& name) {
  const bool is_of_motion = name == "end" || name == "energies";
  return (is_of_motion ? run / "motion" : run) / (name + ".svg");
}

}  // namespace

void require_figure_name(const fs::path& file) {
  if (file.extension() != ".svg" && !options().contains(file.extension().string()))
    throw InputError(Position{file.string()}, "a figure is a file .svg, .png or .pdf");
}

void write_figure(const fs::path& file, const std::string& svg) {
  require_figure_name(file);
  if (file.extension() == ".svg") return write_whole(file, svg, Flush::to_system);
  const fs::path vectors = file.string() + ".svg";
  write_whole(vectors, svg, Flush::to_system);
  const auto& [format, zoom] = options().at(file.extension().string());
  const int code = run({"rsvg-convert", format, zoom, "--output", file.c_str(), vectors.c_str(), nullptr});
  std::error_code ignored;
  if (code == 0) {
    fs::remove(vectors, ignored);
    return;
  }
  throw OutputError(fmt::format("{}: {}; the figure is in {}", file.string(),
                                code == 127
                                    ? "is made by rsvg-convert, which is not installed (Debian: librsvg2-bin)"
                                    : "rsvg-convert could not make it",
                                vectors.string()));
}

const std::vector<std::string>& names_of_run_figures() {
  static const std::vector<std::string> all{
      "curve", "deformed", "deformed-sliding", "detail", "detail-sliding", "eigenvalues", "modes",
      "model", "end",      "energies"};
  return all;
}

std::string run_figure(const fs::path& run, const std::string& name) {
  if (const fs::path file = file_of(run, name); fs::exists(file)) return read_whole(file);
  std::vector<std::string> there;
  std::ranges::copy_if(names_of_run_figures(), std::back_inserter(there),
                       [&](const std::string& other) { return fs::exists(file_of(run, other)); });
  throw InputError(Position{run.string()}, there.empty() ? "has no figures (yet)"
                                                         : fmt::format("has no figure '{}'; there are {}",
                                                                       name, fmt::join(there, ", ")));
}

}  // namespace dda
