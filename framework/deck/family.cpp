#include "framework/deck/family.hpp"

#include <algorithm>

#include "framework/base/suggestion.hpp"

namespace dda {

namespace {

std::vector<const FamilyBase*>& registry() {
  static std::vector<const FamilyBase*> families;
  return families;
}

Node without_type(const Node& node) {
  Node parameters = node;
  std::erase_if(parameters.entries, [](const NodeEntry& entry) { return entry.key == "type"; });
  return parameters;
}

Node no_parameters(const Node& name) {
  Node parameters = Node::map();
  parameters.where = name.where;
  return parameters;
}

}  // namespace

std::vector<const FamilyBase*> all_families() {
  auto families = registry();
  std::sort(families.begin(), families.end(), [](auto* a, auto* b) { return a->name() < b->name(); });
  return families;
}

FamilyBase::FamilyBase(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {
  registry().push_back(this);
}

FamilyBase::~FamilyBase() { std::erase(registry(), this); }

std::vector<const FamilyMember*> FamilyBase::entries() const {
  std::vector<const FamilyMember*> list;
  for (const auto& [name, member] : members_) list.push_back(member.get());
  return list;
}

const FamilyMember* FamilyBase::find(const std::string& name) const {
  const auto found = members_.find(name);
  return found == members_.end() ? nullptr : found->second.get();
}

void FamilyBase::insert(std::unique_ptr<FamilyMember> member) {
  for (const Parameter& parameter : member->schema->parameters())
    if (parameter.name == "type")
      throw std::logic_error(member->name + ": 'type' is taken by the choice itself");
  const std::string name = member->name;
  if (!members_.emplace(name, std::move(member)).second)
    throw std::logic_error(name_ + " '" + name + "' is registered twice");
}

std::optional<FamilyBase::Selection> FamilyBase::select(const Node& node, const Reading& reading) const {
  const Node* type = node.is_map() ? node.find("type") : &node;
  if (!type) {
    reading.findings.add(node.where, "missing 'type' of the " + name_);
    return {};
  }
  if (!type->is_scalar()) {
    expected("the name of a " + name_ + " or {type: name, ...}", *type, reading);
    return {};
  }
  if (const FamilyMember* member = find(type->text))
    return Selection{member, node.is_map() ? without_type(node) : no_parameters(node)};
  std::vector<std::string> names;
  for (const FamilyMember* member : entries()) names.push_back(member->name);
  reading.findings.add(type->where,
                       "unknown " + name_ + " '" + type->text + "'" + suggest(type->text, names));
  return {};
}

}  // namespace dda
