// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <string_view>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parameter.h"

namespace shapegauge {
namespace {

constexpr std::array<std::string_view, 2> words{"auto", "none"};
constexpr std::array<std::string_view, 2> engines{"embree", "cgal"};
constexpr std::array<Parameter, 4> parameters{{
    {.name = "offset", .bounds = {.low = 0, .high = 1, .low_open = true}, .choices = words, .description = ""},
    {.name = "rays",
     .kind = ParameterKind::integer,
     .default_value = 25,
     .bounds = {.low = 1, .high = 100},
     .description = ""},
    {.name = "smooth", .kind = ParameterKind::boolean, .default_value = false, .description = ""},
    {.name = "engine",
     .kind = ParameterKind::choice,
     .default_value = engines[0],
     .choices = engines,
     .description = ""},
}};

TEST(ParameterBounds, ContainClosedButNotOpenEndsOfTheInterval) {
  constexpr Bounds half_open{.low = 0, .high = 1, .low_open = true};
  EXPECT_FALSE(half_open.contains(0));
  EXPECT_TRUE(half_open.contains(std::numeric_limits<double>::denorm_min()));
  EXPECT_TRUE(half_open.contains(1));
  EXPECT_FALSE(half_open.contains(1 + std::numeric_limits<double>::epsilon()));
  constexpr Bounds other{.low = 0, .high = 1, .high_open = true};
  EXPECT_TRUE(other.contains(0));
  EXPECT_FALSE(other.contains(1));
}

TEST(ParameterBounds, NeverContainInfinityOrNaN) {
  constexpr Bounds unlimited;
  EXPECT_TRUE(unlimited.contains(std::numeric_limits<double>::max()));
  EXPECT_FALSE(unlimited.contains(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(unlimited.contains(-std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(unlimited.contains(std::numeric_limits<double>::quiet_NaN()));
}

TEST(ParameterBounds, AreDescribedInWords) {
  EXPECT_EQ(to_string({.low = 0, .high = 1}), "from 0 to 1");
  EXPECT_EQ(to_string({.low = 0, .high = 1, .low_open = true}), "above 0 and at most 1");
  EXPECT_EQ(to_string({.low = 0, .high = 180, .low_open = true, .high_open = true}), "above 0 and below 180");
  EXPECT_EQ(to_string({.low = 1}), "at least 1");
  EXPECT_EQ(to_string({.high = 3, .high_open = true}), "below 3");
}

TEST(RequireInBounds, ReportsAValueOutOfBoundsWithTheBounds) {
  EXPECT_NO_THROW(require_in_bounds("the scale", 1, {.low = 1}));
  const auto refuse = [] { require_in_bounds("the scale", 0.5, {.low = 1}); };
  EXPECT_THAT(refuse, testing::ThrowsMessage<InputError>(testing::HasSubstr("the scale is 0.5")));
}

TEST(ParameterValues, AreTheDefaultsUntilSet) {
  const ParameterValues values(parameters);
  EXPECT_EQ(values.integer("rays"), 25);
  EXPECT_FALSE(values.boolean("smooth"));
  EXPECT_EQ(values.word("engine"), "embree");
  EXPECT_THROW(values.require_complete(), InputError);  // the offset has no default
}

TEST(ParameterValues, AcceptValuesOfTheirTypeWithinBounds) {
  ParameterValues values(parameters);
  values.set("offset", 1);  // a whole number is a number
  values.set("rays", 100);
  values.set("smooth", true);
  values.set("engine", std::string_view("cgal"));
  EXPECT_NO_THROW(values.require_complete());
  EXPECT_EQ(values.number("offset"), 1);
  EXPECT_EQ(values.integer("rays"), 100);
  EXPECT_TRUE(values.boolean("smooth"));
  EXPECT_EQ(values.word("engine"), "cgal");
  values.set("offset", std::string_view("auto"));
  EXPECT_EQ(values.word("offset"), "auto");
}

TEST(ParameterValues, DoNotChangeWithTheStringTheyWereSetFrom) {
  ParameterValues values(parameters);
  {
    std::string source = "cgal";
    values.set("engine", std::string_view(source));
    source = "????";
  }
  EXPECT_EQ(values.word("engine"), "cgal");
}

TEST(ParameterValues, RejectUnknownNamesWrongTypesAndValuesOutOfBounds) {
  ParameterValues values(parameters);
  EXPECT_THROW(values.set("offset", 0.0), InputError);
  EXPECT_THROW(values.set("offset", std::string_view("embree")), InputError);
  EXPECT_THROW(values.set("offset", true), InputError);
  EXPECT_THROW(values.set("rays", 0), InputError);
  EXPECT_THROW(values.set("rays", 101), InputError);
  EXPECT_THROW(values.set("rays", 2.0), InputError);
  EXPECT_THROW(values.set("smooth", 1), InputError);
  EXPECT_THROW(values.set("engine", std::string_view("auto")), InputError);
  EXPECT_THROW(values.set("engine", std::monostate()), InputError);
  EXPECT_THROW(values.set("ray", 3), InputError);
  EXPECT_EQ(values.integer("rays"), 25) << "a rejected value leaves the old one";
}

TEST(ParseValue, ParsesNumbersBooleansWordsAndLists) {
  EXPECT_EQ(parse_value(parameters[0], "2e-1"), ParameterValue(0.2));
  EXPECT_EQ(parse_value(parameters[0], "auto"), ParameterValue("auto"));
  EXPECT_EQ(parse_value(parameters[1], "7"), ParameterValue(std::int64_t{7}));
  EXPECT_EQ(parse_value(parameters[2], "true"), ParameterValue(true));
  EXPECT_EQ(parse_value(parameters[3], "cgal"), ParameterValue("cgal"));
  constexpr Parameter sizes{.name = "sizes", .kind = ParameterKind::integers, .bounds = {.low = 1}, .description = ""};
  EXPECT_EQ(parse_value(sizes, "3"), ParameterValue(IntegerList(3)));
  EXPECT_EQ(parse_value(sizes, "3,1,2"), ParameterValue(IntegerList{3, 1, 2}));
  EXPECT_EQ(to_string(parse_value(sizes, "3,1,2")), "3,1,2");
}

TEST(ParseValue, RejectsTextOfAnotherTypeOrOutOfBounds) {
  constexpr Parameter sizes{.name = "sizes", .kind = ParameterKind::integers, .bounds = {.low = 1}, .description = ""};
  for (const std::string_view text : {"", "3,", ",3", "3;4", "3 4", "0", "1,2,3,4,5,6,7,8,9,1,2,3,4,5,6,7,8", "1.5"}) {
    EXPECT_THROW(parse_value(sizes, text), InputError) << text;
  }
  for (const std::string_view text : {"0", "2", "x", "1,2", "true", "nan"}) {
    EXPECT_THROW(parse_value(parameters[0], text), InputError) << text;
  }
  for (const std::string_view text : {"101", "1.5", "1,2", "auto", "99999999999999999999"}) {
    EXPECT_THROW(parse_value(parameters[1], text), InputError) << text;
  }
  for (const std::string_view text : {"1", "yes", "True"}) EXPECT_THROW(parse_value(parameters[2], text), InputError);
  EXPECT_THROW(parse_value(parameters[3], "other"), InputError);
}

TEST(ParameterValues, ErrorMessagesStateTheValidValues) {
  ParameterValues values(parameters);
  const auto message_of = [&](std::string_view name, const ParameterValue& value) -> std::string {
    try {
      values.set(name, value);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message_of("offset", 2), "offset is 2; it must be a number above 0 and at most 1, or auto, none");
  EXPECT_EQ(message_of("rays", 0), "rays is 0; it must be a whole number from 1 to 100");
  EXPECT_EQ(message_of("engine", std::string_view("x")), "engine is \"x\"; it must be one of embree, cgal");
  EXPECT_EQ(message_of("engine", std::string_view("embre")),
            "engine is \"embre\"; it must be one of embree, cgal; did you mean \"embree\"?");
}

}  // namespace
}  // namespace shapegauge
