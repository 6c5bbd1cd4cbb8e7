#include "framework/deck/dimension_of.hpp"

#include <algorithm>
#include <optional>
#include <sstream>

#include "framework/deck/changes/settings.hpp"
#include "framework/deck/family.hpp"

namespace dda {
namespace {

std::optional<KindInfo> kind_in(const SchemaBase& schema, const std::string& name) {
  for (const Parameter& parameter : schema.parameters())
    if (parameter.name == name) return parameter.kind;
  return {};
}

/// The parameters of what stands at `node`: of a section, or of the member that a choice names.
const SchemaBase* schema_of(const KindInfo& kind, const Node* node) {
  if (kind.section) return kind.section.get();
  if (!kind.family || !node) return nullptr;
  const Node* type = node->is_map() ? node->find("type") : node;
  const FamilyMember* member = type ? kind.family->find(type->text) : nullptr;
  return member ? member->schema.get() : nullptr;
}

std::optional<KindInfo> step(const KindInfo& kind, const Node* node, const std::string& name) {
  if (kind.item) return *kind.item;
  if (kind.form == KindInfo::Form::point || kind.form == KindInfo::Form::spot)
    return KindInfo{.form = KindInfo::Form::number, .dimension = kind.dimension};
  const SchemaBase* schema = schema_of(kind, node);
  return schema ? kind_in(*schema, name) : std::nullopt;
}

}  // namespace

Dimension dimension_of(const SchemaBase& deck, const Node& root, const std::string& path) {
  std::istringstream names(path);
  std::string name, walked;
  std::optional<KindInfo> kind;
  while (std::getline(names, name, '.')) {
    kind = walked.empty() ? kind_in(deck, name) : step(*kind, find_value(root, walked), name);
    if (!kind) return dimension::none;
    walked += (walked.empty() ? "" : ".") + name;
  }
  return kind && kind->form == KindInfo::Form::number ? kind->dimension : dimension::none;
}

}  // namespace dda
