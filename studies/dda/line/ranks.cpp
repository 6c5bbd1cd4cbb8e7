#include "studies/dda/line/ranks.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "continuation/linear/strips/strip_part.hpp"
#include "continuation/ranks/ranks.hpp"
#include "framework/base/errors.hpp"
#include "framework/base/launched.hpp"
#include "framework/base/memory.hpp"
#include "framework/messages/tell.hpp"
#include "studies/dda/line/grammar.hpp"

namespace dda {
namespace {

/// Of a sweep each process does its part. What a launcher of MPI has told it is kept from its runs, each of which
/// would take itself for a rank.
void leave_ranks() {
  constexpr std::array of_launchers{"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "SLURM_STEP_NUM_TASKS"};
  if (std::ranges::none_of(of_launchers, [](const char* name) { return std::getenv(name); })) return;
  std::vector<std::string> names;
  for (char** entry = environ; *entry; ++entry) {
    const std::string name(*entry, std::strcspn(*entry, "="));
    for (const char* prefix : {"OMPI_", "PMIX_", "PMI_", "PRTE_", "SLURM_STEP"})
      if (name.starts_with(prefix)) names.push_back(name);
  }
  for (const std::string& name : names) unsetenv(name.c_str());
}

/// Of a rank that is short of address space, without which OpenBLAS waits for ever, every answer is that it is.
Answer answer_of_rank() {
  try {
    require_address_space();
    return answer_by_parts();
  } catch (const InputError& error) {
    return [what = std::string(error.what())](Message&) -> Message { throw std::runtime_error(what); };
  }
}

/// Where the launcher and MPI do not know each other rank 0 says so.
int serve() {
  try {
    serve_ranks(answer_of_rank());
    return 0;
  } catch (const InputError&) {
    return 0;
  } catch (const std::exception& error) {
    tell(stderr, "dda: rank {}: {}\n", launched().rank, error.what());
    return 4;
  }
}

int lead(const std::function<int()>& command) {
  Ranks ranks = Ranks::of_launcher(answer_by_parts());
  set_ranks_of_run(&ranks);
  const int code = command();
  set_ranks_of_run(nullptr);
  ranks.end();
  return code;
}

}  // namespace

int on_all_ranks(int argc, char** argv, const std::function<int()>& command) {
  const Launched here = launched();
  const std::vector<std::string> words(argv + 1, argv + argc);
  const std::size_t position = command_position(words);
  const std::string name = position < words.size() ? words[position] : "";
  if (name == "sweep") leave_ranks();
  if (here.size == 1 || name == "sweep") return command();
  const bool is_shared = name == "run" || name == "resume";
  if (here.rank > 0) return is_shared ? serve() : 0;
  try {
    if (is_shared) return lead(command);
    throw InputError(
        {}, fmt::format("dda was started as {} processes: several share the work of `dda run` and `dda "
                        "resume`, and the cases of `dda sweep`; `dda {}` is for one",
                        here.size, name));
  } catch (const InputError& error) {
    tell(stderr, "{}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    tell(stderr, "dda: {}\n", error.what());
    return 4;
  }
}

}  // namespace dda
