#include <dlfcn.h>

#include "framework/base/loaded.hpp"
#include "framework/base/threads.hpp"
#include "framework/plugin/plugin.hpp"
#include "python/core/bindings.hpp"

namespace dda::python {
namespace {

/// Modules that a run loads, and plugins, find what is ours in this library, as they find it in the program.
void share_symbols() {
  Dl_info here{};
  if (dladdr(reinterpret_cast<void*>(&share_symbols), &here) == 0 ||
      dlopen(here.dli_fname, RTLD_LAZY | RTLD_NOLOAD | RTLD_GLOBAL) == nullptr)
    throw std::runtime_error("the library of ddapath cannot be found by the modules that it loads");
}

}  // namespace
}  // namespace dda::python

PYBIND11_MODULE(_core, module) {
  using namespace dda::python;
  share_symbols();
  module.doc() = "What `ddapath` asks of the program's own code; use the package, not this module.";
  bind_errors();
  bind_laws(module);
  bind_loads(module);
  bind_controls(module);
  bind_followed(module);
  module.def("load_plugin", [](const std::string& file) { dda::load_plugin(file); });
  module.def("set_num_threads", &dda::set_num_threads);
  module.def("num_threads", &dda::num_threads);
  module.def("installation", [] { return dda::installation().string(); });
}
