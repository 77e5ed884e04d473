#include <malloc.h>
#include <string>
#include <vector>

#include "app/run_program.h"

namespace {

/// Structures of tens of megabytes come and go with every shape: their memory is kept for the next ones.
void keep_memory() {
#ifdef __GLIBC__
  constexpr int large = 256 << 20;
  mallopt(M_MMAP_THRESHOLD, large);
  mallopt(M_TRIM_THRESHOLD, large);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  keep_memory();
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  return shapegauge::run_program(arguments);
}
