// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <optional>
#include <rapidcheck/gtest.h>
#include <string>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/scanner.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;
using testing::StartsWith;

const std::string scanned_name = "some.txt";

std::vector<std::string> scanned_words(const std::string& text) {
  TextScanner scanner(text, scanned_name);
  std::vector<std::string> words;
  for (std::string_view word = scanner.read_word(); !word.empty(); word = scanner.read_word()) words.emplace_back(word);
  EXPECT_TRUE(scanner.at_end());
  return words;
}

/// The words of a text by the definition, a character at a time.
std::vector<std::string> literal_words(const std::string& text) {
  std::vector<std::string> words;
  std::string word;
  bool is_comment = false;
  for (const char c : text + "\n") {
    const bool is_space = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (is_comment) {
      is_comment = c != '\n' && c != '\r';
    } else if (c == '#' && word.empty()) {
      is_comment = true;
    } else if (!is_space) {
      word += c;
    } else if (!word.empty()) {
      words.push_back(word);
      word.clear();
    }
  }
  return words;
}

TEST(TextScanner, SplitsWordsAtBlanksAndComments) {
  EXPECT_THAT(scanned_words("one  two\t# three\n\r\n four#4\r#five\r\nsix"),
              ElementsAre("one", "two", "four#4", "six"));
  EXPECT_THAT(scanned_words("\xEF\xBB\xBFone"), ElementsAre("one")) << "after a byte order mark";
  EXPECT_TRUE(scanned_words("").empty());
  EXPECT_TRUE(scanned_words("# nothing").empty());
}

RC_GTEST_PROP(TextScanner, WordsMatchASplitCharacterByCharacter, ()) {
  const auto text = *rc::gen::container<std::string>(rc::gen::element('a', '1', '#', ' ', '\t', '\n', '\r'));
  RC_ASSERT(scanned_words(text) == literal_words(text));
}

/// The number that a text begins with; nothing if it is refused.
std::optional<double> number_of(const std::string& text) {
  TextScanner scanner(text, scanned_name);
  double value = 0;
  try {
    EXPECT_TRUE(scanner.read_number(value, "a number"));
  } catch (const InputError&) {
    return std::nullopt;
  }
  return value;
}

std::optional<std::int64_t> integer_of(const std::string& text) {
  TextScanner scanner(text, scanned_name);
  std::int64_t value = 0;
  try {
    EXPECT_TRUE(scanner.read_integer(value, "a count"));
  } catch (const InputError&) {
    return std::nullopt;
  }
  return value;
}

TEST(TextScanner, AcceptsFiniteDecimalNumbersOnly) {
  EXPECT_EQ(number_of("1.5"), 1.5);
  EXPECT_EQ(number_of(" # first\n-.25e1 7"), -2.5);
  EXPECT_EQ(number_of("+3"), 3);
  EXPECT_EQ(number_of("5#comment"), 5);
  EXPECT_EQ(number_of("5."), 5);
  EXPECT_EQ(number_of("1e-400"), 0) << "too small";
  EXPECT_EQ(number_of("-1e-400"), 0);
  for (const char* text :
       {"x", "1,5", "1.5x", "0x10", "+-1", "--1", "1.#QNAN", "nan", "inf", "-inf", "1e400", "e5", ".", "-"}) {
    EXPECT_EQ(number_of(text), std::nullopt) << text;
  }
}

TEST(TextScanner, RejectsFractionsAsIntegers) {
  EXPECT_EQ(integer_of("7"), 7);
  EXPECT_EQ(integer_of("+7 8"), 7);
  EXPECT_EQ(integer_of("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
  for (const char* text : {"7.0", "7e1", "9223372036854775808", "x", "+-7", "7x"}) {
    EXPECT_EQ(integer_of(text), std::nullopt) << text;
  }
}

RC_GTEST_PROP(TextScanner, RestoresWrittenNumbersExactly, (const std::vector<double>& numbers, std::int64_t last)) {
  std::string text;
  for (const double number : numbers) text += fmt::format("{}{}", number, *rc::gen::element(" ", "\r\n", "#c\n", "\t"));
  text += std::to_string(last);
  TextScanner scanner(text, scanned_name);
  for (const double number : numbers) {
    double value = std::nan("");
    RC_ASSERT(scanner.read_number(value, "a number"));
    RC_ASSERT(value == number);
  }
  std::int64_t value = 0;
  RC_ASSERT(scanner.read_integer(value, "a number"));
  RC_ASSERT(value == last);
  double none = 0;
  RC_ASSERT(!scanner.read_number(none, "a number"));
  RC_ASSERT(!scanner.read_integer(value, "a number"));
}

TEST(TextScanner, ErrorsNameTheLine) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const std::string text = "1" + end + "# two" + end + end + "  4 x" + end + "5";
    TextScanner scanner(text, scanned_name);
    double value = 0;
    ASSERT_TRUE(scanner.read_number(value, "a number"));
    EXPECT_THAT(test::input_error_of([&] { scanner.fail("wrong"); }), StartsWith("some.txt:1: "));
    ASSERT_TRUE(scanner.read_number(value, "a number"));
    const std::size_t four = scanner.word_offset();
    EXPECT_EQ(text[four], '4');
    EXPECT_THAT(test::input_error_of([&] { scanner.read_number(value, "a number"); }), StartsWith("some.txt:4: "));
    ASSERT_TRUE(scanner.skip_words(2));
    EXPECT_THAT(test::input_error_of([&] { scanner.fail("wrong"); }), StartsWith("some.txt:5: "));
    EXPECT_THAT(test::input_error_of([&] { scanner.fail_at(four, "wrong"); }), StartsWith("some.txt:4: "));
    EXPECT_THAT(test::input_error_of([&] { scanner.fail_whole("wrong"); }), StartsWith("some.txt: "));
  }
}

