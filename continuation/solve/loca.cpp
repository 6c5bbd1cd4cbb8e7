#include "continuation/solve/loca.hpp"

#include "framework/base/loaded.hpp"

namespace dda {
namespace {

template <class Function>
Function loaded(const char* name) {
  return reinterpret_cast<Function>(symbol_of(module_file("dda_loca.so"), name));
}

}  // namespace

std::unique_ptr<LocaStepper> make_loca_stepper(const LocaSettings& settings) {
  static const auto make = loaded<LocaStepper* (*)(const LocaSettings&)>("dda_loca_stepper");
  return std::unique_ptr<LocaStepper>(make(settings));
}

std::vector<ListEntry> read_parameter_list(const std::filesystem::path& file) {
  using Read = void (*)(const std::filesystem::path&, std::vector<ListEntry>&);
  std::vector<ListEntry> out;
  loaded<Read>("dda_read_parameter_list")(file, out);
  return out;
}

std::string parameter_list_text(const std::vector<ListEntry>& entries) {
  using Write = void (*)(const std::vector<ListEntry>&, std::string&);
  std::string out;
  loaded<Write>("dda_parameter_list_text")(entries, out);
  return out;
}

}  // namespace dda
