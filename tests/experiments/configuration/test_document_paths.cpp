// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "shapegauge/experiments/configuration/document_paths.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> matching_texts(const std::vector<std::string>& patterns) {
  const auto document = nlohmann::json::parse(
      R"({"dataset": {"root": "x"}, "shapes": [{"file": "a"}, {"name": "b"}, {"file": "c"}], "groups": {"file": "d"}})");
  std::vector<std::string> texts;
  for (const auto& pointer : matching_pointers(document, patterns)) texts.push_back(pointer.to_string());
  return texts;
}

TEST(MatchingPaths, IncludeOnlyPathsThatExistInTheDocument) {
  EXPECT_THAT(matching_texts({"/dataset"}), ElementsAre("/dataset"));
  EXPECT_THAT(matching_texts({"/dataset/root"}), ElementsAre("/dataset/root"));
  EXPECT_THAT(matching_texts({"/dataset/split", "/absent/root", "/groups/file/x"}), IsEmpty());
}

TEST(MatchingPaths, ReplaceAStarByEachIndexOfAnArray) {
  EXPECT_THAT(matching_texts({"/shapes/*/file"}), ElementsAre("/shapes/0/file", "/shapes/2/file"));
  EXPECT_THAT(matching_texts({"/shapes/*"}), ElementsAre("/shapes/0", "/shapes/1", "/shapes/2"));
  EXPECT_THAT(matching_texts({"/groups/*", "/dataset/*/root"}), IsEmpty()) << "an object is no array";
}

TEST(MatchingPaths, AreInTheOrderOfThePatterns) {
  EXPECT_THAT(matching_texts({"/shapes/*/name", "/groups/file"}), ElementsAre("/shapes/1/name", "/groups/file"));
  EXPECT_THAT(matching_texts({}), IsEmpty());
}

}  // namespace

}  // namespace shapegauge
