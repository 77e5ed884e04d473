// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <string>

#include "shapegauge/datasets/files/classification.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using test::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const Classification animals = {{{"animal", std::nullopt, {}}, {"horse", 0, {"10", "2"}}, {"bird", 0, {"1"}}}};

TEST(Classification, CountsAndListsTheModelsOfItsClasses) {
  EXPECT_EQ(model_count(animals), 3U);
  EXPECT_THAT(models_in_file_order(animals), ElementsAre("10", "2", "1"));
  EXPECT_THAT(models_in_natural_order(animals), ElementsAre("1", "2", "10"));
}

TEST(ClassLabels, MatchModelIdsDespiteNamePrefixOrFileExtension) {
  const std::vector<std::string> ids = {"T1.off", "T2", "10"};
  EXPECT_THAT(class_labels(animals, ids, "x.cla"), ElementsAre(2, 1, 1));
}

TEST(ClassLabels, NameUnknownMissingAndRepeatedModels) {
  const auto error_for = [](const std::vector<std::string>& ids) {
    return test::input_error_of([&] { class_labels(animals, ids, "x.cla"); });
  };
  EXPECT_THAT(error_for({"1", "2", "10", "T3"}), AllOf(HasSubstr("x.cla: "), HasSubstr("\"T3\" is in no class")));
  EXPECT_THAT(error_for({"1", "10"}), AllOf(HasSubstr("x.cla: "), HasSubstr("\"2\" has a class")));
  EXPECT_THAT(error_for({"1", "2", "10", "T2.off"}), HasSubstr("\"T2.off\" is repeated"));
}

constexpr std::string_view valid =
    "PSB 1\n"
    "3 3\n"
    "\n"
    "animal 0 0\n"
    "\n"
    "horse animal 2\n"
    "10\n"
    "2\n"
    "\n"
    "bird animal 1\n"
    "1\n";

std::string classification_error_of(std::string_view text) {
  return test::input_error_of([&] { parse_classification(text, "x.cla"); });
}

TEST(ParseClassification, ReadsClassesModelsAndHierarchy) {
  const Classification expected = {{{"animal", std::nullopt, {}}, {"horse", 0, {"10", "2"}}, {"bird", 0, {"1"}}}};
  EXPECT_EQ(parse_classification(valid, "x.cla"), expected);
}

TEST(ParseClassification, AcceptsAnyWhiteSpaceAndAByteOrderMark) {
  std::string text = "\xEF\xBB\xBF  ";
  for (const char c : valid) text += c == '\n' ? std::string("\t \v\f\r\n") : std::string(1, c);
  EXPECT_EQ(parse_classification(text, "x.cla"), parse_classification(valid, "x.cla"));
  EXPECT_EQ(parse_classification("PSB 1 1 2 a 0 2 x y", "x").classes.front().models.size(), 2U);
}

TEST(ParseClassification, IgnoresLeadingZerosOfCounts) {
  EXPECT_EQ(parse_classification("PSB 1\n01 02\na 0 002\nx\ny\n", "x").classes.front().models.size(), 2U);
}

TEST(ParseClassification, ErrorMessagesGiveTheLineNumber) {
  test::expect_refused(
      {{"", "x.cla:1: the file is empty"},
       {" \n\n ", "x.cla:3: the file is empty"},
       {"OFF\n", "x.cla:1: a classification begins with"},
       {"PSB 2\n", "x.cla:1: version \"2\""},
       {"PSB 1\n", "x.cla:2: the file ends where the number of classes"},
       {"PSB 1\n0 0\n", "x.cla:2: the file has no classes"},
       {"PSB 1\n1 0\na 0 0\n", "x.cla:2: the file has no models"},
       {"PSB 1\n-1 2\n", "x.cla:2: the number of classes"},
       {"PSB 1\n1 2.5\n", "x.cla:2: the number of models"},
       {"PSB 1\n1 99999999999999999999\n", "x.cla:2: the number of models"},
       {"PSB 1\n4000000000 1\na 0 1\nx\n", "x.cla:5: the file ends where the name of class 2 of 4000000000"},
       {"PSB 1\n1 4000000000\na 0 4000000000\nx\n", "x.cla:5: the file ends where model 2 of 4000000000"},
       {"PSB 1\n1 1\na 0 -1\n", "x.cla:3: the number of models"},
       {"PSB 1\n1 2\na 0 3\nx y z\n", "x.cla:3: there are 3 models up to class \"a\""},
       {"PSB 1\n1 3\na 0 2\nx\ny\n", "x.cla:5: the classes have 2 models"},
       {"PSB 1\n1 2\na 0 2\nx\ny\nz\n", "x.cla:6: expected the end of the file after 1 class, found \"z\""},
       {"PSB 1\n2 2\na 0 1\nx\na 0 1\ny\n", "x.cla:5: class \"a\" is repeated"},
       {"PSB 1\n2 2\na b 1\nx\nb 0 1\ny\n", "x.cla:3: the parent \"b\""},
       {"PSB 1\n1 1\na a 1\nx\n", "x.cla:3: the parent \"a\""},
       {"PSB 1\n1 1\n0 0 1\nx\n", "x.cla:3: a class cannot be named 0"},
       {"PSB 1\n1 2\na 0 2\nx\nx\n", "x.cla:5: model \"x\" occurs twice in class \"a\""},
       {"PSB 1\n2 2\na 0 1\n7\nb 0 1\nT7.off\n", "x.cla:6: model \"T7.off\" is in two"}},
      [](const std::string& text) { parse_classification(text, "x.cla"); });
}

