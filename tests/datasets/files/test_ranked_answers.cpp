// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapegauge/datasets/files/ranked_answers.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

TEST(RankedAnswers, OrderTrecRunsByScore) {
  const RankedAnswers run = parse_trec_run("q1 Q0 a 2 0.5 me\nq2 Q0 b 1 7 me\n\nq1\tQ0  c 1 -1e2 me\r\n", "r");
  ASSERT_EQ(run.answers.size(), 2U);
  EXPECT_EQ(run.answers[0].query, "q1");
  EXPECT_THAT(run.answers[0].models, ElementsAre(Pair("a", -0.5), Pair("c", 100)));
}

TEST(RankedAnswers, CountListsWhoseScoresRiseWithTheRank) {
  const auto reversed = [](const char* text) { return parse_trec_run(text, "r").reversed; };
  EXPECT_EQ(reversed("q Q0 a 1 0.1 r\nq Q0 b 2 0.1 r\nq Q0 c 3 0.2 r\np Q0 a 1 5 r\np Q0 b 2 4 r\n"), 1U);
  EXPECT_EQ(reversed("q Q0 b 2 0.2 r\nq Q0 a 1 0.1 r\n"), 1U) << "in any order of lines";
  EXPECT_EQ(reversed("q Q0 a 1 0.1 r\nq Q0 b 2 0.3 r\nq Q0 c 3 0.2 r\n"), 0U);
  EXPECT_EQ(reversed("q Q0 a 0 0.1 r\nq Q0 b 0 0.2 r\n"), 0U) << "without ranks";
  EXPECT_EQ(reversed("q Q0 a 1 1 r\nq Q0 b 2 1 r\np Q0 a 1 1 r\n"), 0U) << "without an order of scores";
}

TEST(RankedAnswers, KeepTheOrderOfRankedLists) {
  const RankedAnswers lists = parse_ranked_lists("q1 c a,b\n q2, a\n", "l");
  ASSERT_EQ(lists.answers.size(), 2U);
  EXPECT_THAT(lists.answers[0].models, ElementsAre(Pair("c", 1), Pair("a", 2), Pair("b", 3)));
}

TEST(RankedAnswers, AreReadFromAFolderWithOneFilePerQuery) {
  const test::TemporaryFolder folder;
  test::write_text(folder.path() / "10", "2 0.5\n10 0.7\n");
  test::write_text(folder.path() / "2", "7\r\n\n10\r\n");
  test::write_text(folder.path() / ".hidden", "x\n");
  ASSERT_TRUE(is_ranked_answers_file(folder.path()));
  const RankedAnswers lists = read_ranked_answers(folder.path());
  ASSERT_EQ(lists.answers.size(), 2U);
  EXPECT_EQ(lists.answers[0].query, "2");
  EXPECT_THAT(lists.answers[0].models, ElementsAre(Pair("7", 1), Pair("10", 2)));
  EXPECT_THAT(lists.answers[1].models, ElementsAre(Pair("2", 1), Pair("10", 2)));
}

TEST(RankedAnswers, RejectEmptyFoldersSubfoldersAndRepeatedModels) {
  const test::TemporaryFolder folder;
  const auto error = [&] { return test::input_error_of([&] { read_ranked_answers(folder.path()); }); };
  EXPECT_THAT(error(), HasSubstr("no ranked lists"));
  test::write_text(folder.path() / "2", "7 1\n8 2\n7 3\n");
  EXPECT_THAT(error(), HasSubstr("2:3: repeated model \"7\""));
  test::write_text(folder.path() / "2", "7 1\n");
  std::filesystem::create_directory(folder.path() / "test_normal");
  EXPECT_THAT(error(), HasSubstr("\"test_normal\""));
}

