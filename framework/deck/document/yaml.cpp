#include <yaml.h>

#include <algorithm>
#include <fstream>
#include <new>
#include <optional>
#include <sstream>
#include <unordered_map>
#include <utility>

#include "framework/deck/document/node.hpp"

namespace dda {

namespace {

/// Aliases of aliases make a small file huge; no honest deck comes near these.
constexpr std::size_t max_depth = 100;
constexpr std::size_t max_nodes = 1'000'000;
constexpr std::size_t longest_document = 64 << 20;  // bytes

std::size_t count_nodes(const Node& node) {
  std::size_t count = 1;
  for (const Node& item : node.items) count += count_nodes(item);
  for (const NodeEntry& entry : node.entries) count += count_nodes(entry.value);
  return count;
}

/// What the parser of libyaml says next; knows nothing of nodes.
class Events {
 public:
  Events(const std::string& text, std::string file) : text_(text), file_(std::move(file)) {
    yaml_parser_initialize(&parser_);
    yaml_parser_set_input_string(&parser_, reinterpret_cast<const unsigned char*>(text.data()), text.size());
    yaml_parser_set_encoding(&parser_, YAML_UTF8_ENCODING);
  }
  ~Events() {
    yaml_event_delete(&event_);
    yaml_parser_delete(&parser_);
  }
  Events(const Events&) = delete;
  Events& operator=(const Events&) = delete;

  /// Stays valid until the next call.
  const yaml_event_t& next() {
    yaml_event_delete(&event_);
    if (!yaml_parser_parse(&parser_, &event_)) fail();
    return event_;
  }
  Position position(const yaml_mark_t& mark) const {
    return {file_, static_cast<int>(mark.line) + 1, static_cast<int>(mark.column) + 1};
  }

 private:
  [[noreturn]] void fail() const {
    if (parser_.error == YAML_MEMORY_ERROR) throw std::bad_alloc();
    Position where = position(parser_.problem_mark);
    if (parser_.error == YAML_READER_ERROR) {  // a character that is none; it is not yet in a line
      const auto end =
          text_.begin() + static_cast<std::ptrdiff_t>(std::min(parser_.problem_offset, text_.size()));
      where = {file_, static_cast<int>(1 + std::count(text_.begin(), end, '\n')), 1};
    }
    throw InputError(where, std::string("YAML syntax: ") + parser_.problem);
  }

  const std::string& text_;
  std::string file_;
  yaml_parser_t parser_{};
  yaml_event_t event_{};
};

std::string text_of(const yaml_char_t* text) { return text ? reinterpret_cast<const char*>(text) : ""; }

bool means_nothing(const std::string& plain) {
  return plain.empty() || plain == "~" || plain == "null" || plain == "Null" || plain == "NULL";
}

/// Builds our tree from the parser's events, rejecting what it lets pass (duplicate keys above all).
class Builder {
 public:
  Builder(const std::string& text, const std::string& file) : events_(text, file), file_(file) {}

  Node build() {
    events_.next();  // of the stream
    if (events_.next().type == YAML_STREAM_END_EVENT) return empty();
    read_document();
    if (const yaml_event_t& more = events_.next(); more.type != YAML_STREAM_END_EVENT)
      throw InputError(events_.position(more.start_mark), "only one document is read; remove the '---'");
    findings_.throw_if_any();
    return root_.is_null() ? empty() : std::move(root_);
  }

 private:
  /// A node that is being read; of a map also the key whose value comes next.
  struct Open {
    Node node;
    std::string anchor;
    std::optional<Node> key{};
    std::unordered_map<std::string, Position> seen{};
  };

  Node empty() const {
    Node out = Node::map();
    out.where = {file_, 0, 0};
    return out;
  }

