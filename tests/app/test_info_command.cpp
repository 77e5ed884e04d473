// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/io/off.h"
#include "tests/app/program.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using test_command_line::Outcome;
using test_command_line::run_executable;
using testing::HasSubstr;

TEST(InfoCommand, PrintsTextAndJson) {
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "box.off").string();
  Shape box = test::box({1, 1, 1}, 1);
  box.triangles = box.triangles.topRows(11).eval();
  write_off(file, box);
  const Outcome text = run_executable("info '" + file + "'");
  EXPECT_EQ(text.status, 0) << text.errors;
  EXPECT_THAT(text.output, HasSubstr("closed                  no\n"));
  EXPECT_THAT(text.output, HasSubstr("boundary edges          3\n"));
  const Outcome json = run_executable("info --format json '" + file + "'");
  EXPECT_EQ(json.status, 0) << json.errors;
  const auto found = nlohmann::json::parse(json.output);
  EXPECT_EQ(found["triangles"], 11);
  EXPECT_EQ(found["closed"], false);
  EXPECT_DOUBLE_EQ(found["area"], 5.5);
  EXPECT_DOUBLE_EQ(found["boundary_fraction"], (2 + std::sqrt(2)) / std::sqrt(3));
}

TEST(InfoCommand, PrintsShortNumbersWithoutExponents) {
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "box.off").string();
  Shape box = test::box({1, 1, 1}, 1);
  box.vertices *= 1234.5;
  write_off(file, box);
  EXPECT_THAT(run_executable("info '" + file + "'").output, HasSubstr("area                    9143940\n"));
}

TEST(InfoCommand, ReportsAVolumeThatOverflows) {
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "huge.off").string();
  Shape box = test::box({1, 1, 1}, 1);
  box.vertices *= 1e160;
  write_off(file, box);
  const Outcome text = run_executable("info '" + file + "'");
  EXPECT_THAT(text.output, HasSubstr("volume                  too large to compute\n"));
  EXPECT_THAT(text.output, testing::Not(HasSubstr("null")));
}

}  // namespace

}  // namespace shapegauge
