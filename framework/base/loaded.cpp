#include "framework/base/loaded.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

namespace dda {

void* symbol_of(const std::filesystem::path& library, const char* symbol) {
  void* handle = dlopen(library.c_str(), RTLD_LAZY | RTLD_LOCAL);
  void* found = handle ? dlsym(handle, symbol) : nullptr;
  if (!found)
    throw std::runtime_error(fmt::format("cannot load {}: {}", library.filename().string(), dlerror()));
  return found;
}

std::filesystem::path installation() {
  Dl_info here{};
  const bool is_told = dladdr(reinterpret_cast<void*>(&module_file), &here) != 0;
  const std::filesystem::path file = is_told ? here.dli_fname : "";
  if (file.extension() == ".so")
    return std::filesystem::canonical(file).parent_path().parent_path().parent_path();
  return std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path();
}

std::filesystem::path module_file(const char* name) { return installation() / "lib" / "ddapath" / name; }

}  // namespace dda
