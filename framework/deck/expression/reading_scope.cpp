#include "framework/deck/expression/reading_scope.hpp"

#include <utility>

namespace dda {

namespace {
thread_local const ReadingScope* innermost = nullptr;
}  // namespace

ReadingScope::ReadingScope(Variables& variables, const std::set<std::string>& bases)
    : variables_(variables), bases_(bases), outer_(std::exchange(innermost, this)) {}

ReadingScope::~ReadingScope() { innermost = outer_; }

Variables& ReadingScope::variables() {
  static thread_local Variables none;
  return innermost ? innermost->variables_ : none;
}

std::filesystem::path ReadingScope::folder_of(const Node& node, const std::filesystem::path& folder) {
  const bool is_of_base = innermost && innermost->bases_.contains(node.where.file);
  return is_of_base ? std::filesystem::path(node.where.file).parent_path() : folder;
}

}  // namespace dda
