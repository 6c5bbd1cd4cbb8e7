#include "continuation/solve/loca.hpp"

#include "framework/base/loaded.hpp"

namespace dda {

std::unique_ptr<LocaStepper> make_loca_stepper(const LocaLists& lists) {
  using Make = LocaStepper* (*)(const LocaLists&);
  static const auto make =
      reinterpret_cast<Make>(symbol_of(module_file(DDA_LOCA_MODULE), "dda_loca_stepper"));
  return std::unique_ptr<LocaStepper>(make(lists));
}

}  // namespace dda