TEST(ParseClassification, RejectsEveryFileTruncatedByMoreThanTheFinalNewline) {
  // Complete without the final newline; truncated if any shorter.
  for (std::size_t length = 0; length < valid.size() - 1; ++length) {
    EXPECT_THAT(classification_error_of(valid.substr(0, length)), StartsWith("x.cla:")) << length;
  }
  EXPECT_EQ(classification_error_of(valid.substr(0, valid.size() - 1)), "no error");
}

RC_GTEST_PROP(ParseClassification, ReadsDamagedTextOrRejectsItWithAOneLineError, ()) {
  std::string text(valid);
  const auto changes = *rc::gen::inRange(1, 6);
  for (int i = 0; i < changes; ++i) {
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
    text[at] = *rc::gen::oneOf(rc::gen::element(' ', '\n', '0', '9', '-', 'a', '\0'), rc::gen::arbitrary<char>());
  }
  const std::string error = classification_error_of(text);
  RC_ASSERT(error == "no error" || error.starts_with("x.cla:"));
  RC_ASSERT(error.find('\n') == std::string::npos);
}

TEST(WriteClassification, FileIsReadBackUnchanged) {
  const TemporaryFolder folder;
  const Classification classification = parse_classification(valid, "x.cla");
  write_classification(folder.path() / "y.cla", classification);
  EXPECT_EQ(test::bytes_of(folder.path() / "y.cla"), valid);
  EXPECT_EQ(read_classification(folder.path() / "y.cla"), classification);
}

TEST(WriteClassification, RejectsNamesThatTheFormatCannotExpress) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "y.cla";
  const std::array cases = {
      Classification{{{"a b", std::nullopt, {"x"}}}},
      Classification{{{"", std::nullopt, {"x"}}}},
      Classification{{{"a", std::nullopt, {"x", ""}}}},
      Classification{{{"a", std::nullopt, {"x y"}}}},
      Classification{{{"0", std::nullopt, {"x"}}}},
      Classification{{{"a", 7, {"x"}}}},
      Classification{{{"a", 1, {"x"}}, {"b", std::nullopt, {"y"}}}},
      Classification{{{"a", std::nullopt, {"x"}}, {"a", std::nullopt, {"y"}}}},
      Classification{{{"a", std::nullopt, {"x"}}, {"b", std::nullopt, {"x"}}}},
      Classification{{{"a", std::nullopt, {}}}},
      Classification{},
  };
  for (const Classification& bad : cases) {
    EXPECT_THAT(test::input_error_of([&] { write_classification(path, bad); }),
                StartsWith("cannot write " + path.string()));
  }
  EXPECT_EQ(folder.size(), 0U);
}

// The original labels, if available: 30 classes of 20, models 0 to 599.
TEST(ReadClassification, ReadsTheLabelsOfShrec11) {
  const char* const data = std::getenv("SHAPEGAUGE_DATA");
  if (data == nullptr) GTEST_SKIP() << "SHAPEGAUGE_DATA does not name the folder of the real data";
  const auto path = std::filesystem::path(data) / "shrec11_labels" / "test.cla";
  const Classification classification = read_classification(path);
  ASSERT_EQ(classification.classes.size(), 30U);
  for (const ModelClass& model_class : classification.classes) EXPECT_EQ(model_class.models.size(), 20U);
  const auto models = models_in_natural_order(classification);
  for (std::size_t i = 0; i < models.size(); ++i) EXPECT_EQ(models[i], std::to_string(i));
}

}  // namespace

}  // namespace shapegauge
