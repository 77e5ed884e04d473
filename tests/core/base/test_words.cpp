// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "shapegauge/core/base/words.h"

namespace shapegauge {

namespace {

enum class Season { spring, summer, autumn };

}  // namespace

template <>
inline constexpr std::array<std::string_view, 3> words_of<Season>{"spring", "summer", "autumn"};

namespace {

TEST(EnumerationWords, MatchTheEnumeratorsInOrder) {
  EXPECT_EQ(word_of(Season::spring), "spring");
  EXPECT_EQ(word_of(Season::autumn), "autumn");
  EXPECT_EQ(value_of_word<Season>("summer"), Season::summer);
  EXPECT_EQ(value_of_word<Season>("winter"), std::nullopt);
  EXPECT_EQ(value_of_word<Season>(""), std::nullopt);
  EXPECT_THAT(list_of_words<Season>(), testing::ElementsAre("spring", "summer", "autumn"));
}

}  // namespace

}  // namespace shapegauge
