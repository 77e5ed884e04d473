// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/io/formats.h"
#include "tests/app/program.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge::test_command_line {

namespace {

using testing::HasSubstr;
using InfoCommand = CommandTest;

TEST_F(InfoCommand, PrintsTheBoundaryOfAnOpenMeshAsTextAndJson) {
  Shape box = test::box({1, 1, 1}, 1);
  box.triangles = box.triangles.topRows(11).eval();
  write_off(at("box.off"), box);
  const Outcome text = succeeded(run("info @box.off"));
  EXPECT_THAT(text.output, HasSubstr("closed                  no\n"));
  EXPECT_THAT(text.output, HasSubstr("boundary edges          3\n"));
  const Outcome json = succeeded(run("info --format json @box.off"));
  const auto found = nlohmann::json::parse(json.output);
  EXPECT_EQ(found["triangles"], 11);
  EXPECT_EQ(found["closed"], false);
  EXPECT_DOUBLE_EQ(found["area"], 5.5);
  EXPECT_DOUBLE_EQ(found["boundary_fraction"], (2 + std::sqrt(2)) / std::sqrt(3));
}

TEST_F(InfoCommand, PrintsShortNumbersWithoutExponents) {
  Shape box = test::box({1, 1, 1}, 1);
  box.vertices *= 1234.5;
  write_off(at("box.off"), box);
  EXPECT_THAT(run("info @box.off").output, HasSubstr("area                    9143940\n"));
}

TEST_F(InfoCommand, ReportsAVolumeThatOverflows) {
  Shape box = test::box({1, 1, 1}, 1);
  box.vertices *= 1e160;
  write_off(at("huge.off"), box);
  const Outcome text = run("info @huge.off");
  EXPECT_THAT(text.output, HasSubstr("volume                  too large to compute\n"));
  EXPECT_THAT(text.output, testing::Not(HasSubstr("null")));
}

}  // namespace

}  // namespace shapegauge::test_command_line
