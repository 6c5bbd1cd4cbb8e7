#include "studies/dda/shell/manual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "framework/deck/family.hpp"
#include "framework/deck/writing/explain.hpp"
#include "framework/deck/writing/keys.hpp"
#include "framework/messages/provenance.hpp"

namespace dda {
namespace {

const Units symbols{"L", "F"};

/// A text as man(7) takes it.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool begins = out.empty() || out.back() == '\n';
    if (begins && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else if (c == '`')
      out += "\\(ga";
    else if (c == '~')
      out += "\\(ti";
    else if (c == '^')
      out += "\\(ha";
    else
      out += c;
  }
  return out;
}

std::string bold(const std::string& text) { return "\\fB" + plain(text) + "\\fR"; }

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string header(const std::string& name, int section) {
  return fmt::format(".\\\" Written by `dda man`.\n.TH {} {} \"\" \"ddapath {}\" \"ddapath\"\n",
                     plain(upper(name)), section, plain(provenance().version));
}

std::string heading(const std::string& kind, const std::string& text) {
  return fmt::format(".{} \"{}\"\n", kind, plain(kind == "SH" ? upper(text) : text));
}

std::string item(const std::string& tag, const std::string& text) {
  return ".TP\n" + tag + "\n" + plain(text) + "\n";
}

std::string paragraph(const std::string& text) { return ".PP\n" + plain(text) + "\n"; }

/// The type alone, of "INT:INT in [1 - 1024]".
std::string without_bounds(const std::string& type) { return type.substr(0, type.find(':')); }

/// "DECK", "--set KEY=VALUE", "--quiet".
std::string tag_of(const CLI::Option& option) {
  const bool takes_value = option.get_items_expected_max() > 0;
  const std::string type = takes_value ? without_bounds(option.get_type_name()) : "";
  if (option.get_positional()) return "\\fI" + plain(upper(option.get_name(true))) + "\\fR";
  std::string names;
  for (const std::string& name : option.get_snames()) names += (names.empty() ? "" : ", ") + bold("-" + name);
  for (const std::string& name : option.get_lnames())
    names += (names.empty() ? "" : ", ") + bold("--" + name);
  return type.empty() ? names : names + " \\fI" + plain(type) + "\\fR";
}

std::string options_of(const CLI::App& app) {
  std::string out;
  for (const CLI::Option* option : app.get_options()) out += item(tag_of(*option), option->get_description());
  return out;
}

std::string commands_of(const CLI::App& program) {
  std::string out;
  for (const CLI::App* sub : program.get_subcommands([](const CLI::App*) { return true; })) {
    if (sub->get_group().empty()) continue;
    std::string usage = "dda " + sub->get_name();
    for (const CLI::Option* option : sub->get_options())
      if (option->get_positional()) usage += " " + upper(option->get_name(true));
    out += heading("SS", usage) + plain(sub->get_description()) + ".\n" + options_of(*sub);
  }
  return out;
}

std::string environment() {
  return heading("SH", "environment") +
         item(bold("OMP_NUM_THREADS"), "Threads of a run where --threads is not given.") +
         item(bold("DDA"), "The program that the Python package ddapath starts.");
}

std::string places() {
  return heading("SH", "files") +
         item("\\fIPREFIX\\fR/share/ddapath/studies",
              "Decks to look at and to run; each folder has a README.") +
         item("\\fIPREFIX\\fR/share/ddapath/plugin", "A law of one's own, for --plugin.") +
         item("\\fIPREFIX\\fR/share/doc/ddapath", "The manual, README.md, and CHANGELOG.md.") +
         item("runs/\\fINAME\\fR", "Results: curve.csv, curve.svg, summary.json, fields, log.jsonl.");
}

std::string sections_of(const SchemaBase& deck) {
  std::string out =
      heading("SH", "decks") +
      paragraph("A deck is a YAML file; dda-deck(5) has all its keys, and so has dda explain. Its sections:");
  for (const Parameter& parameter : deck.parameters()) out += item(bold(parameter.name), parameter.text);
  return out;
}

std::string key_item(const DeckKey& key) {
  return ".TP\n" + bold(key.path) + "\n(" + plain(facts(key.parameter, symbols)) + ")\n.br\n" +
         plain(key.parameter.text) + "\n";
}

}  // namespace

std::string program_page(const CLI::App& program, const SchemaBase& deck) {
  std::string out = header("dda", 1);
  out += heading("SH", "name") + "dda \\- " + plain(program.get_description()) + "\n";
  out += heading("SH", "synopsis") + bold("dda") + " [\\fIoptions\\fR] \\fIcommand\\fR [\\fIarguments\\fR]\n";
  out += heading("SH", "options") + options_of(program);
  out += heading("SH", "commands") + commands_of(program);
  out += sections_of(deck);
  out += heading("SH", "exit status") + plain(program.get_footer()) + "\n";
  return out + environment() + places() + heading("SH", "see also") + "\\fBdda\\-deck\\fR(5)\n";
}

std::string deck_page(const SchemaBase& deck) {
  std::string out = header("dda-deck", 5);
  out += heading("SH", "name") + "dda\\-deck \\- the input of dda(1)\n";
  out += heading("SH", "description") + plain(deck.text()) + "\n" +
         paragraph(
             "A deck is a YAML file. L and F are its units of length and force. NAME stands for a name of "
             "your own, 0 for the "
             "number of an entry. Every key may be set on the command line as well: --set path.to.key=value. "
             "dda explain "
             "shows the same by section.");
  for (const Parameter& section : deck.parameters()) {
    out += heading("SH", section.name) + key_item({section.name, section});
    for (const DeckKey& key : keys_of(deck))
      if (key.path.starts_with(section.name + ".")) out += key_item(key);
  }
  for (const FamilyBase* family : all_families()) {
    out += heading("SH", "family " + family->name()) + plain(family->text()) + "\n";
    for (const FamilyMember* member : family->entries()) {
      out += heading("SS", family->name() + "/" + member->name) + plain(member->schema->text()) + "\n";
      for (const DeckKey& key : keys_of(*member->schema)) out += key_item(key);
    }
  }
  return out + heading("SH", "see also") + "\\fBdda\\fR(1)\n";
}

}  // namespace dda
