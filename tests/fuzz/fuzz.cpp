// Runs the program on mutants of decks, geometries, meshes and run folders, each in a process of its own, and
// fails on a crash, on more than 10 s of a processor, on an exit code that is not in 0, 2, 3, and on wrong
// input that leaves something behind.
//   fuzz check|run|resume|report COUNT [--seed N] [--first N] [--keep FOLDER] [--show] DECK...
// Interrupted, it says what the mutants so far have come to.
// A mutant is made of (seed, number) alone: `--first NUMBER` with a count of 1 makes it again.
#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

#include "framework/base/loaded.hpp"
#include "fuzz/mutator.hpp"
#include "studies/dda/line/command_line.hpp"

namespace dda::fuzz {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double longest = 60;          ///< [s]; a machine may be busy
constexpr rlim_t longest_at_work = 10;  ///< of a processor [s]
const std::set<std::string> extensions{".geo", ".msh"};

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

/// A deck with the files beside it, or a run folder.
struct Seed {
  std::map<std::string, std::string> files;
  std::string deck;
};

struct Options {
  std::string mode;
  std::size_t count = 0, seed = 1, first = 0;
  fs::path keep;
  bool shows_all = false;
  std::vector<fs::path> decks;
};

/// Loads what every process would load by itself, which takes longer than to read a small deck: a process
/// that is forked has it, and finds nothing of it begun.
void load_modules() {
  for (const char* module :
       {"dda_muparser.so", "dda_gmsh.so", "dda_geos.so", "dda_loca.so", "dda_trilinos.so"})
    if (!dlopen(module_file(module).c_str(), RTLD_LAZY | RTLD_LOCAL)) throw std::runtime_error(dlerror());
}

volatile std::sig_atomic_t is_interrupted = 0;

void stop_when_interrupted() {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { is_interrupted = 1; });
}

/// How a process ended.
struct End {
  int code = 0, signal = 0;
  bool is_late = false;

  bool is_right() const { return !is_late && signal == 0 && (code == 0 || code == 2 || code == 3); }
  std::string words() const {
    if (is_late) return "took too long";
    return signal ? fmt::format("signal {} ({})", signal, strsignal(signal))
                  : fmt::format("exit code {}", code);
  }
};

