#include "meshing/files/physical_groups.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <tuple>

namespace dda {
namespace {

const std::map<int, std::set<std::string>> roles{
    {0, {"point", "gauge"}}, {1, {"interface", "boundary", "slit"}}, {2, {"material"}}};

const char* noun(int dimension) { return dimension == 2 ? "surface" : dimension == 1 ? "curve" : "point"; }

std::string list(const std::set<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word + ":NAME";
  return text;
}

void check(const PhysicalGroup& group, const Position& where, Findings& findings) {
  if (group.dimension > 2) return findings.add(where, "the geometry has physical volumes; it must be plane");
  if (roles.at(group.dimension).contains(group.role) && !group.name.empty()) return;
  const std::string text = group.role + (group.name.empty() ? "" : ":" + group.name);
  findings.add(where, fmt::format("physical {} {} has the unknown name '{}'; expected {}",
                                  noun(group.dimension), group.tag, text, list(roles.at(group.dimension))));
}

}  // namespace

PhysicalGroup physical_group(int dimension, int tag, const std::string& text, std::vector<int> entities) {
  const std::size_t colon = text.find(':');
  const std::string name = colon == std::string::npos ? "" : text.substr(colon + 1);
  return {dimension, tag, text.substr(0, colon), name, std::move(entities)};
}

std::string entity_text(int dimension, int tag) { return fmt::format("{} {}", noun(dimension), tag); }

void require_sound(const std::vector<PhysicalGroup>& groups, const std::vector<int>& surfaces,
                   const std::function<std::string(int, int)>& describe, const Position& where) {
  Findings findings;
  std::map<std::tuple<int, int, std::string>, std::string> named;
  for (const PhysicalGroup& group : groups) {
    check(group, where, findings);
    for (const int entity : group.entities) {
      const auto [old, fresh] = named.try_emplace({group.dimension, entity, group.role}, group.name);
      if (!fresh)
        findings.add(where,
                     fmt::format("{} is in two groups: {}:{} and {}:{}", describe(group.dimension, entity),
                                 group.role, old->second, group.role, group.name));
    }
  }
  for (const int surface : surfaces)
    if (!named.contains({2, surface, "material"}))
      findings.add(where,
                   describe(2, surface) + " has no material: put it into a physical surface material:NAME");
  if (surfaces.empty()) findings.add(where, "the geometry has no surface");
  findings.throw_if_any();
}

Region region_of(const PhysicalGroup& group) {
  const std::size_t slash = group.name.find('/');
  if (slash == std::string::npos) return {group.name, group.name};
  return {group.name.substr(slash + 1), group.name.substr(0, slash)};
}

LineRole line_role(const PhysicalGroup& group) {
  return group.role == "interface"  ? LineRole::interface
         : group.role == "boundary" ? LineRole::boundary
                                    : LineRole::slit;
}

}  // namespace dda
