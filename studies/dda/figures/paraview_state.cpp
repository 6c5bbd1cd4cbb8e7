#include "studies/dda/figures/paraview_state.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "framework/files/whole_file.hpp"
#include "paraview_scripts.hpp"

namespace dda {

void write_paraview_state(const RunFolder& folder, const Simulation& simulation, double scale) {
  nlohmann::json regions = nlohmann::json::array();
  for (const Region& region : simulation.assembly().regions) regions.push_back(region.name);
  const auto quoted = [](const std::string& text) { return nlohmann::json(text).dump(); };
  const Units& units = simulation.deck().units;
  const std::string where = std::filesystem::absolute(folder.path()).lexically_normal().string();
  const std::string head = fmt::format(
      "# Opens this run in ParaView: File > Load State, or paraview --state=paraview_state.py\n"
      "REGIONS = {}\nSCALE = {:g}\nSTRESS_UNIT, LENGTH_UNIT = {}, {}\nFOLDER = {}\n\n",
      regions.dump(), scale, quoted(label(dimension::stress, units)), quoted(units.length), quoted(where));
  write_whole(folder.file("paraview_state.py"), head + std::string(paraview_scripts.front().second),
              Flush::to_system);
}

}  // namespace dda
