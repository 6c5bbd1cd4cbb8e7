#include "studies/dda/shell/completion.hpp"

#include <algorithm>
#include <optional>
#include <sstream>

#include "continuation/control/control.hpp"
#include "framework/deck/writing/keys.hpp"

namespace dda {
namespace {

using Words = std::vector<std::string>;

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Where the word to be completed stands: the command, if there is one yet, the option whose value it is, the option whose
/// value is glued to it by '=', and how many words of no option stand before it.
struct Cursor {
  const CLI::App* command = nullptr;
  const CLI::Option* option = nullptr;
  std::size_t positionals = 0;
  std::string deck;  ///< the file, as far as one is given
};

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

const CLI::Option* option_named(const CLI::App& app, const std::string& word) {
  if (!word.starts_with("-")) return nullptr;
  for (const CLI::Option* option : app.get_options())
    if (option->check_name(word)) return option;
  return nullptr;
}

const CLI::App* command_named(const CLI::App& program, const std::string& word) {
  for (const CLI::App* sub : program.get_subcommands([](const CLI::App*) { return true; }))
    if (sub->get_name() == word) return sub;
  return nullptr;
}

std::vector<const CLI::Option*> positionals_of(const CLI::App& app) {
  std::vector<const CLI::Option*> list;
  for (const CLI::Option* option : app.get_options())
    if (option->get_positional()) list.push_back(option);
  return list;
}

/// The one that the word number `index` is a value of; the last one may take more than one.
const CLI::Option* positional_at(const CLI::App& app, std::size_t index) {
  const auto list = positionals_of(app);
  if (list.empty()) return nullptr;
  if (index < list.size()) return list[index];
  return list.back()->get_items_expected_max() > 1 ? list.back() : nullptr;
}

Cursor cursor_behind(const CLI::App& program, const Words& words) {
  Cursor out;
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    const CLI::App& app = out.command ? *out.command : program;
    if (out.option) {
      out.option = nullptr;
    } else if (words[i].starts_with("-")) {
      const CLI::Option* option = option_named(app, words[i]);
      if (option && takes_value(*option)) out.option = option;
    } else if (!out.command) {
      out.command = command_named(program, words[i]);
    } else {
      const CLI::Option* place = positional_at(app, out.positionals++);
      if (place && place->get_type_name() == "DECK") out.deck = words[i];
    }
  }
  return out;
}

class Lines {
 public:
  void add(const std::string& word, const std::string& meaning = "") {
    text_ << word << '\t' << first_line(meaning) << '\n';
  }
  void add(const std::vector<Proposal>& list, const std::string& before = "") {
    for (const Proposal& one : list) add(before + one.text, one.meaning);
  }
  void ask_for(const char* kind) { text_ << ':' << kind << '\n'; }
  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
};

/// The deck on the line, for the names in it; nothing of one that cannot be read.
Node deck_of(const std::string& file) {
  try {
    return file.empty() ? Node::map() : read_yaml(file);
  } catch (const InputError&) {
    return Node::map();
  }
}

void add_controls(const std::string& before, const std::string& begun, Lines& out) {
  const std::size_t comma = begun.rfind(',');
  const std::string kept = comma == std::string::npos ? "" : begun.substr(0, comma + 1);
  for (const FamilyMember* member : controls().entries())
    if (member->name.starts_with(begun.substr(kept.size())))
      out.add(before + kept + member->name, member->schema->text());
}

struct Value {
  const CLI::Option& option;
  std::string before;  ///< of the word, "--set=" or nothing
  std::string begun;
};

void add_values(const Value& value, const SchemaBase& deck, const Cursor& at, Lines& out) {
  const std::string type = value.option.get_type_name();
  const auto is_one_of = [&](std::initializer_list<const char*> types) {
    return std::ranges::find(types, type) != types.end();
  };
  if (type == "KEY=VALUE")
    return out.add(proposed_settings(deck, deck_of(at.deck), value.begun), value.before);
  if (type == "TOPIC") return out.add(proposed_topics(deck, value.begun), value.before);
  if (type == "CONTROLS") return add_controls(value.before, value.begun, out);
  if (type == "DECK") return out.ask_for("deck");
  if (type == "FILE") return out.ask_for("file");
  if (is_one_of({"RUN", "FOLDER"})) return out.ask_for("folder");
  std::istringstream names(type);
  for (std::string name; type.find('|') != std::string::npos && std::getline(names, name, '|');)
    if (name.starts_with(value.begun)) out.add(value.before + name);
}

void add_options(const CLI::App& app, const std::string& begun, Lines& out) {
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames())
      if (("--" + name).starts_with(begun))
        out.add("--" + name + (takes_value(*option) ? "=" : ""), option->get_description());
}

void add_commands(const CLI::App& program, const std::string& begun, Lines& out) {
  for (const CLI::App* sub : program.get_subcommands([](const CLI::App*) { return true; }))
    if (!sub->get_group().empty() && sub->get_name().starts_with(begun))
      out.add(sub->get_name(), sub->get_description());
}

}  // namespace

std::string completions(const CLI::App& program, const SchemaBase& deck, const Words& words) {
  Lines out;
  const std::string begun = words.empty() ? "" : words.back();
  const Cursor at = cursor_behind(program, words);
  const CLI::App& app = at.command ? *at.command : program;
  const std::size_t equals = begun.find('=');
  const CLI::Option* glued =
      equals == std::string::npos ? nullptr : option_named(app, begun.substr(0, equals));
  if (at.option)
    add_values({*at.option, "", begun}, deck, at, out);
  else if (glued)
    add_values({*glued, begun.substr(0, equals + 1), begun.substr(equals + 1)}, deck, at, out);
  else if (begun.starts_with("-"))
    add_options(app, begun, out);
  else if (!at.command)
    add_commands(program, begun, out);
  else if (const CLI::Option* place = positional_at(app, at.positionals))
    add_values({*place, "", begun}, deck, at, out);
  return out.text();
}

}  // namespace dda
