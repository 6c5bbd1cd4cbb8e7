#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <fstream>
#include <optional>
#include <sstream>
#include <unordered_map>
#include <utility>

#include "framework/node.hpp"

namespace dda {

namespace {

/// Aliases of aliases make a small file huge; no honest deck comes near these.
constexpr std::size_t max_depth = 100;
constexpr std::size_t max_nodes = 1'000'000;

std::size_t count_nodes(const Node& node) {
  std::size_t count = 1;
  for (const Node& item : node.items) count += count_nodes(item);
  for (const NodeEntry& entry : node.entries) count += count_nodes(entry.value);
  return count;
}

/// Builds our tree from the parser's events, rejecting what yaml-cpp lets pass (duplicate keys above all).
class Builder : public YAML::EventHandler {
 public:
  explicit Builder(std::string file) : file_(std::move(file)) {}

  Position position(const YAML::Mark& mark) const {
    return mark.is_null() ? Position{file_, 0, 0} : Position{file_, mark.line + 1, mark.column + 1};
  }
  const YAML::Mark& start() const { return start_; }
  const Findings& findings() const { return findings_; }
  Node take_root() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark& mark) override { start_ = mark; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    begin(mark, Node::Kind::null, anchor);
    end();
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    Node& node = begin(mark, Node::Kind::scalar, anchor);
    node.text = value;
    node.quoted = tag == "!" || tag.ends_with(":str");
    end();
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto known = anchors_.find(anchor);
    if (known == anchors_.end()) throw InputError(position(mark), "an alias stands inside what it names");
    count(count_nodes(known->second), position(mark));
    place(known->second);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    begin(mark, Node::Kind::sequence, anchor);
  }
  void OnSequenceEnd() override { end(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    begin(mark, Node::Kind::map, anchor);
  }
  void OnMapEnd() override { end(); }

 private:
  /// A node that is being read; of a map also the key whose value comes next.
  struct Open {
    Node node;
    YAML::anchor_t anchor;
    std::optional<Node> key{};
    std::unordered_map<std::string, Position> seen{};
  };

  Node& begin(const YAML::Mark& mark, Node::Kind kind, YAML::anchor_t anchor) {
    Node node;
    node.kind = kind;
    node.where = position(mark);
    if (open_.size() > max_depth) throw InputError(node.where, "nested too deeply");
    count(1, node.where);
    open_.push_back({std::move(node), anchor});
    return open_.back().node;
  }

  void end() {
    Node node = std::move(open_.back().node);
    if (open_.back().anchor != 0) anchors_[open_.back().anchor] = node;
    open_.pop_back();
    place(std::move(node));
  }

  void place(Node node) {
    if (open_.empty())
      root_ = std::move(node);
    else if (open_.back().node.is_sequence())
      open_.back().node.items.push_back(std::move(node));
    else if (!open_.back().key)
      open_.back().key = std::move(node);
    else
      add_entry(open_.back(), std::move(node));
  }

  void add_entry(Open& map, Node value) {
    const Node key = *std::exchange(map.key, std::nullopt);
    if (!key.is_scalar()) {
      findings_.add(key.where, "a key must be a plain name");
      return;
    }
    const auto [first, is_new] = map.seen.emplace(key.text, key.where);
    if (is_new)
      map.node.entries.push_back({key.text, key.where, std::move(value)});
    else
      findings_.add(key.where,
                    "duplicate key '" + key.text + "', first given at " + to_string(first->second));
  }

  void count(std::size_t more, const Position& where) {
    count_ += more;
    if (count_ > max_nodes) throw InputError(where, "the document is too large (aliases of aliases?)");
  }

  std::string file_;
  YAML::Mark start_;
  Node root_;
  std::vector<Open> open_;
  std::unordered_map<YAML::anchor_t, Node> anchors_;
  std::size_t count_ = 0;
  Findings findings_;
};

/// A text that starts with a comma gives yaml-cpp endless empty documents at the same place.
void reject_second_document(YAML::Parser& parser, const Builder& first, Builder second) {
  if (!parser.HandleNextDocument(second)) return;
  const bool is_stuck = second.start().pos == first.start().pos;
  throw InputError(first.position(second.start()), is_stuck ? "YAML syntax: this cannot start a document"
                                                            : "only one document is read; remove the '---'");
}

Node build(const std::string& text, const std::string& file) {
  Builder builder(file);
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  if (parser.HandleNextDocument(builder)) reject_second_document(parser, builder, Builder(file));
  builder.findings().throw_if_any();
  Node root = builder.take_root();
  if (!root.is_null()) return root;
  root = Node::map();
  root.where = builder.position(YAML::Mark{});
  return root;
}

std::string read_text(const std::filesystem::path& path) {
  const Position where{path.string(), 0, 0};
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InputError(where, "no such file");
  if (std::filesystem::is_directory(status)) throw InputError(where, "is a folder, expected a file");
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
  if (!file.is_open() || file.bad() || text.bad()) throw InputError(where, "cannot be read");
  return text.str();
}

}  // namespace

Node parse_yaml(const std::string& text, const std::string& file_name) {
  try {
    return build(text, file_name);
  } catch (const YAML::Exception& error) {
    throw InputError(Builder(file_name).position(error.mark), "YAML syntax: " + error.msg);
  }
}

Node read_yaml(const std::filesystem::path& path) { return parse_yaml(read_text(path), path.string()); }

}  // namespace dda
