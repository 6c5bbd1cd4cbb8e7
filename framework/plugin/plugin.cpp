#include "framework/plugin/plugin.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "framework/deck/family.hpp"
#include "framework/plugin/stamp.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path>& plugins() {
  static std::vector<fs::path> list;
  return list;
}

/// The stamp in the file of a plugin; "" in any other file.
std::string stamp_in(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t mark = bytes.find(DDA_PLUGIN_MARK);
  return mark == std::string::npos ? "" : bytes.c_str() + mark + std::string_view(DDA_PLUGIN_MARK).size();
}

std::size_t count_members() {
  std::size_t count = 0;
  for (const FamilyBase* family : all_families()) count += family->entries().size();
  return count;
}

void check_stamp(const fs::path& file, const Position& where) {
  if (!fs::is_regular_file(file)) throw InputError(where, "there is no such plugin");
  const std::string stamp = stamp_in(file);
  if (stamp.empty())
    throw InputError(where,
                     "is no plugin of ddapath: one is a library linked with ddapath::ddapath, which CMake's "
                     "find_package(ddapath) finds");
  if (stamp != DDA_PLUGIN_STAMP)
    throw InputError(
        where, fmt::format("was built for ddapath {}; this is ddapath {}: build the plugin again with this "
                           "installation's find_package(ddapath)",
                           stamp, DDA_PLUGIN_STAMP));
}

/// Its registrations run in here. What they throw comes through the loader, and ends the program soon; that of glibc is
/// declared to throw nothing, so that it is called by a pointer which is not.
void open(const fs::path& file, const Position& where) {
  const std::size_t before = count_members();
  void* (*volatile loader)(const char*, int) = dlopen;
  void* handle = nullptr;
  try {
    handle = loader(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  } catch (const std::exception& error) {
    throw InputError(where, fmt::format("cannot be used: {}", error.what()));
  }
  if (!handle) throw InputError(where, fmt::format("cannot be loaded: {}", dlerror()));
  if (count_members() == before)
    throw InputError(where, "registers nothing: see DDA_REGISTER in CONTRIBUTING.md");
}

}  // namespace

void load_plugin(const fs::path& file) {
  const fs::path whole = fs::weakly_canonical(fs::absolute(file));
  if (std::ranges::find(plugins(), whole) != plugins().end()) return;
  const Position where{file.string()};
  check_stamp(whole, where);
  open(whole, where);
  plugins().push_back(whole);
}

const std::vector<fs::path>& loaded_plugins() { return plugins(); }

}  // namespace dda
