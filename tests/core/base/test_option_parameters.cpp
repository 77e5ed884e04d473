// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/option_parameters.h"

namespace shapegauge {

namespace {

struct SampleOptions {
  int count = 3;
  double share = 0.5;
  bool enabled = true;
  IntegerList sizes = {2, 4};
};

constexpr std::array<std::string_view, 1> automatic{"auto"};

constexpr std::array sample_table = {
    option_of<&SampleOptions::count>("count", {.low = 1, .high = 9}, "How many."),
    option_of<&SampleOptions::share>("share", {.low = 0, .high = 1, .high_open = true}, "How much."),
    option_of<&SampleOptions::enabled>("enabled", "Whether at all."),
    option_of<&SampleOptions::sizes>("sizes", {.low = 1, .high = 9}, "Of each.", automatic),
};
constexpr auto sample_parameters = parameters_of(sample_table);

enum class Colouring { red, green, blue };

}  // namespace

template <>
inline constexpr std::array<std::string_view, 3> words_of<Colouring>{"red", "green", "blue"};

namespace {

struct InnerOptions {
  int count = 5;
};

constexpr std::array inner_table = {
    without_default(option_of<&InnerOptions::count>("inner_count", {.low = 1, .high = 9}, "How many.")),
};

struct WordOptions {
  Colouring colour = Colouring::green;
  InnerOptions inner = {};
};

constexpr std::array word_table = {
    option_of<&WordOptions::colour>("colour", "Which."),
    nested_option<&WordOptions::inner, inner_table, 0>(),
};
constexpr auto word_parameters = parameters_of(word_table);

TEST(OptionParameters, TakeTypesAndDefaultsFromTheOptionStructure) {
  EXPECT_EQ(sample_parameters[0].kind, ParameterKind::integer);
  EXPECT_EQ(sample_parameters[1].kind, ParameterKind::number);
  EXPECT_EQ(sample_parameters[2].kind, ParameterKind::boolean);
  const ParameterValues values(sample_parameters);
  EXPECT_EQ(values.integer("count"), 3);
  EXPECT_EQ(values.number("share"), 0.5);
  EXPECT_TRUE(values.boolean("enabled"));
}

TEST(OptionParameters, ConvertChangedValuesToAnOptionStructure) {
  ParameterValues values(sample_parameters);
  values.set("count", std::int64_t{7});
  values.set("enabled", false);
  const SampleOptions options = options_from(sample_table, values);
  EXPECT_EQ(options.count, 7);
  EXPECT_EQ(options.share, 0.5);
  EXPECT_FALSE(options.enabled);
  EXPECT_THROW(values.set("count", std::int64_t{10}), InputError);
}

TEST(OptionParameters, WriteEnumerationsAsWords) {
  EXPECT_EQ(word_parameters[0].kind, ParameterKind::choice);
  EXPECT_TRUE(word_parameters[1].required());
  ParameterValues values(word_parameters);
  EXPECT_EQ(values.word("colour"), "green");
  values.set("colour", "blue");
  values.set("inner_count", std::int64_t{8});
  const WordOptions options = options_from(word_table, values);
  EXPECT_EQ(options.colour, Colouring::blue);
  EXPECT_EQ(options.inner.count, 8);
  EXPECT_THROW(values.set("colour", "grey"), InputError);
  EXPECT_EQ(legal_values(word_parameters[0]), "one of red, green, blue");
  EXPECT_THROW(check_options("x", word_table, {.inner = {.count = 0}}), InputError);
}

TEST(OptionParameters, AcceptListsOfOneOrSeveralNumbersOrAuto) {
  ParameterValues values(sample_parameters);
  const auto sizes = [&] { return options_from(sample_table, values).sizes; };
  EXPECT_EQ(sizes(), (IntegerList{2, 4}));
  values.set("sizes", std::int64_t{7});
  EXPECT_EQ(sizes(), IntegerList(7));
  values.set("sizes", IntegerList{9, 1, 9});
  EXPECT_EQ(sizes(), (IntegerList{9, 1, 9}));
  values.set("sizes", automatic[0]);
  EXPECT_TRUE(sizes().empty());
  EXPECT_NO_THROW(check_options("x", sample_table, {.sizes = {}}));
  EXPECT_THROW(check_options("x", sample_table, {.sizes = {1, 10}}), InputError);
  EXPECT_THROW(values.set("sizes", IntegerList{0}), InputError);
  EXPECT_THROW(IntegerList(std::vector<std::int64_t>(17, 1)), ArgumentError);
}

TEST(OptionParameters, AreFoundByNameAndCanBeCopiedWithAnotherDescription) {
  EXPECT_EQ(parameter_named("share", sample_table).bounds.high, 1);
  EXPECT_EQ(parameter_named("sizes", sample_table).kind, ParameterKind::integers);
  constexpr auto count = with_description("Another one.", sample_table[0]);
  EXPECT_EQ(count.parameter.description, "Another one.");
  EXPECT_EQ(count.parameter.bounds.high, 9);
}

TEST(OptionParameters, ConvertOptionsToValuesAndBack) {
  const SampleOptions options{.count = 4, .share = 0.25, .enabled = false, .sizes = {5}};
  const ParameterValues values = values_of(sample_parameters, sample_table, options);
  EXPECT_EQ(values.integer("count"), 4);
  const SampleOptions again = options_from(sample_table, values);
  EXPECT_EQ(again.share, 0.25);
  EXPECT_FALSE(again.enabled);
  EXPECT_EQ(again.sizes, IntegerList(5));
  EXPECT_THROW(values_of(sample_parameters, sample_table, {.count = 0}), InputError);
}

TEST(OptionParameters, RejectOptionsOutOfBounds) {
  EXPECT_NO_THROW(check_options("x", sample_table, SampleOptions{}));
  EXPECT_THROW(check_options("x", sample_table, {.count = 0}), InputError);
  EXPECT_THROW(check_options("x", sample_table, {.share = 1}), InputError);
  EXPECT_THROW(check_options("x", sample_table, {.share = std::nan("")}), InputError);
}

}  // namespace

}  // namespace shapegauge