TEST(RelevanceJudgements, ListModelsOfPositiveGradeAsRelevant) {
  const Judgements judgements = parse_qrels("q1 0 a 1\nq1 0 b 0\nq2 0 a -1\nq1 0 c 2\n", "j");
  ASSERT_EQ(judgements.queries.size(), 2U);
  EXPECT_THAT(judgements.queries[0].relevant, ElementsAre("a", "c"));
  EXPECT_TRUE(judgements.queries[1].relevant.empty());
  EXPECT_TRUE(judgements.graded);
  EXPECT_FALSE(parse_qrels("q1 0 a 1\n", "j").graded);
  EXPECT_TRUE(parse_qrels("q1 0 a 2\nq1 0 b 1\n", "j").graded);  // wherever a grade above 1 occurs
}

TEST(RankedAnswers, AcceptCommentsInTrecFiles) {
  const Judgements judgements = parse_qrels("# query iteration model\nq1 0 a 1\n#\n#1 0 b 1\n", "j");
  ASSERT_EQ(judgements.queries.size(), 2U);
  EXPECT_EQ(judgements.queries[1].query, "#1") << "four words are a judgement";
  EXPECT_EQ(parse_trec_run("# made by mine\nq Q0 a 1 2 t\n", "r").answers.size(), 1U);
  const test::TemporaryFolder folder;
  EXPECT_TRUE(is_ranked_answers_file(folder.file("run.txt", "# made by mine\nq1 Q0 a 1 2 mine\n")));
}

TEST(RankedAnswers, ErrorMessagesGiveTheLineNumber) {
  test::expect_refused({{"q Q0 a 1 0.5\n", "r:1: found 5"},
                        {"q Q0 a 1 nan t\n", "r:1: the score \"nan\""},
                        {"q Q0 a 1 1 t\nq Q0 a 2 0 t\n", "r:2: repeated model \"a\""},
                        {"\n \n", "r: the file"}},
                       [](const std::string& text) { parse_trec_run(text, "r"); });
  test::expect_refused(
      {{"q\n", "l:1: "}, {"q a\nq b\n", "l:2: repeated query \"q\""}, {"q a a\n", "l:1: repeated model"}},
      [](const std::string& text) { parse_ranked_lists(text, "l"); });
  test::expect_refused({{"q 0 a yes\n", "j:1: the grade \"yes\""},
                        {"q 0 a\n", "j:1: found 3"},
                        {"q 0 a 1\nq 0 a 0\n", "j:2: repeated model \"a\""}},
                       [](const std::string& text) { parse_qrels(text, "j"); });
}

TEST(RankedAnswers, HaveTheRunNameOfATrecFile) {
  EXPECT_EQ(parse_trec_run("q1 Q0 a 1 2 mine\nq2 Q0 a 1 2 mine\n", "r").name, "mine");
  EXPECT_EQ(parse_trec_run("q1 Q0 a 1 2 mine\nq2 Q0 a 1 2 yours\n", "r").name, "");
}

TEST(RelevanceJudgements, ContainPositiveGradesAndListGradeZeroAsNonRelevant) {
  const Judgements judgements = parse_qrels("q1 0 a 1\nq1 0 b 0\nq1 0 c 2\nq1 0 d -1\n", "j");
  EXPECT_THAT(judgements.queries[0].grades, ElementsAre(1, 2));
  EXPECT_THAT(judgements.queries[0].irrelevant, ElementsAre("b")) << "d was not judged";
}

TEST(RankedAnswers, FilesAreDetectedByNameOrFirstLine) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(is_ranked_answers_file("a.run"));
  EXPECT_TRUE(is_ranked_answers_file("a.LISTS"));
  EXPECT_TRUE(is_ranked_answers_file(folder.file("run.txt", "q1 Q0 a 1 2 mine\n")));
  EXPECT_FALSE(is_ranked_answers_file(folder.file("matrix.txt", "0 1 2 3 4 5\n1 0 2 3 4 5\n")));
  EXPECT_FALSE(is_ranked_answers_file("a.npy"));
}

}  // namespace

}  // namespace shapegauge