TEST(TextScanner, ErrorsQuoteAtMostTheStartOfLongWords) {
  const std::string text(100'000, 'x');
  EXPECT_LT(test::input_error_of([&] {
              TextScanner scanner(text, scanned_name);
              double value = 0;
              scanner.read_number(value, "a number");
            }).size(),
            1000U);
}

TEST(TextScanner, DetectsTheEndOfALine) {
  const std::string text = "a b \t# more\n\nc\r\nd";
  TextScanner scanner(text, scanned_name);
  EXPECT_EQ(scanner.read_word(), "a");
  EXPECT_FALSE(scanner.at_line_end());
  EXPECT_EQ(scanner.read_word(), "b");
  EXPECT_TRUE(scanner.at_line_end());
  EXPECT_EQ(scanner.read_word(), "c");
  EXPECT_TRUE(scanner.at_line_end());
  scanner.skip_line();
  EXPECT_FALSE(scanner.at_end());
  EXPECT_EQ(scanner.read_word(), "d");
  EXPECT_TRUE(scanner.at_line_end());
  EXPECT_TRUE(scanner.at_end());
}

TEST(TextScanner, SkipsTheRequestedNumberOfWordsOrCharacters) {
  const std::string text = "one two three\nfour";
  TextScanner scanner(text, scanned_name);
  EXPECT_EQ(scanner.remaining(), text.size());
  ASSERT_TRUE(scanner.skip_words(2));
  EXPECT_EQ(scanner.rest(), " three\nfour");
  scanner.advance(7);
  EXPECT_EQ(scanner.word_offset(), 7U);
  EXPECT_EQ(scanner.read_word(), "four");
  EXPECT_EQ(scanner.remaining(), 0U);
  EXPECT_TRUE(scanner.skip_words(0));
  EXPECT_FALSE(scanner.skip_words(1));
}

TEST(ByteScanner, ReadsBothByteOrders) {
  using namespace std::string_literals;
  const std::string bytes = "\x01\x02\x03\x04\xFF\x3F\x80\x00\x00"s;
  ByteScanner big(bytes, std::endian::big);
  std::uint16_t first = 0;
  std::uint16_t second = 0;
  std::int8_t third = 0;
  float fourth = 0;
  ASSERT_TRUE(big.read(first) && big.read(second) && big.read(third) && big.read(fourth));
  EXPECT_EQ(first, 0x0102);
  EXPECT_EQ(second, 0x0304);
  EXPECT_EQ(third, -1);
  EXPECT_EQ(fourth, 1.0F);
  EXPECT_EQ(big.remaining(), 0U);
  ByteScanner little(bytes, std::endian::little);
  std::uint32_t all = 0;
  ASSERT_TRUE(little.read(all));
  EXPECT_EQ(all, 0x04030201U);
}

TEST(ByteScanner, DoesNotReadBeyondTheEnd) {
  const std::string bytes = "\x01\x02\x03";
  ByteScanner scanner(bytes, std::endian::little);
  std::uint32_t four = 7;
  EXPECT_FALSE(scanner.read(four));
  EXPECT_EQ(four, 7U);
  EXPECT_FALSE(scanner.skip(4));
  EXPECT_FALSE(scanner.skip(std::numeric_limits<std::uint64_t>::max()));
  EXPECT_EQ(scanner.remaining(), 3U);
  EXPECT_TRUE(scanner.skip(1));
  std::uint16_t two = 0;
  EXPECT_TRUE(scanner.read(two));
  EXPECT_EQ(two, 0x0302);
  EXPECT_TRUE(scanner.skip(0));
}

}  // namespace

}  // namespace shapegauge
