#include <fmt/format.h>

#include "framework/base/errors.hpp"
#include "framework/files/run/run_folder.hpp"
#include "framework/files/whole_file.hpp"
#include "studies/dda/commands/commands.hpp"
#include "studies/dda/report/report.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

/// A folder below this one that has a report to give, "" when there is none.
std::string run_below(const fs::path& folder) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.is_directory(error) && (report::is_run(entry.path()) || report::is_sweep(entry.path())))
      return entry.path().string();
  return {};
}

[[noreturn]] void refuse(const fs::path& folder) {
  const std::string below = run_below(folder);
  throw InputError(Position{folder.string()},
                   "is no run folder and no sweep: it has neither curve.csv nor sweep.csv; " +
                       (below.empty() ? "give the folder that `dda run` or `dda sweep` wrote"
                                      : fmt::format("did you mean '{}'?", below)));
}

void write(const fs::path& page, const report::Json& data) {
  const std::string text = report::page_of(data);
  write_whole(page, text, Flush::to_system);
  fmt::print("{} ({:.1f} MB)\n", page.string(), static_cast<double>(text.size()) / 1e6);
}

fs::path page_in(const fs::path& run) { return run / "report.html"; }

/// Those of the cases first, so that the sweep's rows lead to them.
void write_of_sweep(const CommandLine& line, const fs::path& folder, const fs::path& page) {
  const report::Limits limits;
  std::size_t left = 0;
  for (const fs::path& run : report::runs_of_sweep(folder))
    if (line.with_cases)
      write(page_in(run), report::data_of_run(run, limits));
    else if (!fs::exists(page_in(run)))
      ++left;
  write(page, report::data_of_sweep(folder, page, limits));
  if (left > 0)
    fmt::print("{} of its cases {} no report: rows lead to the folder; --cases writes them\n", left,
               left == 1 ? "has" : "have");
}

}  // namespace

int command_report(const CommandLine& line) {
  const fs::path folder = line.runs.front();
  require_run_folder(folder);
  const fs::path page = line.page.empty() ? page_in(folder) : line.page;
  const bool is_sweep = report::is_sweep(folder);
  if (!is_sweep && !report::is_run(folder)) refuse(folder);
  if (!is_sweep && line.with_cases)
    throw InputError(Position{folder.string()}, "is a run, which has no cases: leave --cases out");
  if (is_sweep)
    write_of_sweep(line, folder, page);
  else
    write(page, report::data_of_run(folder, report::Limits{}));
  return 0;
}

}  // namespace dda
