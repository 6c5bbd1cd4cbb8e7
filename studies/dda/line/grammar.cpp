#include "studies/dda/line/grammar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "framework/base/memory.hpp"
#include "framework/base/suggestion.hpp"
#include "framework/base/threads.hpp"
#include "framework/messages/provenance.hpp"
#include "meshing/files/gmsh_model.hpp"
#include "studies/dda/case/deck/written_deck.hpp"
#include "studies/dda/shell/completion.hpp"
#include "studies/dda/shell/manual.hpp"
#include "studies/dda/sweep/processes/processes.hpp"

namespace dda {
namespace {

constexpr const char* footer =
    "Exit codes: 0 goal reached, 2 wrong input, 3 stopped early (results valid), 4 output or internal "
    "error,\n"
    "130 interrupted (continue with `dda resume`).";

constexpr const char* plugin_option = "--plugin";

/// Here, and in the processes that are started from here.
void use_threads(int count) {
  set_num_threads(count);
  setenv("OMP_NUM_THREADS", std::to_string(count).c_str(), 1);
}

/// CLI11's own check names the largest number that there is.
CLI::Validator above_zero() {
  const auto check = [](const std::string& given) {
    double value = 0;
    const bool is_number = CLI::detail::lexical_cast(given, value) && std::isfinite(value);
    return is_number && value > 0 ? std::string() : fmt::format("'{}' is not a number above 0", given);
  };
  return CLI::Validator(check, "POSITIVE");
}

/// A text as YAML takes it whatever it holds.
std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

}  // namespace

void take_one_of(CLI::Option* option, const std::vector<std::string>& names) {
  const auto check = [names](const std::string& given) {
    if (std::ranges::find(names, given) != names.end()) return std::string();
    return fmt::format("'{}' is none of {}{}", given, fmt::join(names, ", "), suggest(given, names));
  };
  option->type_name(fmt::format("{}", fmt::join(names, "|")))->check(CLI::Validator(check, ""));
}

Grammar::Grammar()
    : app_("Discontinuous deformation analysis of concrete fracture along the whole equilibrium path.",
           "dda") {
  app_.footer(footer);
  app_.set_version_flag("--version", version_text());
  app_.require_subcommand(1);
  add_plugins(&app_);
  add_solving();
  add_sweep();
  add_compare();
  add_new();
  add_explain();
  add_looking();
  add_shell();
}

int Grammar::execute() const {
  for (const auto& [sub, command] : commands_)
    if (sub->parsed()) return command(line_);
  return 2;
}

CLI::App* Grammar::add(const std::string& name, const std::string& text, Command command) {
  CLI::App* sub = app_.add_subcommand(name, text);
  commands_.emplace_back(sub, std::move(command));
  return sub;
}

void Grammar::add_plugins(CLI::App* app) {
  app->add_option_function<std::vector<std::string>>(
         plugin_option,
         [this](const std::vector<std::string>& files) {
           line_.plugins.insert(line_.plugins.end(), files.begin(), files.end());
         },
         "A library with laws, loads, controls ... of your own, loaded before decks are read; may be "
         "repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
}

void Grammar::add_deck(CLI::App* sub) {
  sub->add_option("deck", line_.deck, "The deck, a YAML file")->required()->type_name("DECK");
  add_set(sub);
  sub->add_option_function<std::string>(
         "--parameters",
         [this](const std::string& file) {
           line_.overrides.insert(line_.overrides.begin(),
                                  "path.parameters=" + quoted(std::filesystem::absolute(file).string()));
         },
         "A Teuchos::ParameterList, XML or YAML, for NOX and LOCA; `dda explain parameters` has what it may "
         "set")
      ->type_name("FILE");
}

void Grammar::add_run(CLI::App* sub) {
  sub->add_option("run", line_.runs, "The run folder")->required()->expected(1)->type_name("RUN");
}

void Grammar::add_runs(CLI::App* sub) {
  sub->add_option("runs", line_.runs, "Run folders")->required()->type_name("RUN");
}

void Grammar::add_set(CLI::App* sub) {
  sub->add_option("--set", line_.overrides,
                  "Overrides a parameter of the deck: path.to.key=value; may be repeated")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  add_plugins(sub);
}

void Grammar::add_output(CLI::App* sub, const char* folder) {
  sub->add_option(folder, line_.run.folder, "Where results go; runs/<name of the deck> if not given")
      ->type_name("FOLDER");
  sub->add_flag("--overwrite", line_.run.overwrite, "Replace the results of an earlier run in that folder");
  sub->add_flag("--quiet", line_.run.quiet, "No progress lines");
}

void Grammar::add_profile(CLI::App* sub) {
  sub->add_flag("--profile", line_.run.profile, "Print time, calls and work that was skipped, by phase");
}

void Grammar::add_threads(CLI::App* sub) {
  sub->add_option_function<int>("--threads", use_threads,
                                "Threads of a run; OMP_NUM_THREADS if not given, else one per processor; 1 "
                                "for the runs of a sweep")
      ->check(CLI::Range(1, 1024));
}

void Grammar::add_permissions(CLI::App* sub) {
  sub->add_flag_function(
      "--trust-geo", [](std::int64_t) { set_geo_trust(true); },
      "Let the scene's .geo file run programs and write files, as gmsh would");
  sub->add_option_function<double>(
         "--memory-limit", [](double gib) { set_memory_limit(gib * bytes_per_gib); },
         "Memory that a run may need at the least [GiB]; what the machine has to spare if not given")
      ->check(above_zero());
}

/// Of the runs of a sweep.
void Grammar::add_ranks(CLI::App* sub) {
  sub->add_option_function<int>("--ranks", set_ranks_of_processes,
                                "Ranks that share each run of the sweep, started by mpirun; 1 if not given")
      ->check(CLI::Range(1, 4096));
}

void Grammar::add_jobs(CLI::App* sub) {
  sub->add_option("--jobs", line_.jobs, "Runs of a sweep at a time; one per processor if not given")
      ->check(CLI::Range(1, 1024));
}

void Grammar::add_solving() {
  CLI::App* run = add(
      "run", "Follow the equilibrium path of a deck into a run folder; a sweep as `sweep` does", command_run);
  add_deck(run);
  add_output(run, "--out,--folder");
  add_permissions(run);
  add_jobs(run);
  add_threads(run);
  add_profile(run);
  CLI::App* resume =
      add("resume",
          "Continue an interrupted run or sweep, or a finished run under another control or stopping rule",
          command_resume);
  add_run(resume);
  add_set(resume);
  add_output(resume, "--out,--folder");
  add_permissions(resume);
  add_jobs(resume);
  add_threads(resume);
  add_profile(resume);
}

void Grammar::add_sweep() {
  CLI::App* sweep = add(
      "sweep", "Run a deck for every combination of what its section `sweep` varies; again: what is missing",
      command_sweep);
  add_deck(sweep);
  add_output(sweep, "--out,--folder");
  add_permissions(sweep);
  add_jobs(sweep);
  add_ranks(sweep);
  add_threads(sweep);
  sweep->add_flag("--dry-run", line_.dry_run,
                  "Print the cases and a line that does them one by one, and run nothing");
  sweep
      ->add_option("--case", line_.only_case,
                   "Run this case alone, from 1, unless it has a result; many at a time, as in a batch queue")
      ->check(above_zero());
  add_shared(sweep);
}

void Grammar::add_shared(CLI::App* sweep) {
  SharedSweep& shared = line_.shared;
  sweep->add_flag("--status", shared.status,
                  "Tell how far the sweep of this file or folder is, and who runs what; run nothing");
  take_one_of(sweep->add_option("--launcher", shared.launcher,
                                "Print what starts the sweep by many processes, at most --jobs: a batch "
                                "script for slurm, or a line with parallel or mpirun"),
              {"slurm", "parallel", "mpirun"});
  sweep->add_flag("--submit", shared.submit, "Hand the script of --launcher slurm to sbatch");
  sweep
      ->add_option("--hosts", shared.hosts,
                   "Hosts of --launcher parallel, separated by commas; --jobs for all")
      ->delimiter(',')
      ->allow_extra_args(false);
  sweep->add_flag("--no-wait", shared.may_leave,
                  "End when other processes run what is left, and one of them waits for all");
  sweep->add_option(
      "--attempt", shared.attempt,
      "A name of what several processes do together; a case that failed under it is not tried again");
  sweep
      ->add_option(
          "--lease", shared.lease,
          "Seconds without a sign of life after which a process of another machine is dead; 60 if not given")
      ->check(CLI::Range(1.0, 86400.0));
}

void Grammar::add_compare() {
  CLI::App* compare =
      add("compare", "Run a deck under several controls and compare the paths", command_compare);
  add_deck(compare);
  compare->add_option("--controls", line_.controls, "Names of controls, separated by commas")
      ->delimiter(',')
      ->required()
      ->type_name("CONTROLS");
  compare
      ->add_option("--out", line_.picture,
                   "The paths over one another (.svg, .png, .pdf), also as compare.svg in the folder")
      ->type_name("FILE");
  add_output(compare, "--folder");
  add_permissions(compare);
  add_threads(compare);
}

void Grammar::add_new() {
  CLI::App* fresh = add("new", "Write a commented deck to begin with, which runs as it is", command_new);
  take_one_of(fresh->add_option("kind", line_.topic, "What it describes")->required(), deck_template_names());
  fresh->add_option("--out", line_.page, "The file; KIND.yaml here if not given")->type_name("FILE");
}

void Grammar::add_explain() {
  CLI::App* explain =
      add("explain", "The manual of the deck: a section, a family, or family/name", command_explain);
  explain
      ->add_option("topic", line_.topic,
                   "Such as `path`, `law`, `law/linear_softening`, or why a run stopped, `standstill`")
      ->type_name("TOPIC");
  explain->add_option("--find", line_.find, "Every key whose name or text has this word")->type_name("WORD");
  explain->add_flag("--json", line_.json, "The JSON schema of decks, for editors");
  add_plugins(explain);
}

void Grammar::add_looking() {
  CLI::App* check =
      add("check", "Read, mesh and validate a deck; print counts, quality and predicted size without solving",
          command_check);
  add_deck(check);
  check
      ->add_option("--ranks", line_.ranks,
                   "Tell the memory that each of so many ranks takes, as `mpirun -n N dda run` starts them")
      ->check(CLI::Range(1, 4096));
  check
      ->add_option("--out,--draw,--svg", line_.picture,
                   "Draw the model (.svg, .png, .pdf): materials, interfaces, supports, loads, gauges")
      ->type_name("FILE");
  add_permissions(check);
  add_threads(check);
  add_plot();
  CLI::App* report =
      add("report", "Write one HTML page about a run or a sweep, to be read offline", command_report);
  report->add_option("folder", line_.runs, "The folder of the run or sweep")
      ->required()
      ->expected(1)
      ->type_name("RUN");
  report->add_option("--out", line_.page, "The page; report.html in that folder if not given")
      ->type_name("FILE");
  report->add_flag("--cases", line_.with_cases,
                   "Of a sweep: write the reports of its cases, too, to which its rows then lead");
  CLI::App* verify = add("verify",
                         "Check runs independently of what computed them: equilibrium, laws, energies, "
                         "reactions, the reason; 0 all hold, 3 some are refused",
                         command_verify);
  add_runs(verify);
  verify->add_option("--out", line_.page, "The tables as a file of text, instead of printing them")
      ->type_name("FILE");
  add_animate();
}

void Grammar::add_animate() {
  CLI::App* animate =
      add("animate", "Write the motion of a run as an animation, GIF or MP4", command_animate);
  add_run(animate);
  const auto option = [&](const std::string& names, const std::string& text) {
    const std::string word = names.substr(0, names.find(','));
    return animate->add_option_function<std::string>(
        names, [this, word](const std::string& value) { line_.animation.push_back(word + "=" + value); },
        text);
  };
  option("--out,--output",
         "The file, .gif or .mp4 (which needs ffmpeg); motion.gif in that folder if not given")
      ->type_name("FILE");
  option("--fps", "Pictures per second, from 1 to 50; 20 if not given");
  option(
      "--speed",
      "Seconds of motion per second of film, 1 is true; a round number for some eight seconds if not given");
  animate->add_flag_function(
      "--path", [this](std::int64_t) { line_.animation.emplace_back("--path"); },
      "Before it the path: load against deflection, and the blocks with displacements magnified");
  option("--magnify",
         "How many times displacements of the path are magnified, 1 is true; a round number if not given");
}

void Grammar::add_shell() {
  const auto print = [](const std::string& text) {
    fmt::print("{}", text);
    return 0;
  };
  CLI::App* completion =
      add("completion", "Print what makes a shell complete commands, options, files and keys of decks",
          [print](const CommandLine& line) { return print(completion_script(line.topic)); });
  take_one_of(completion->add_option("shell", line_.topic, "The shell")->required(), completion_shells());
  CLI::App* man = add("man", "Print the manual page of the program, or of decks: `dda man | man -l -`",
                      [this, print](const CommandLine& line) {
                        return print(line.topic == "deck" ? deck_page(written_deck_schema())
                                                          : program_page(app_, written_deck_schema()));
                      });
  take_one_of(man->add_option("page", line_.topic, "Which; dda if not given"), {"dda", "deck"});
  CLI::App* complete =
      add("complete", "What may come next, for completion", [this, print](const CommandLine& line) {
        return print(completions(app_, written_deck_schema(), line.words));
      });
  complete->group("");  // no word of it in the help
  complete->add_option("words", line_.words, "The words behind `dda`, the last one perhaps unfinished");
}

std::size_t command_position(const std::vector<std::string>& words) {
  std::size_t i = 0;
  while (i < words.size() && words[i].starts_with(plugin_option)) i += words[i] == plugin_option ? 2 : 1;
  return std::min(i, words.size());
}

std::string Grammar::unknown_name(const std::vector<std::string>& words) const {
  const std::size_t position = command_position(words);
  if (position == words.size()) return {};
  const std::string& first = words[position];
  std::vector<std::string> names;
  const CLI::App* chosen = &app_;
  for (const auto& [sub, command] : commands_) {
    if (!sub->get_group().empty()) names.push_back(sub->get_name());
    if (sub->get_name() == first) chosen = sub;
  }
  if (chosen == &app_ && !first.starts_with('-'))
    return fmt::format("unknown command '{}'{}", first, suggest(first, names));
  std::vector<std::string> options;
  for (const CLI::Option* option : chosen->get_options())
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  for (std::size_t i = position; i < words.size() && words[i] != "--"; ++i) {
    const std::string name = words[i].substr(0, words[i].find('='));
    if (!name.starts_with("--") || std::ranges::find(options, name) != options.end()) continue;
    return fmt::format("unknown option '{}'{}", name, suggest(name, options));
  }
  return {};
}

}  // namespace dda
