// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <thread>
#include <vector>

#include "shapegauge/core/base/registry.h"

namespace shapegauge {
namespace {

using testing::ElementsAre;
using testing::ThrowsMessage;

struct Colour {
  std::string name;
  int wavelength = 0;
};

struct Mixture {
  std::string name;
  int (*mix)(int) = nullptr;
  std::function<int(int)> separate;
};

void check_visible(const Colour& colour) {
  if (colour.wavelength < 380 || colour.wavelength > 750) throw ArgumentError("cannot be seen: " + colour.name);
}

TEST(Registry, ListsBuiltInEntriesBeforeUserDefinedEntries) {
  Registry<Colour> colours("colour", {{"red", 700}, {"green", 530}}, has_functions<>);
  colours.add({"blue", 470});
  EXPECT_THAT(colours.names(), ElementsAre("red", "green", "blue"));
  EXPECT_EQ(colours.at("blue").wavelength, 470);
  EXPECT_EQ(colours.find("green")->wavelength, 530);
  EXPECT_EQ(colours.find("violet"), nullptr);
  EXPECT_EQ(colours.find_if([](const Colour& colour) { return colour.wavelength < 600; })->name, "green");
}

TEST(Registry, RejectsEntriesWithEmptyDuplicateOrInvalidNames) {
  Registry<Colour> colours("colour", {{"red", 700}}, has_functions<>, check_visible);
  EXPECT_THROW(colours.add({"", 500}), InputError);
  EXPECT_THROW(colours.add({"red", 690}), InputError);
  EXPECT_THROW(colours.add({"infrared", 900}), ArgumentError);
  EXPECT_THAT(colours.names(), ElementsAre("red"));
  EXPECT_EQ(colours.at("red").wavelength, 700);
}

TEST(Registry, RejectsEntriesWithoutTheirMandatoryFunctions) {
  Registry<Mixture> mixtures("mixture", {}, has_functions<&Mixture::mix, &Mixture::separate>);
  const auto twice = [](int parts) { return 2 * parts; };
  EXPECT_THAT([&] { mixtures.add({.name = "grey", .mix = nullptr, .separate = twice}); },
              ThrowsMessage<ArgumentError>(R"(the mixture "grey" lacks a mandatory function)"));
  EXPECT_THROW(mixtures.add({.name = "grey", .mix = twice, .separate = {}}), ArgumentError);
  mixtures.add({.name = "grey", .mix = twice, .separate = twice});
  EXPECT_THAT(mixtures.names(), ElementsAre("grey"));
}

TEST(Registry, SuggestsTheNearestName) {
  const Registry<Colour> colours("colour", {{"red", 700}, {"green", 530}}, has_functions<>);
  EXPECT_THAT([&] { return colours.at("gren"); },
              ThrowsMessage<InputError>(R"(there is no colour "gren"; did you mean "green"?)"));
  EXPECT_THAT([&] { return colours.at("ultramarine"); },
              ThrowsMessage<InputError>(R"(there is no colour "ultramarine"; known here: "red", "green")"));
}

TEST(Registry, EntriesKeepTheirAddressesWhileThreadsAddOthers) {
  Registry<Colour> colours("colour", {{"red", 700}}, has_functions<>);
  const Colour& red = colours.at("red");
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&colours, i] {
      for (int k = 0; k < 100; ++k) {
        colours.add({std::to_string(i) + "/" + std::to_string(k), 400});
        EXPECT_EQ(colours.entries().front().get().name, "red");
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(colours.names().size(), 401U);
  EXPECT_EQ(&colours.at("red"), &red);
  EXPECT_EQ(red.wavelength, 700);
}

}  // namespace
}  // namespace shapegauge
