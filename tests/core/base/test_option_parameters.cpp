#include <cmath>
#include <gtest/gtest.h>

#include "shapegauge/core/base/option_parameters.h"

namespace shapegauge {

namespace {

struct Options {
  int count = 3;
  double share = 0.5;
  bool wanted = true;
};

constexpr std::array table = {
    option_of<&Options::count>("count", {.low = 1, .high = 9}, "How many."),
    option_of<&Options::share>("share", {.low = 0, .high = 1, .high_open = true}, "How much."),
    option_of<&Options::wanted>("wanted", "Whether at all."),
};
constexpr auto parameters = parameters_of(table);

TEST(OptionParameters, HaveTheKindsAndDefaultsOfTheMembers) {
  EXPECT_EQ(parameters[0].kind, ParameterKind::integer);
  EXPECT_EQ(parameters[1].kind, ParameterKind::number);
  EXPECT_EQ(parameters[2].kind, ParameterKind::boolean);
  const ParameterValues values(parameters);
  EXPECT_EQ(values.integer("count"), 3);
  EXPECT_EQ(values.number("share"), 0.5);
  EXPECT_TRUE(values.boolean("wanted"));
}

TEST(OptionParameters, BecomeOptionsAgain) {
  ParameterValues values(parameters);
  values.set("count", std::int64_t{7});
  values.set("wanted", false);
  const Options options = options_from(table, values);
  EXPECT_EQ(options.count, 7);
  EXPECT_EQ(options.share, 0.5);
  EXPECT_FALSE(options.wanted);
  EXPECT_THROW(values.set("count", std::int64_t{10}), InputError);
}

TEST(OptionParameters, BoundsHoldForOptionsToo) {
  EXPECT_NO_THROW(check_options("x", table, Options{}));
  EXPECT_THROW(check_options("x", table, {.count = 0}), InputError);
  EXPECT_THROW(check_options("x", table, {.share = 1}), InputError);
  EXPECT_THROW(check_options("x", table, {.share = std::nan("")}), InputError);
}

}  // namespace

}  // namespace shapegauge
