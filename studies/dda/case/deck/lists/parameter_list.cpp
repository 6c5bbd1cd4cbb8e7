#include "studies/dda/case/deck/lists/parameter_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "continuation/solve/loca.hpp"
#include "framework/base/suggestion.hpp"
#include "framework/deck/changes/settings.hpp"
#include "framework/files/whole_file.hpp"

namespace dda {
namespace {

using Type = ListEntry::Type;

/// A parameter of Trilinos: its lists and name, the deck's key that it stands for, and for words what they are
/// in the deck. Without a key only the words are taken, which say what is always so.
struct Row {
  std::string lists, name, key;
  Type type = Type::number;
  std::vector<std::pair<std::string, std::string>> words = {};
};

const std::vector<Row>& rows_of_nox() {
  static const std::vector<Row> rows{
      {"NOX", "Nonlinear Solver", "", Type::text, {{"Line Search Based", ""}}},
      {"NOX/Direction", "Method", "", Type::text, {{"Newton", ""}}},
      {"NOX/Line Search",
       "Method",
       "path.newton.line_search",
       Type::text,
       {{"Full Step", "full_step"}, {"Backtrack", "backtrack"}, {"Polynomial", "polynomial"}}},
      {"NOX/Line Search/Backtrack", "Reduction Factor", "path.newton.reduction"},
      {"NOX/Printing", "Output Information", "path.newton.output", Type::integer},
      {"NOX/Status Tests/NormF", "Tolerance", "path.newton.tolerance"},
      {"NOX/Status Tests/MaxIters", "Maximum Iterations", "path.newton.max_iterations", Type::integer}};
  return rows;
}

const std::vector<Row>& rows_of_loca() {
  static const std::vector<Row> rows{
      {"LOCA/Stepper",
       "Continuation Method",
       "path.control",
       Type::text,
       {{"Natural", "load"}, {"Arc Length", "arc_length"}}},
      {"LOCA/Stepper", "Continuation Parameter", "", Type::text, {{"lambda", ""}}},
      {"LOCA/Stepper", "Bordered Solver Method", "", Type::text, {{"Bordering", ""}}},
      {"LOCA/Stepper", "Max Value", "path.stop.load_factor_above"},
      {"LOCA/Stepper", "Min Value", "path.stop.load_factor_below"},
      {"LOCA/Stepper", "Max Steps", "path.stop.steps", Type::integer},
      {"LOCA/Stepper", "Max Nonlinear Iterations", "path.newton.max_iterations", Type::integer},
      {"LOCA/Step Size",
       "Method",
       "path.step.sizing",
       Type::text,
       {{"Adaptive", "iterations"}, {"Constant", "constant"}}},
      {"LOCA/Step Size", "Initial Step Size", "path.step.first"},
      {"LOCA/Step Size", "Min Step Size", "path.step.shortest"},
      {"LOCA/Step Size", "Max Step Size", "path.step.longest"},
      {"LOCA/Step Size", "Aggressiveness", "path.step.aggressiveness"},
      {"LOCA/Step Size", "Failed Step Reduction Factor", "path.step.cut"},
      {"LOCA/Predictor",
       "Method",
       "path.step.predictor",
       Type::text,
       {{"Tangent", "tangent"}, {"Secant", "secant"}, {"Constant", "constant"}}}};
  return rows;
}

const std::vector<Row>& table() {
  static const std::vector<Row> rows = [] {
    std::vector<Row> all = rows_of_nox();
    all.insert(all.end(), rows_of_loca().begin(), rows_of_loca().end());
    return all;
  }();
  return rows;
}

std::string joined(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, "/")); }

/// A parameter and where it stands.
struct Placed {
  std::vector<std::string> lists;
  std::string name;
  Node value;
};

std::string full_name(const Placed& parameter) {
  return parameter.lists.empty() ? parameter.name : joined(parameter.lists) + "/" + parameter.name;
}

void collect(const Node& node, const std::vector<std::string>& lists, std::vector<Placed>& out) {
  for (const NodeEntry& entry : node.entries) {
    if (!entry.value.is_map()) {
      out.push_back({lists, entry.key, entry.value});
      out.back().value.where = entry.where;
      continue;
    }
    std::vector<std::string> deeper = lists;
    deeper.push_back(entry.key);
    collect(entry.value, deeper, out);
  }
}

Position position_in(const std::string& text, std::size_t at) {
  const auto before = text.begin() + static_cast<std::ptrdiff_t>(at);
  const std::size_t line_break = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  const std::size_t line = line_break == std::string::npos ? 0 : line_break + 1;
  return {{}, static_cast<int>(std::count(text.begin(), before, '\n')) + 1, static_cast<int>(at - line) + 1};
}

/// Lines of an XML file in which the parameters stand, in their order.
std::vector<Placed> placed(const std::vector<ListEntry>& entries, const std::filesystem::path& file) {
  const std::string text = read_whole(file);
  std::vector<Placed> out;
  std::size_t at = 0, next = 0;
  for (const ListEntry& entry : entries) {
    const std::size_t found = text.find("\"" + entry.name + "\"", next);
    if (found != std::string::npos) {
      at = found;
      next = found + 1;
    }
    Node value = Node::scalar(entry.value);
    value.quoted = entry.type == Type::text;
    value.where = position_in(text, at);
    value.where.file = file.string();
    out.push_back({entry.lists, entry.name, std::move(value)});
  }
  return out;
}

