#include <malloc.h>

#include "studies/dda/line/command_line.hpp"

namespace {

/// Vectors of all unknowns come and go with each step. glibc stops handing them back to the system after it
/// has seen blocks of their size freed; this is where that ends (mallopt(3): DEFAULT_MMAP_THRESHOLD_MAX,
/// twice it).
void keep_freed_memory() {
  constexpr int block = 32 << 20;
  mallopt(M_MMAP_THRESHOLD, block);
  mallopt(M_TRIM_THRESHOLD, 2 * block);
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  return dda::run_command_line(argc, argv);
}
