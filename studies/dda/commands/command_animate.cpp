#include "studies/dda/commands/commands.hpp"
#include "studies/dda/commands/python_command.hpp"

namespace dda {

int command_animate(const CommandLine& line) {
  std::vector<std::string> words = line.animation;
  words.insert(words.end(), {"--", line.runs.front().string()});
  become_python({"animate", "animation",
                 "python3-h5py python3-matplotlib python3-numpy python3-pandas python3-pil python3-yaml"},
                words);
}

}  // namespace dda
