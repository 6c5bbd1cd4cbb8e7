#include "studies/dda/commands/command_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iostream>
#include <new>
#include <nlohmann/json.hpp>

#include "framework/base/memory.hpp"
#include "framework/base/suggestion.hpp"
#include "framework/base/threads.hpp"
#include "framework/messages/provenance.hpp"
#include "meshing/files/gmsh_model.hpp"
#include "studies/dda/commands/commands.hpp"

namespace dda {
namespace {

using Command = int (*)(const CommandLine&);

constexpr const char* footer =
    "Exit codes: 0 goal reached, 2 wrong input, 3 stopped early (results valid), 4 output or internal "
    "error,\n"
    "130 interrupted (continue with `dda resume`).";

/// Here, and in the processes that are started from here.
void use_threads(int count) {
  set_num_threads(count);
  setenv("OMP_NUM_THREADS", std::to_string(count).c_str(), 1);
}

/// One of some names, with a suggestion for one that is none of them.
CLI::Validator known_name(const std::vector<std::string>& names) {
  const auto check = [names](const std::string& given) {
    if (std::ranges::find(names, given) != names.end()) return std::string();
    return fmt::format("'{}' is none of {}{}", given, fmt::join(names, ", "), suggest(given, names));
  };
  return {check, fmt::format("{}", fmt::join(names, "|"))};
}

/// A text as YAML takes it whatever it holds.
std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

/// The program's grammar; the values land in a CommandLine.
class Grammar {
 public:
  Grammar()
      : app_("Discontinuous deformation analysis of concrete fracture along the whole equilibrium path.",
             "dda") {
    app_.footer(footer);
    app_.set_version_flag("--version", "ddapath " + provenance().version);
    app_.require_subcommand(1);
    add_solving();
    add_many();
    add_looking();
  }

  /// What is wrong with names of commands and options, with a suggestion; "" when nothing is.
  std::string unknown_name(int argc, char** argv) const;

  CLI::App& app() { return app_; }
  int execute() const {
    for (const auto& [sub, command] : commands_)
      if (sub->parsed()) return command(line_);
    return 2;
  }

 private:
  CLI::App* add(const std::string& name, const std::string& text, Command command) {
    CLI::App* sub = app_.add_subcommand(name, text);
    commands_.emplace_back(sub, command);
    return sub;
  }
  void add_deck(CLI::App* sub) {
    sub->add_option("deck", line_.deck, "The deck, a YAML file")->required();
    add_set(sub);
    sub->add_option_function<std::string>(
        "--parameters",
        [this](const std::string& file) {
          line_.overrides.insert(line_.overrides.begin(),
                                 "path.parameters=" + quoted(std::filesystem::absolute(file).string()));
        },
        "A Teuchos::ParameterList, XML or YAML, for NOX and LOCA; `dda explain parameters` has what it may "
        "set");
  }
  void add_set(CLI::App* sub) {
    sub->add_option("--set", line_.overrides,
                    "Overrides a parameter of the deck: path.to.key=value; may be repeated")
        ->allow_extra_args(false);
  }
  void add_output(CLI::App* sub) {
    sub->add_option("--folder", line_.run.folder, "Where results go; runs/<name of the deck> if not given");
    sub->add_flag("--overwrite", line_.run.overwrite, "Replace the results of an earlier run in that folder");
    sub->add_flag("--quiet", line_.run.quiet, "No progress lines");
  }
  void add_profile(CLI::App* sub) {
    sub->add_flag("--profile", line_.run.profile, "Print time, calls and work that was skipped, by phase");
  }
  void add_threads(CLI::App* sub) {
    sub->add_option_function<int>("--threads", use_threads,
                                  "Threads of a run; OMP_NUM_THREADS if not given, else one per processor; 1 "
                                  "for the runs of a sweep")
        ->check(CLI::Range(1, 1024));
  }
  void add_permissions(CLI::App* sub) {
    sub->add_flag_function(
        "--trust-geo", [](std::int64_t) { set_geo_trust(true); },
        "Let the scene's .geo file run programs and write files, as gmsh would");
    sub->add_option_function<double>(
           "--memory-limit", [](double gib) { set_memory_limit(gib * bytes_per_gib); },
           "Memory that a run may need at the least [GiB]; what the machine has to spare if not given")
        ->check(CLI::PositiveNumber);
  }
  void add_jobs(CLI::App* sub) {
    sub->add_option("--jobs", line_.jobs, "Runs of a sweep at a time; one per processor if not given")
        ->check(CLI::Range(1, 1024));
  }
  void add_solving();
  void add_many();
  void add_shared(CLI::App* sweep);
  void add_looking();
  void add_animate();