bool has_lists(const Node& node) { return node.find("NOX") || node.find("LOCA"); }

/// What a file says: XML by Teuchos; YAML with or without the name of the whole list.
std::vector<Placed> read_file(const std::filesystem::path& file, const Position& where) {
  if (file.extension() != ".xml") {
    Node root = read_yaml(file);
    if (!has_lists(root) && root.entries.size() == 1) root = Node(root.entries.front().value);
    std::vector<Placed> out;
    collect(root, {}, out);
    return out;
  }
  read_whole(file);  // says what is wrong with the file itself
  try {
    return placed(read_parameter_list(file), file);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(Position{file.string()}, fmt::format("is no parameter list in XML: {}", error.what()));
  } catch (...) {
    throw InputError(where, "'" + file.string() + "' is no parameter list in XML");
  }
}

/// Status tests stand in numbered sublists, each with its type: "Combo" of others, "NormF", "MaxIters".
class StatusTests {
 public:
  explicit StatusTests(std::vector<Placed>& parameters) : parameters_(parameters) {}

  /// Moves the parameters of each test into a list that is named like its type; takes combinations away.
  void flatten(Findings& findings) {
    std::vector<Placed> out;
    for (Placed& parameter : parameters_) {
      if (!is_test(parameter)) {
        out.push_back(std::move(parameter));
        continue;
      }
      const std::string type = type_of(parameter.lists);
      if (type == "Combo")
        check_combination(parameter, findings);
      else if (type != "NormF" && type != "MaxIters")
        findings.add(
            parameter.value.where,
            fmt::format("{}: a status test is a Combo, NormF or MaxIters; its `Test Type` or the name "
                        "of its list says which",
                        full_name(parameter)));
      else if (parameter.name != "Test Type")
        out.push_back({{"NOX", "Status Tests", type}, parameter.name, parameter.value});
    }
    parameters_ = std::move(out);
  }

 private:
  static bool is_test(const Placed& parameter) {
    return parameter.lists.size() >= 2 && parameter.lists[0] == "NOX" && parameter.lists[1] == "Status Tests";
  }
  /// What `Test Type` says; of one that is called like its type, as in the table, nothing needs to.
  std::string type_of(const std::vector<std::string>& lists) const {
    for (const Placed& other : parameters_)
      if (other.lists == lists && other.name == "Test Type") return other.value.text;
    return lists.back();
  }
  int num_tests(const std::vector<std::string>& lists) const {
    int out = 0;
    for (const Placed& other : parameters_)
      out += other.name == "Test Type" && other.lists.size() == lists.size() + 1 &&
             std::equal(lists.begin(), lists.end(), other.lists.begin());
    return out;
  }
  void check_combination(const Placed& parameter, Findings& findings) const {
    const std::string& value = parameter.value.text;
    if (parameter.name == "Test Type") return;
    if (parameter.name == "Combo Type" && value == "OR") return;
    if (parameter.name == "Number of Tests" && value == std::to_string(num_tests(parameter.lists))) return;
    findings.add(parameter.value.where,
                 fmt::format("{}: tests are combined by `Combo Type: OR`, `Number of Tests` being {}",
                             full_name(parameter), num_tests(parameter.lists)));
  }

  std::vector<Placed>& parameters_;
};

const Row* find_row(const Placed& parameter) {
  const std::string lists = joined(parameter.lists);
  const auto found = std::ranges::find_if(
      table(), [&](const Row& row) { return row.lists == lists && row.name == parameter.name; });
  return found == table().end() ? nullptr : &*found;
}

std::string unknown(const Placed& parameter) {
  std::vector<std::string> names;
  for (const Row& row : table()) names.push_back(row.lists + "/" + row.name);
  return fmt::format("unknown parameter '{}'{}; `dda explain parameters` has them all", full_name(parameter),
                     suggest(full_name(parameter), names));
}

/// The deck's value of a parameter; a finding when it is none of its words.
Node translated(const Row& row, const Placed& parameter, Findings& findings) {
  if (row.words.empty()) return parameter.value;
  std::vector<std::string> known;
  for (const auto& [word, value] : row.words) {
    if (word != parameter.value.text) {
      known.push_back(word);
      continue;
    }
    Node out = Node::scalar(value);
    out.where = parameter.value.where;
    return out;
  }
  findings.add(parameter.value.where,
               fmt::format("{}: '{}' cannot take effect here{}", full_name(parameter), parameter.value.text,
                           suggest(parameter.value.text, known)));
  return {};
}

/// Whether a key has that value already, such as a control that is described further.
bool says_the_same(const Node* given, const Node& value) {
  if (!given || given->is_null()) return false;
  const Node* type = given->is_map() ? given->find("type") : given;
  return type && type->is_scalar() && type->text == value.text;
}

