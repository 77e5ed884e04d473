#include <string>
#include <vector>

#include "shapegauge/experiments/command_line/run_program.h"

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  return shapegauge::run_program(arguments);
}