[[noreturn]] void become(const std::vector<std::string>& arguments, const fs::path& folder) {
  setpgid(0, 0);
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
#ifndef __SANITIZE_ADDRESS__
  const rlimit memory{rlim_t{4} << 30, rlim_t{4} << 30};
  setrlimit(RLIMIT_AS, &memory);
#endif
  const rlimit work{longest_at_work, longest_at_work};
  setrlimit(RLIMIT_CPU, &work);
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  const int output = open((folder / "said.log").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  if (chdir(folder.c_str()) != 0) _exit(1);
  std::vector<char*> words;
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  _exit(run_command_line(static_cast<int>(words.size()), words.data()));
}

End end_of(const std::vector<std::string>& arguments, const fs::path& folder) {
  const auto start = Clock::now();
  const pid_t process = fork();
  if (process == 0) become(arguments, folder);
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  End out;
  int status = 0;
  while (waitpid(process, &status, WNOHANG) == 0) {
    if (elapsed() > longest && !out.is_late) {
      out.is_late = true;
      kill(-process, SIGKILL);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(elapsed() < 0.02 ? 200 : 2000));
  }
  out.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  out.code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  return out;
}

std::vector<std::string> arguments_of(const std::string& mode, const std::string& deck) {
  if (mode == "check")
    return {"dda", "check", deck, "--memory-limit=0.03", "--set", "scene.meshing_seconds=5"};
  if (mode == "run")
    return {"dda",        "run", deck,      "--memory-limit=0.03", "--set", "scene.meshing_seconds=5",
            "--folder",   "out", "--quiet", "--overwrite",         "--set", "path.stop.steps=3",
            "--threads=1"};
  if (mode == "resume")
    return {"dda", "resume", "out", "--quiet", "--set", "path.stop.steps=6", "--threads=1"};
  return {"dda", "report", "out"};
}

class Campaign {
 public:
  explicit Campaign(Options options)
      : options_(std::move(options)),
        scratch_(fs::temp_directory_path() / fmt::format("dda_fuzz_{}", getpid())) {
    fs::create_directories(scratch_);
    load_modules();
    for (const fs::path& deck : options_.decks) add_seed(deck);
    for (const Seed& seed : seeds_)
      for (const auto& [name, text] : seed.files) add_words(text);
    words_ = {word_set_.begin(), word_set_.end()};
  }
  ~Campaign() {
    std::error_code ignored;
    fs::remove_all(scratch_, ignored);
  }

  /// How many mutants failed.
  std::size_t run() {
    std::map<std::string, std::size_t> ends;
    std::size_t failed = 0;
    stop_when_interrupted();
    for (std::size_t i = options_.first; i < options_.first + options_.count && !is_interrupted; ++i) {
      const End end = try_mutant(i);
      ++ends[end.words()];
      const bool is_right = end.is_right() && !has_no_number() && !has_left_something(end);
      if (!is_right || options_.shows_all) report(i, end);
      if (!is_right) ++failed;
    }
    for (const auto& [words, count] : ends) fmt::print("{:>8}  {}\n", count, words);
    return failed;
  }

 private:
  void add_words(const std::string& text) {
    if (text.find('\0') != std::string::npos) return;
    std::string word;
    for (const char c : text) {
      if (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.')
        word += c;
      else if (!word.empty())
        word_set_.insert(std::exchange(word, {}));
    }
  }

  void add_seed(const fs::path& deck) {
    Seed seed;
    seed.deck = deck.filename();
    seed.files[seed.deck] = read(deck);
    for (const fs::directory_entry& entry : fs::directory_iterator(deck.parent_path()))
      if (extensions.contains(entry.path().extension()))
        seed.files[entry.path().filename()] = read(entry.path());
    place(seed, scratch_ / "it");
    const bool is_run = options_.mode == "resume" || options_.mode == "report";
    const End end = end_of(arguments_of(is_run ? "run" : options_.mode, seed.deck), scratch_ / "it");
    if (end.is_late || end.signal || (end.code != 0 && end.code != 3)) return;
    if (is_run) {
      seed.files.clear();
      for (const fs::directory_entry& entry : fs::recursive_directory_iterator(scratch_ / "it" / "out"))
        if (entry.is_regular_file())
          seed.files[entry.path().lexically_relative(scratch_ / "it").string()] = read(entry.path());
    }
    seeds_.push_back(std::move(seed));
  }

  static void place(const Seed& seed, const fs::path& folder) {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    fs::create_directories(folder / "out");
    for (const auto& [name, text] : seed.files) write(folder / name, text);
    if (!seed.files.contains("out/restart.h5")) fs::remove(folder / "out", ignored);
  }

  /// Of a run those that are read again.
  static std::vector<std::string> changeable(const Seed& seed) {
    static const std::set<std::string> read_again{
        "out/restart.h5",       "out/curve.csv", "out/log.jsonl",          "out/summary.json",
        "out/curve.units.json", "out/deck.yaml", "out/effective_deck.yaml"};
    std::vector<std::string> out;
    for (const auto& [name, text] : seed.files)
      if (!seed.files.contains("out/restart.h5") || read_again.contains(name) ||
          name.starts_with("out/fields/"))
        out.push_back(name);
    return out;
  }

  End try_mutant(std::size_t number) {
    Mutator mutator(options_.seed * 0x9e3779b97f4a7c15ULL + number, words_);
    Seed mutant = seeds_.at(mutator.below(seeds_.size()));
    const std::vector<std::string> names = changeable(mutant);
    const auto file = mutant.files.find(names[mutator.below(names.size())]);
    const bool is_binary = file->second.find('\0') != std::string::npos;
    file->second = mutator.mutated(file->second, is_binary);
    place(mutant, scratch_ / "it");
    return end_of(arguments_of(options_.mode, mutant.deck), scratch_ / "it");
  }

  /// "nan MiB" is no answer.
  bool has_no_number() const {
    const std::string said = read(scratch_ / "it" / "said.log");
    return said.find("nan MiB") != std::string::npos || said.find("inf MiB") != std::string::npos;
  }

  /// Wrong input leaves no folder behind, but for a sweep of which a case is wrong.
  bool has_left_something(const End& end) const {
    const fs::path out = scratch_ / "it" / "out";
    return options_.mode == "run" && end.code == 2 && fs::exists(out) && !fs::exists(out / "sweep.json");
  }

  void report(std::size_t number, const End& end) const {
    std::string said = read(scratch_ / "it" / "said.log");
    said = said.substr(said.size() > 300 ? said.size() - 300 : 0);
    fmt::print("mutant {} of seed {}: {}; it said: {}\n", number, options_.seed, end.words(), said);
    std::fflush(stdout);
    if (options_.keep.empty()) return;
    fs::create_directories(options_.keep);
    fs::copy(scratch_ / "it", options_.keep / fmt::format("{}-{}-{}", options_.mode, options_.seed, number),
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  }

  Options options_;
  fs::path scratch_;
  std::vector<Seed> seeds_;
  std::set<std::string> word_set_;
  std::vector<std::string> words_;
};

Options read_options(const std::vector<std::string>& words) {
  Options out;
  out.mode = words.at(0);
  out.count = std::stoul(words.at(1));
  for (std::size_t i = 2; i < words.size(); ++i) {
    if (words[i] == "--seed")
      out.seed = std::stoul(words.at(++i));
    else if (words[i] == "--show")
      out.shows_all = true;
    else if (words[i] == "--first")
      out.first = std::stoul(words.at(++i));
    else if (words[i] == "--keep")
      out.keep = fs::absolute(words.at(++i));
    else
      out.decks.push_back(fs::absolute(words[i]));
  }
  return out;
}

}  // namespace
}  // namespace dda::fuzz

int main(int argc, char** argv) {
  try {
    return dda::fuzz::Campaign(dda::fuzz::read_options({argv + 1, argv + argc})).run() == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(
        stderr,
        "usage: fuzz check|run|resume|report COUNT [--seed N] [--first N] [--keep FOLDER] DECK...\n{}\n",
        error.what());
    return 2;
  }
}