/// Lists of a deck: the parameters, and whether they count before what the deck says.
struct Lists {
  std::vector<Placed> parameters;
  bool is_file = false;
};

class Resolution {
 public:
  explicit Resolution(Node& root) : root_(root) {}

  void take(Lists lists) {
    StatusTests(lists.parameters).flatten(findings_);
    for (const Placed& parameter : lists.parameters) take(parameter, lists.is_file);
  }
  ResolvedLists finish() {
    findings_.throw_if_any();
    return std::move(out_);
  }

 private:
  void take(const Placed& parameter, bool is_file) {
    const Row* row = find_row(parameter);
    if (!row) return findings_.add(parameter.value.where, unknown(parameter));
    const Node value = translated(*row, parameter, findings_);
    if (row->key.empty() || value.is_null()) return;
    const Node* given = find_value(root_, row->key);
    if (says_the_same(given, value)) return;
    const bool is_given = given && !given->is_null();
    const bool is_set = is_given && is_of_setting(given->where);
    const bool is_listed = out_.keys.contains(row->key);
    if (is_set && is_file && !is_listed) return;
    const bool counts = (is_file || is_of_setting(parameter.value.where)) && !is_listed;
    if (is_given && (!counts || is_set || given->where.file == parameter.value.where.file))
      return findings_.add(parameter.value.where,
                           fmt::format("{} stands for {}, which {} says too", full_name(parameter), row->key,
                                       to_string(given->where)));
    set_value(root_, row->key, value, value.where);
    out_.keys[row->key] = {value.where, full_name(parameter)};
    out_.assignments.push_back(assignment(row->key, value));
  }
  static bool is_of_setting(const Position& where) { return where.file.starts_with("--set"); }

  Node& root_;
  Findings findings_;
  ResolvedLists out_;
};

/// Takes an entry off `path`; null when there is none.
Node taken_from_path(Node& root, const std::string& name) {
  Node* path = root.find("path");
  if (!path) return {};
  const auto found = std::ranges::find(path->entries, name, &NodeEntry::key);
  if (found == path->entries.end()) return {};
  Node out = std::move(found->value);
  path->entries.erase(found);
  return out;
}

Lists lists_in_deck(Node& root) {
  Lists out;
  for (const auto& [key, list] : {std::pair("nox", "NOX"), std::pair("loca", "LOCA")}) {
    const Node found = taken_from_path(root, key);
    if (!found.is_null() && !found.is_map())
      throw InputError(found.where, fmt::format("path.{}: expected a map of parameters", key));
    collect(found, {list}, out.parameters);
  }
  return out;
}

}  // namespace

ResolvedLists resolve_parameter_lists(Node& root, const std::filesystem::path& base) {
  Resolution resolution(root);
  resolution.take(lists_in_deck(root));
  const Node file = taken_from_path(root, "parameters");
  if (file.is_scalar() && !file.text.empty())
    resolution.take({read_file(base / file.text, file.where), true});
  return resolution.finish();
}

namespace {

std::vector<std::string> split(const std::string& lists) {
  std::vector<std::string> out(1);
  for (const char c : lists)
    if (c == '/')
      out.emplace_back();
    else
      out.back() += c;
  return out;
}

/// A parameter as it is in a deck; nothing when it is not set, or by a word that lists do not know.
std::optional<std::string> value_in(const Node& deck, const Row& row) {
  if (row.key.empty()) return row.words.front().first;
  const Node* value = find_value(deck, row.key);
  if (value && value->is_map()) value = value->find("type");
  if (!value || !value->is_scalar()) return {};
  if (row.words.empty()) return value->text;
  for (const auto& [word, in_deck] : row.words)
    if (in_deck == value->text) return word;
  return {};
}

}  // namespace

std::string effective_parameter_list(const Node& deck) {
  std::vector<ListEntry> entries;
  for (const Row& row : table()) {
    const auto value = value_in(deck, row);
    if (!value || row.name == "Maximum Iterations") continue;  // LOCA's "Max Nonlinear Iterations"
    std::vector<std::string> lists = split(row.lists);
    if (row.name == "Tolerance") {  // the type of a status test is a parameter of it
      lists.pop_back();
      entries.push_back({lists, "Test Type", Type::text, "NormF"});
    }
    entries.push_back({std::move(lists), row.name, row.type, *value});
  }
  return parameter_list_text(entries);
}

std::string explain_parameter_lists() {
  std::string out =
      "Parameter lists of NOX and LOCA (`--parameters FILE`, `path.parameters`, `path.nox`, `path.loca`).\n"
      "What they set stands for keys of the deck; what is not here is refused. A status test may stand in "
      "any sublist\n"
      "of NOX/Status Tests, or of a Combo, whose `Test Type` is NormF or MaxIters.\n\n";
  for (const Row& row : table()) {
    std::vector<std::string> words;
    for (const auto& [word, value] : row.words) words.push_back(word);
    out += fmt::format("  {:<46} {}{}\n", row.lists + "/" + row.name, row.key.empty() ? "only" : row.key,
                       words.empty() ? "" : fmt::format(" ({})", fmt::join(words, ", ")));
  }
  return out;
}

}  // namespace dda
