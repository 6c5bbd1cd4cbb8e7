#include "studies/dda/line/command_line.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <iostream>
#include <new>

#include "framework/messages/colour.hpp"
#include "framework/messages/excerpt.hpp"
#include "framework/messages/tell.hpp"
#include "framework/plugin/plugin.hpp"
#include "studies/dda/line/grammar.hpp"
#include "studies/dda/line/ranks.hpp"

namespace dda {
namespace {

int complain(const std::string& text, int code) {
  tell(stderr, "{}\n", text);
  return code;
}

int obey(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  Grammar grammar;
  if (const std::string wrong = grammar.unknown_name(words); !wrong.empty())
    return complain("dda: " + wrong + "\nRun `dda --help` for what there is.", 2);
  try {
    grammar.app().parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return grammar.app().exit(error) == 0 ? 0 : 2;
  }
  for (const std::filesystem::path& plugin : grammar.line().plugins) load_plugin(plugin);
  return grammar.execute();
}

int execute(int argc, char** argv) {
  try {
    return obey(argc, argv);
  } catch (const InputError& error) {
    return complain(with_excerpts(error, shows_colours(stderr)), 2);
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
  return on_all_ranks(argc, argv, [&] {
    const int code = execute(argc, argv);
    return is_printed() ? code : complain("dda: cannot write to standard output", 4);
  });
}

}  // namespace dda
