#include "tests/experiments/command_line/small_run.h"

#include "tests/experiments/small_dataset.h"
#include "tests/experiments/text_files.h"

namespace shapegauge::test_command_line {

void SmallRun::SetUp() {
  test_experiments::write_small_dataset(at("data"));
  test_experiments::write_text(at("small.json"), test_experiments::small_configuration("data").dump());
}

}  // namespace shapegauge::test_command_line
