// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/io/formats.h"
#include "tests/app/program.h"
#include "tests/support/page_text.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge::test_command_line {

namespace {

using testing::HasSubstr;

/// Checks a plate of thickness 1.
class CheckCommand : public CommandTest {
 protected:
  CheckCommand() { write_off(at("plate.off"), test::box({20, 12, 1}, 1)); }

  [[nodiscard]] Outcome check(const std::string& options) const { return run("check @plate.off " + options); }
};

TEST_F(CheckCommand, ExitsWithStatusThreeForThinWallsAndZeroOtherwise) {
  const Outcome thin = check("--unit mm --min-wall 1.2 --min-gap 0.5");
  EXPECT_EQ(thin.status, 3) << thin.errors;
  EXPECT_THAT(thin.output, HasSubstr("walls below 1.2 mm: 2 thin walls\n"));
  EXPECT_THAT(thin.output, HasSubstr("gaps below 0.5 mm: none\n"));
  EXPECT_THAT(thin.output, HasSubstr("does not pass: 2 thin walls\n"));
  const Outcome thick = succeeded(check("--unit mm --min-wall 900um"));
  EXPECT_THAT(thick.output, HasSubstr("\npasses\n"));
}

TEST_F(CheckCommand, FailsIfAnyPartHasThinWallsOrNarrowGaps) {
  const Shape block = test::box({20, 12, 9}, 1);
  write_off(at("block.off"), block);
  EXPECT_EQ(run("check @block.off @plate.off --min-wall 1.2").status, 3);
  const Shape above = test::transformed(block, 1, Eigen::Matrix3d::Identity(), {0, 0, 9.4});
  write_off(at("slot.off"), test::joined({block, above}));
  const Outcome slot = run("check @slot.off --min-wall 1.2 --min-gap 0.5");
  EXPECT_EQ(slot.status, 3);
  EXPECT_THAT(slot.output, HasSubstr("does not pass: 2 narrow gaps\n"));
}

TEST_F(CheckCommand, ListsThinRegionsInJsonAndCsv) {
  const auto json = nlohmann::json::parse(check("--min-wall 1.2 --format json").output);
  EXPECT_EQ(json["passes"], false);
  EXPECT_EQ(json["voids"], 0);
  EXPECT_TRUE(json["gaps"].is_null());
  ASSERT_EQ(json["walls"]["regions"].size(), 2);
  const auto& region = json["walls"]["regions"][0];
  EXPECT_EQ(region["kind"], "wall");
  EXPECT_NEAR(region["area"].get<double>(), 240, 1e-6);
  EXPECT_NEAR(region["minimum"].get<double>(), 1, 1e-9);
  EXPECT_NEAR(region["short_by"].get<double>(), 0.2, 1e-9);
  EXPECT_EQ(region["faces"].size(), 2);
  const Outcome csv = check("--min-wall 1.2 --format csv");
  EXPECT_EQ(csv.status, 3);
  EXPECT_THAT(csv.output, testing::StartsWith("file,kind,region,area,minimum,median,short_by,x,y,z,"));
  EXPECT_EQ(std::ranges::count(csv.output, '\n'), 3);
}

TEST_F(CheckCommand, HtmlPageShowsTheShapeWithItsUpAxisVertical) {
  for (const auto& [options, axis] : {std::pair("", 1), {"--up z", 2}}) {
    EXPECT_EQ(check(std::string("--min-wall 1.2 --replace -o @page.html ") + options).status, 3);
    const auto page = test::json_of_page(test::text_of(at("page.html")));
    EXPECT_GT(page["shapes"][0]["axes"][1][axis].get<double>(), 0.9) << options;
  }
}

TEST_F(CheckCommand, RejectsMissingNonPositiveAndNonNumericLimits) {
  const std::vector<std::pair<std::string, std::string>> refused{{"", "--min-wall"},
                                                                 {"--min-wall 0", "--min-wall"},
                                                                 {"--min-wall thin", "--min-wall"},
                                                                 {"--min-gap 1mm", "--unit"},
                                                                 {"--min-gap 1 --min-area -1", "area"}};
  for (const auto& [options, word] : refused) {
    const Outcome outcome = check(options);
    EXPECT_EQ(outcome.status, 2) << options;
    EXPECT_THAT(outcome.errors, HasSubstr(word)) << options;
  }
}

}  // namespace

}  // namespace shapegauge::test_command_line
