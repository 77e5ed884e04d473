#include "shapegauge/experiments/command_line/threads_option.h"

namespace shapegauge {

void add_threads_option(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "Number of threads (default: all)")->check(CLI::Range(1, 1024));
}

}  // namespace shapegauge