  CLI::App app_;
  CommandLine line_;
  std::vector<std::pair<CLI::App*, Command>> commands_;
};

void Grammar::add_solving() {
  CLI::App* run = add(
      "run", "Follow the equilibrium path of a deck into a run folder; a sweep as `sweep` does", command_run);
  add_deck(run);
  add_output(run);
  add_permissions(run);
  add_jobs(run);
  add_threads(run);
  add_profile(run);
  CLI::App* resume =
      add("resume",
          "Continue an interrupted run or sweep, or a finished run under another control or stopping rule",
          command_resume);
  resume->add_option("run", line_.runs, "The run folder")->required()->expected(1);
  add_set(resume);
  add_output(resume);
  add_permissions(resume);
  add_jobs(resume);
  add_threads(resume);
  add_profile(resume);
}

void Grammar::add_shared(CLI::App* sweep) {
  SharedSweep& shared = line_.shared;
  sweep->add_flag("--status", shared.status,
                  "Tell how far the sweep of this file or folder is, and who runs what; run nothing");
  sweep
      ->add_option("--launcher", shared.launcher,
                   "Print what starts the sweep by many processes, at most --jobs: a batch script for slurm, "
                   "or a line "
                   "with parallel or mpirun")
      ->check(known_name({"slurm", "parallel", "mpirun"}));
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

void Grammar::add_many() {
  CLI::App* sweep = add(
      "sweep", "Run a deck for every combination of what its section `sweep` varies; again: what is missing",
      command_sweep);
  add_deck(sweep);
  add_output(sweep);
  add_permissions(sweep);
  add_jobs(sweep);
  add_threads(sweep);
  sweep->add_flag("--dry-run", line_.dry_run,
                  "Print the cases and a line that does them one by one, and run nothing");
  sweep
      ->add_option("--case", line_.only_case,
                   "Run this case alone, from 1, unless it has a result; many at a time, as in a batch queue")
      ->check(CLI::PositiveNumber);
  add_shared(sweep);
  CLI::App* compare =
      add("compare", "Run a deck under several controls and compare the paths", command_compare);
  add_deck(compare);
  compare->add_option("--controls", line_.controls, "Names of controls, separated by commas")
      ->delimiter(',')
      ->required();
  add_output(compare);
  add_permissions(compare);
  add_threads(compare);
}

void Grammar::add_looking() {
  CLI::App* check =
      add("check", "Read, mesh and validate a deck; print counts, quality and predicted size without solving",
          command_check);
  add_deck(check);
  add_permissions(check);
  add_threads(check);
  CLI::App* explain =
      add("explain", "The manual of the deck: a section, a family, or family/name", command_explain);
  explain->add_option("topic", line_.topic, "Such as `path`, `law` or `law/linear_softening`");
  explain->add_flag("--json", line_.json, "The JSON schema of decks, for editors");
  CLI::App* plot = add("plot", "Overlay the load-displacement curves of runs", command_plot);
  plot->add_option("runs", line_.runs, "Run folders")->required();
  plot->add_option("--out", line_.out, "The figure")->capture_default_str();
  CLI::App* report =
      add("report", "Write one HTML page about a run or a sweep, to be read offline", command_report);
  report->add_option("folder", line_.runs, "The folder of the run or sweep")->required()->expected(1);
  report->add_option("--out", line_.page, "The page; report.html in that folder if not given");
  CLI::App* verify = add("verify",
                         "Check runs independently of what computed them: equilibrium, laws, energies, "
                         "reactions, the reason; 0 all hold, 3 some are refused",
                         command_verify);
  verify->add_option("runs", line_.runs, "Run folders")->required();
  add_animate();
}

void Grammar::add_animate() {
  CLI::App* animate =
      add("animate", "Write the motion of a run as an animation, GIF or MP4", command_animate);
  animate->add_option("run", line_.runs, "The run folder")->required()->expected(1);
  const auto option = [&](const std::string& names, const std::string& text) {
    const std::string word = names.substr(0, names.find(','));
    animate->add_option_function<std::string>(
        names, [this, word](const std::string& value) { line_.animation.push_back(word + "=" + value); },
        text);
  };
  option("--out,--output",
         "The file, .gif or .mp4 (which needs ffmpeg); motion.gif in that folder if not given");
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

std::string Grammar::unknown_name(int argc, char** argv) const {
  if (argc < 2) return {};
  const std::string first = argv[1];
  std::vector<std::string> names;
  const CLI::App* chosen = &app_;
  for (const auto& [sub, command] : commands_) {
    names.push_back(sub->get_name());
    if (sub->get_name() == first) chosen = sub;
  }
  if (chosen == &app_ && !first.starts_with('-'))
    return fmt::format("unknown command '{}'{}", first, suggest(first, names));
  std::vector<std::string> options;
  for (const CLI::Option* option : chosen->get_options())
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const std::string name = word.substr(0, word.find('='));
    if (!word.starts_with("--") || word == "--" || std::ranges::find(options, name) != options.end())
      continue;
    return fmt::format("unknown option '{}'{}", name, suggest(name, options));
  }
  return {};
}

int complain(const std::string& text, int code) {
  fmt::print(stderr, "{}\n", text);
  return code;
}

/// Of a sweep each process does its part. What a launcher of MPI has told it is kept from its runs, each of which
/// would take itself for a rank.
void leave_ranks() {
  std::vector<std::string> names;
  for (char** entry = environ; *entry; ++entry) {
    const std::string name(*entry, std::strcspn(*entry, "="));
    for (const char* prefix : {"OMPI_", "PMIX_", "PMI_", "PRTE_", "SLURM_STEP"})
      if (name.starts_with(prefix)) names.push_back(name);
  }
  for (const std::string& name : names) unsetenv(name.c_str());
}

/// Ranks would not share the blocks: each would run the whole deck into the same folder.
void refuse_ranks() {
  const char* ranks = std::getenv("OMPI_COMM_WORLD_SIZE");
  if (ranks && std::atoi(ranks) > 1)
    throw InputError(
        {}, fmt::format(
                "dda was started by mpirun as {} processes; it runs as one, with --threads; processes that "
                "share the cases of a sweep are started as `dda sweep`",
                ranks));
}

int execute(int argc, char** argv) {
  try {
    argc > 1 && std::string_view(argv[1]) == "sweep" ? leave_ranks() : refuse_ranks();
    Grammar grammar;
    if (const std::string wrong = grammar.unknown_name(argc, argv); !wrong.empty())
      return complain("dda: " + wrong + "\nRun `dda --help` for what there is.", 2);
    try {
      grammar.app().parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      return grammar.app().exit(error) == 0 ? 0 : 2;
    }
    return grammar.execute();
  } catch (const InputError& error) {
    return complain(error.what(), 2);
  } catch (const OutputError& error) {
    return complain(fmt::format("dda: {}", error.what()), 4);
  } catch (const std::bad_alloc&) {
    return complain("dda: not enough memory", 4);
  } catch (const std::exception& error) {
    return complain(fmt::format("dda: internal error: {}", error.what()), 4);
  } catch (...) {  // libraries throw texts as well
    return complain("dda: internal error", 4);
  }
}

/// What is printed may get lost as late as here: on a full disk.
bool is_printed() {
  std::cout.flush();
  const bool is_flushed = std::fflush(stdout) == 0;
  return is_flushed && std::cout.good() && std::ferror(stdout) == 0;
}

}  // namespace

int run_command_line(int argc, char** argv) {
  const int code = execute(argc, argv);
  return is_printed() ? code : complain("dda: cannot write to standard output", 4);
}

}  // namespace dda
