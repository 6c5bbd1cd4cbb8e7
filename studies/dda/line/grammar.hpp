#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "studies/dda/commands/commands.hpp"

namespace dda {

/// What the program takes from the command line: commands, options and their texts, declared once. Reading, `--help`,
/// completion and the manual page come from it; the values land in a CommandLine.
///
/// The type name of an option says what may stand there, for whoever completes it: DECK, RUN, FOLDER, FILE, KEY=VALUE (a
/// key of decks), TOPIC (of `dda explain`), CONTROLS, or names separated by |.
class Grammar {
 public:
  Grammar();
  Grammar(const Grammar&) = delete;
  Grammar& operator=(const Grammar&) = delete;

  /// What is wrong with names of commands and options, with a suggestion; "" when nothing is.
  std::string unknown_name(const std::vector<std::string>& words) const;

  CLI::App& app() { return app_; }
  const CLI::App& app() const { return app_; }
  const CommandLine& line() const { return line_; }
  /// The command that was read, done; its exit code.
  int execute() const;

 private:
  using Command = std::function<int(const CommandLine&)>;

  CLI::App* add(const std::string& name, const std::string& text, Command command);
  void add_plugins(CLI::App* app);
  void add_deck(CLI::App* sub);
  void add_run(CLI::App* sub);
  void add_runs(CLI::App* sub);
  void add_set(CLI::App* sub);
  void add_output(CLI::App* sub, const char* folder);
  void add_profile(CLI::App* sub);
  void add_threads(CLI::App* sub);
  void add_permissions(CLI::App* sub);
  void add_jobs(CLI::App* sub);
  void add_ranks(CLI::App* sub);
  void add_solving();
  void add_sweep();
  void add_shared(CLI::App* sweep);
  void add_compare();
  void add_new();
  void add_explain();
  void add_looking();
  void add_plot();
  void add_animate();
  void add_shell();

  CLI::App app_;
  CommandLine line_;
  std::vector<std::pair<CLI::App*, Command>> commands_;
};

/// Makes an option take one of some names, with a suggestion for one that is none of them.
void take_one_of(CLI::Option* option, const std::vector<std::string>& names);

/// The first word that is no option of the program itself: the command. The number of words when there is none.
std::size_t command_position(const std::vector<std::string>& words);

}  // namespace dda
