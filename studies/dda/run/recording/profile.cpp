#include "studies/dda/run/recording/profile.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace dda {
namespace {

using Json = nlohmann::ordered_json;

struct Skipped {
  std::int64_t count;
  const char* of;  ///< what they are
};

/// What a program that does everything anew would have done in a phase, and this run did not.
std::map<std::string, Skipped> skipped_work(const Simulation& simulation) {
  const Equilibrium& equilibrium = simulation.equilibrium();
  const LinearSystem& linear = simulation.system().linear();
  const Effort& effort = simulation.walker().effort();
  const auto count = [](auto n) { return static_cast<std::int64_t>(n); };
  const std::int64_t iterations = effort.newton_iterations + effort.reduced_iterations;
  return {
      {"factorisation",
       {iterations - count(linear.num_factorisations()) + 1, "iterations without a new one"}},
      {"columns",
       {count(equilibrium.num_active() - linear.updated_points().size()), "points that never needed theirs"}},
      {"reduced iterations", {iterations - effort.reduced_iterations, "iterations that took all unknowns"}},
      {"laws", {simulation.system().num_screened(), "answers of intact points by one test"}},
  };
}

}  // namespace

Json profile_of(const Timings& timings, const Simulation& simulation) {
  const auto skipped = skipped_work(simulation);
  Json out = Json::array();
  for (const Timings::Phase& phase : timings.phases()) {
    Json row{{"phase", phase.name}, {"seconds", phase.seconds}, {"calls", phase.calls}};
    if (const auto found = skipped.find(phase.name); found != skipped.end()) {
      row["skipped"] = found->second.count;
      row["skipped_what"] = found->second.of;
    }
    out.push_back(std::move(row));
  }
  return out;
}

std::string profile_table(const Json& summary) {
  const double total = summary["timings"]["total"];
  std::string out = fmt::format("{:<20}{:>10}{:>8}{:>9}   skipped\n", "phase", "seconds", "share", "calls");
  double rest = total;
  const auto line = [&](const std::string& name, double seconds, const std::string& calls,
                        const std::string& skipped) {
    rest -= seconds;
    out += fmt::format("{:<20}{:>10.4f}{:>7.1f}%{:>9}   {}", name, seconds, 100 * seconds / total, calls,
                       skipped);
    out.erase(out.find_last_not_of(' ') + 1);
    out += '\n';
  };
  line("start-up", summary["timings"]["start_up"], "1", "");
  for (const Json& row : summary["profile"])
    line(row["phase"], row["seconds"], std::to_string(row["calls"].get<std::int64_t>()),
         row.contains("skipped") ? fmt::format("{} {}", row["skipped"].get<std::int64_t>(),
                                               row["skipped_what"].get<std::string>())
                                 : "");
  line("everything else", rest, "", "");
  out += fmt::format("{:<20}{:>10.4f}\n", "total", total);
  return out;
}

}  // namespace dda
