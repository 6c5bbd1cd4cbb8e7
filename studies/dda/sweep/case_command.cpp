#include "studies/dda/sweep/case_command.hpp"

#include <fmt/format.h>

#include "studies/dda/sweep/processes/processes.hpp"
#include "studies/dda/sweep/sweep_folder.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

void add_settings(const std::vector<std::string>& overrides, Words& out) {
  for (const std::string& text : overrides) out.insert(out.end(), {"--set", text});
}

/// The sweep's own words, those that begin with the program.
std::string line_of_sweep(const Sweep& sweep, const fs::path& folder) {
  Words words{program_file(), "sweep", sweep.file.string(), "--quiet", "--folder", folder.string()};
  if (ranks_of_processes() > 1) words.push_back(fmt::format("--ranks={}", ranks_of_processes()));
  for (const std::string& option : options_of_processes()) words.push_back(option);
  add_settings(sweep.overrides, words);
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : " ") + quoted(word);
  return out;
}

}  // namespace

std::string quoted(const std::string& word) {
  constexpr std::string_view harmless =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+./,:=@%";
  if (!word.empty() && word.find_first_not_of(harmless) == std::string::npos) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::vector<std::string> case_command(const Sweep& sweep, const fs::path& folder, std::size_t index,
                                      bool resumes) {
  const std::string where = (folder / case_folder(sweep, index)).string();
  const Words allowed = options_of_processes();
  Words out =
      resumes ? Words{"resume", where, "--quiet"}
              : Words{"run", sweep.cases[index].deck.string(), "--folder", where, "--quiet", "--overwrite"};
  out.insert(out.end(), allowed.begin(), allowed.end());
  if (!resumes) add_settings(sweep.cases[index].overrides, out);
  return out;
}

std::string line_of_cases(const Sweep& sweep, const fs::path& folder, int jobs) {
  return fmt::format("seq {} | OMP_NUM_THREADS={} xargs -P {} -n 1 {} --case", sweep.cases.size(),
                     quoted(threads_of_processes()), jobs, line_of_sweep(sweep, folder));
}

std::string line_of_process(const Sweep& sweep, const fs::path& folder) {
  return line_of_sweep(sweep, folder) + " --jobs 1";
}

}  // namespace dda