  void read_document() {
    for (;;) {
      const yaml_event_t& event = events_.next();
      const Position where = events_.position(event.start_mark);
      switch (event.type) {
        case YAML_DOCUMENT_END_EVENT:
          return;
        case YAML_SCALAR_EVENT:
          add_scalar(event, where);
          break;
        case YAML_ALIAS_EVENT:
          add_alias(text_of(event.data.alias.anchor), where);
          break;
        case YAML_SEQUENCE_START_EVENT:
          begin(Node::Kind::sequence, where, text_of(event.data.sequence_start.anchor));
          break;
        case YAML_MAPPING_START_EVENT:
          begin(Node::Kind::map, where, text_of(event.data.mapping_start.anchor));
          break;
        default:  // the end of a sequence or map
          end();
      }
    }
  }

  void add_scalar(const yaml_event_t& event, const Position& where) {
    const auto& scalar = event.data.scalar;
    const std::string tag = text_of(scalar.tag);
    std::string text(reinterpret_cast<const char*>(scalar.value), scalar.length);
    const bool quoted = scalar.style != YAML_PLAIN_SCALAR_STYLE || tag == "!" || tag.ends_with(":str");
    const bool is_null = !quoted && tag.empty() && means_nothing(text);
    Node node = make(is_null ? Node::Kind::null : Node::Kind::scalar, where);
    if (!is_null) node.text = std::move(text);
    node.quoted = quoted;
    finish(std::move(node), text_of(scalar.anchor));
  }

  void add_alias(const std::string& anchor, const Position& where) {
    for (const Open& open : open_)
      if (open.anchor == anchor) throw InputError(where, "an alias stands inside what it names");
    const auto known = anchors_.find(anchor);
    if (known == anchors_.end()) throw InputError(where, "nothing is named '&" + anchor + "' before this");
    count(count_nodes(known->second), where);
    place(Node(known->second));
  }

  Node make(Node::Kind kind, const Position& where) {
    if (open_.size() > max_depth) throw InputError(where, "nested too deeply");
    count(1, where);
    Node node;
    node.kind = kind;
    node.where = where;
    return node;
  }

  void begin(Node::Kind kind, const Position& where, std::string anchor) {
    open_.push_back({make(kind, where), std::move(anchor)});
  }

  void end() {
    Open done = std::move(open_.back());
    open_.pop_back();
    finish(std::move(done.node), done.anchor);
  }

  void finish(Node node, const std::string& anchor) {
    if (!anchor.empty()) anchors_[anchor] = node;
    place(std::move(node));
  }

  void place(Node&& node) {
    if (open_.empty())
      root_ = std::move(node);
    else if (open_.back().node.is_sequence())
      open_.back().node.items.push_back(std::move(node));
    else if (!open_.back().key)
      open_.back().key = std::move(node);
    else
      add_entry(open_.back(), std::move(node));
  }

  void add_entry(Open& map, Node&& value) {
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

  Events events_;
  std::string file_;
  Node root_;
  std::vector<Open> open_;
  std::unordered_map<std::string, Node> anchors_;
  std::size_t count_ = 0;
  Findings findings_;
};

std::string read_text(const std::filesystem::path& path) {
  const Position where{path.string(), 0, 0};
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InputError(where, "no such file");
  if (std::filesystem::is_directory(status)) throw InputError(where, "is a folder, expected a file");
  if (!std::filesystem::is_regular_file(status))
    throw InputError(where, "is a device or a pipe, expected a file");
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
  if (!file.is_open() || file.bad() || text.bad()) throw InputError(where, "cannot be read");
  return text.str();
}

}  // namespace

Node parse_yaml(const std::string& text, const std::string& file_name) {
  if (text.size() > longest_document) throw InputError({file_name, 0, 0}, "is larger than any deck (64 MiB)");
  // Some editors begin a file with a byte order mark.
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (!text.starts_with(mark)) return Builder(text, file_name).build();
  const std::string rest = text.substr(mark.size());
  return Builder(rest, file_name).build();
}

Node read_yaml(const std::filesystem::path& path) { return parse_yaml(read_text(path), path.string()); }

}  // namespace dda
