#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "continuation/control/stop.hpp"
#include "framework/deck/expression/expression.hpp"
#include "framework/deck/writing/explain.hpp"
#include "framework/deck/writing/keys.hpp"
#include "pages_of_explain.hpp"
#include "studies/dda/case/deck/lists/parameter_list.hpp"
#include "studies/dda/case/deck/written_deck.hpp"
#include "studies/dda/commands/commands.hpp"
#include "studies/dda/run/recording/summary.hpp"
#include "studies/dda/shell/editor_schema.hpp"

namespace dda {
namespace {

constexpr const char* sweep_manual =
    R"(Every entry is a key of the deck, a dotted path as for --set, with the values it takes:

  scene.parameters.depth: [50, 100, 200]    a list of any values, maps too
  scene.subdivision.seed: 1..20             integers
  path.stop.load_below: 0.1..0.5 step 0.1   numbers up to the second
  materials.concrete.young_modulus: 1000..30000 log 8   8 numbers, each by the same factor above the last
  seed: 1..20                               every key called seed that the deck has
  deck: [a.yaml, ../b/deck.yaml]            whole decks, from the folder of this file
  zip: {a.key: [1, 2], another: [3, 4]}     keys that vary together; several zips as a list of maps
  columns: {strength: peak.load/(thickness*depth)}   further columns of sweep.csv, of varied keys (or their ends),
                                            numbers of the deck and of summary.json, by their dotted names

Entries form the product; the last one runs fastest. The section stands in the deck that it varies, or in a file of
its own with `deck: base.yaml` (or a list) and perhaps a `title`.

  dda sweep FILE             runs what is missing into runs/NAME/cases/001, 002, ...; --jobs N at a time
  dda sweep FILE --dry-run   prints the cases, and a line that does them one by one
  dda sweep FILE --case N    runs one of them alone, as in a batch queue
  dda run FILE --set sweep=  runs the deck alone; --set sweep.KEY=VALUES varies a key that the file does not

Any number of processes, on any machines that have the folder in common, may be given the same sweep: they share the
cases, and take over those of processes that died. `--lease S`: of another machine, after S seconds without a sign of life.

  dda sweep --status FOLDER         tells who runs what since when, what waits and what failed; or FILE
  dda sweep FILE --launcher slurm   prints a batch script, an array of processes; --submit hands it to sbatch
  dda sweep FILE --launcher parallel --hosts a,b   prints a line that starts them over ssh; mpirun: by mpirun
  --no-wait                         a process ends when others run what is left, and one of them waits for all
  --attempt NAME                    what fails under that name is not tried again under it

In runs/NAME: sweep.csv (a row per case: settings, status, exit code, every number of summary.json) with its units,
sweep.json, curves.svg, sweep.yaml, claims. Cases whose settings stay the same are kept when the file changes.
Exit codes: 0 all reached their goals, 3 some stopped early, 4 some failed, 2 some refused their deck, 130 interrupted.
)";

constexpr const char* variables_manual =
    R"manual(Wherever a deck has a number an expression may stand, also in lists and points, and in values of --set:

  variables: {D: 100, S: 4*D, t: "max(D/4, 10)"}      in quotes where YAML has a meaning for , : # { [ or a first * &
  scene: {regions: [{material: concrete, vertices: [[-S/2, 0], [S/2, 0], [S/2, D], [-S/2, D]]}]}
  thickness: t

Names of materials, points and files are texts, in which nothing is computed. Variables may stand in any order; one that
is used nowhere is refused. `--set variables.D=200` sets one, `sweep: {variables.D: [50, 100]}` varies it. A .geo file
whose DefineConstant[...] has a constant of that name gets the value, unless `scene.parameters` has another. Tractions,
pressures, body forces and initial stress may be expressions of the place (x, y), too. effective_deck.yaml has the
numbers that came out.

  + - * / ^ ( )   < <= > >= == != && ||   a > b ? c : d
)manual";

std::string manual_of(const std::string& topic) {
  if (topic == "sweep")
    return fmt::format("{}Numbers of summary.json for `columns`: {}, peak.gauges.NAME.\n", sweep_manual,
                       fmt::join(numbers_of_summaries, ", "));
  if (topic != "variables") return "";
  return fmt::format(
      "{}  constants       {}\n  functions       {}\n"
      "Angles are in radians, log and ln are natural logarithms, rint is the nearest integer.\n",
      variables_manual, fmt::join(constants_of_expressions(), ", "),
      fmt::join(functions_of_expressions(), ", "));
}

/// What docs/stopped.md says of a way to stop; "" where the topic is none.
std::string entry_of_stop(const std::string& topic) {
  const std::string_view page = pages_of_explain[0].second;
  const auto is_it = [&](const auto& stop) { return topic == stop.second; };
  if (std::ranges::none_of(names_of_stops, is_it)) return "";
  const std::size_t heading = page.find("\n### " + topic + "\n");
  if (heading == std::string_view::npos) return "";
  const std::size_t begin = heading + 1, end = page.find("\n##", begin);
  return std::string(page.substr(begin, end - begin)) + '\n';
}

/// What else is explained.
std::vector<std::string> topics_beside() {
  std::vector<std::string> out{"parameters"};
  for (const auto& stop : names_of_stops) out.emplace_back(stop.second);
  return out;
}

}  // namespace

int command_explain(const CommandLine& line) {
  if (line.json)
    fmt::print("{}\n", schema_for_editors().dump(2));
  else if (!line.find.empty())
    fmt::print("{}", find_in_manual(written_deck_schema(), line.find));
  else if (const std::string entry = entry_of_stop(line.topic); !entry.empty())
    fmt::print("{}", entry);
  else if (line.topic == "parameters")
    fmt::print("{}", explain_parameter_lists());
  else
    fmt::print("{}{}", explain(written_deck_schema(), line.topic, {"L", "F"}, topics_beside()),
               manual_of(line.topic));
  return 0;
}

}  // namespace dda
