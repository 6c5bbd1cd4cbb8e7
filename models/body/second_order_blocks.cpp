#include "framework/base/errors.hpp"
#include "framework/base/suggestion.hpp"
#include "models/body/body.hpp"

namespace dda {

SecondOrderBlocks second_order_blocks(const Assembly& assembly, const KinematicsChoice& kinematics) {
  if (kinematics.is_empty()) return {};
  const auto made = kinematics.make();
  std::vector<std::string> known;
  for (const Region& region : assembly.regions) known.push_back(region.name);
  for (const std::string& name : made->regions())
    if (std::ranges::find(known, name) == known.end())
      throw InputError(kinematics.where(),
                       "kinematics: unknown region '" + name + "'" + suggest(name, known));
  SecondOrderBlocks out;
  std::vector<std::optional<std::size_t>> numbers(assembly.num_blocks());
  for (std::size_t b = 0; b < assembly.num_blocks(); ++b) {
    if (!made->is_second_order(known[static_cast<std::size_t>(assembly.blocks[b].region)])) continue;
    numbers[b] = out.blocks.size();
    out.blocks.emplace_back(b);
  }
  if (!out.blocks.empty()) out.numbers = std::move(numbers);
  return out;
}

}  // namespace dda
