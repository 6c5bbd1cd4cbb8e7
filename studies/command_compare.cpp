#include "studies/commands.hpp"

namespace dda {

int command_compare(const CommandLine&) { return 4; }

}  // namespace dda
