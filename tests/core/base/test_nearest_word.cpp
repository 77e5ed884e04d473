// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <vector>

#include "shapegauge/core/base/nearest_word.h"

namespace shapegauge {

namespace {

TEST(EditDistance, CountsInsertionsDeletionsAndReplacements) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("offset", "offset"), 0U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
}

TEST(EditDistance, CountsASwapOfAdjacentLettersAsOneEdit) { EXPECT_EQ(edit_distance("filed", "field"), 1U); }

TEST(EditDistance, IgnoresCase) { EXPECT_EQ(edit_distance("Embree", "EMBREE"), 0U); }

RC_GTEST_PROP(EditDistance, IsSymmetricAndBoundedByTheLongerWord, (const std::string& a, const std::string& b)) {
  RC_ASSERT(edit_distance(a, b) == edit_distance(b, a));
  RC_ASSERT(edit_distance(a, b) <= std::max(a.size(), b.size()));
  RC_ASSERT(edit_distance(a, a) == 0U);
}

const std::vector<std::string> settings{"bins", "range", "smoothing_bins"};

TEST(NearestWord, CorrectsASpellingMistake) {
  EXPECT_EQ(nearest_word("bin", settings), "bins");
  EXPECT_EQ(nearest_word("smoothing", settings), std::nullopt);
  EXPECT_EQ(nearest_word("smooting_bin", settings), "smoothing_bins");
}

TEST(NearestWord, IsNotFoundIfNoKnownWordIsSimilar) { EXPECT_EQ(nearest_word("colour", settings), std::nullopt); }

TEST(NearestWord, DoesNotReplaceAllLettersOfAShortWord) {
  EXPECT_EQ(nearest_word("xy", std::vector<std::string>{"l1", "at"}), std::nullopt);
}

TEST(NearestWord, SkipsVeryLongWords) {
  const std::string endless(1'000'000, 'x');
  EXPECT_EQ(nearest_word(endless, std::vector<std::string>{endless + 'y'}), std::nullopt);
}

TEST(Suggestion, NamesTheNearestWordOrAllKnownWords) {
  EXPECT_EQ(suggestion("rnage", settings), "; did you mean \"range\"?");
  EXPECT_EQ(suggestion("colour", settings), "; known here: \"bins\", \"range\", \"smoothing_bins\"");
  EXPECT_EQ(suggestion("colour", {}), "");
}

TEST(UnknownWordMessage, NamesTheKindOfTheUnknownWordAndCutsLongWords) {
  EXPECT_EQ(unknown_word_message("setting", "rnage", settings),
            "there is no setting \"rnage\"; did you mean \"range\"?");
  EXPECT_EQ(unknown_word_message("setting", std::string(50, 'x'), {}),
            "there is no setting \"" + std::string(40, 'x') + "\"");
}

}  // namespace

}  // namespace shapegauge
