// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tuple>

#include "shapegauge/experiments/leaderboard/judge_submissions.h"
#include "tests/experiments/leaderboard/small_board.h"

namespace shapegauge {

namespace {

using test_board::small_matrix;
using test_board::SmallBoard;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> names_of(const Leaderboard& board) {
  std::vector<std::string> names;
  for (const EvaluatedSubmission& judged : board.submissions) names.push_back(judged.submission.name);
  return names;
}

/// Reason for rejecting the only rejected submission.
std::string refusal_of(const SmallBoard& small) {
  const Leaderboard board = small.judged();
  EXPECT_EQ(board.submissions.size(), 2U) << "the good ones are judged all the same";
  return board.refused.size() == 1 ? board.refused[0].reason : "not one refusal";
}

class JudgeSubmissions : public test::FolderTest {
 protected:
  const SmallBoard small;
};

TEST_F(JudgeSubmissions, ScoresMatchTheEvaluationOfEachFile) {
  const Leaderboard board = small.judged();
  EXPECT_THAT(names_of(board), ElementsAre("good", "poor"));
  EvaluationFiles files = small.options().files;
  files.matrix = small.submissions() / "poor.csv";
  const Evaluation alone = evaluate_files(files, {}).evaluation;
  EXPECT_EQ(board.submissions[1].evaluation.micro, alone.micro);
  EXPECT_EQ(board.measures, alone.measures);
  EXPECT_DOUBLE_EQ(board.micro[board.rank_by][0].average, 1);
  EXPECT_EQ(board.macro[0][1].average, alone.macro[0]);
  EXPECT_EQ(board.labels.size(), 12U);
  EXPECT_TRUE(board.refused.empty());
}

TEST_F(JudgeSubmissions, ReadsSimilaritiesIfTheDescriptionDeclaresThem) {
  small.add("alike.csv", small_matrix(0, -1));
  small.add("alike.json", R"({"name": "Alike", "similarity": true})");
  const Leaderboard board = small.judged();
  EXPECT_TRUE(board.refused.empty());
  EXPECT_THAT(names_of(board), ElementsAre("Alike", "good", "poor"));
  EXPECT_DOUBLE_EQ(board.micro[0][0].average, 1);
}

TEST_F(JudgeSubmissions, RejectsApparentSimilaritiesNotDeclaredInADescription) {
  small.add("alike.csv", small_matrix(0, -1));
  EXPECT_THAT(refusal_of(small), HasSubstr("similarities given as distances"));
  small.add("alike.json", R"({"similarity": false})");
  const Leaderboard board = small.judged();
  ASSERT_EQ(board.submissions.size(), 3U);
  EXPECT_THAT(board.submissions[2].warnings, testing::Not(testing::IsEmpty()));
}

TEST_F(JudgeSubmissions, RejectsUnusableFilesAndEvaluatesOtherSubmissions) {
  std::string with_nan = small_matrix(0);
  with_nan.replace(with_nan.find(",2,"), 3, ",nan,");
  for (const auto& [name, text, word] : {std::tuple("nan.csv", with_nan, "row 0"),
                                         {"three.csv", "0,1,2\n1,0,2\n2,2,0\n", "12"},
                                         {"ids.lists", "m0 m3 m6\nm1 stranger\n", "stranger"},
                                         {"broken.npy", "no numbers", ".npy"}}) {
    const SmallBoard fresh;
    fresh.add(name, text);
    EXPECT_THAT(refusal_of(fresh), HasSubstr(word));
  }
}

TEST_F(JudgeSubmissions, CountsMissingQueriesAsZeroAndWarnsOfShortRankedLists) {
  std::string lists;  // three queries, each with the three others of its class
  for (const int query : {0, 1, 2}) {
    lists += fmt::format("m{}", query);
    for (int i = query + 3; i < 12; i += 3) lists += fmt::format(" m{}", i);
    lists += "\n";
  }
  small.add("few.lists", lists);
  const Leaderboard board = small.judged();
  ASSERT_EQ(board.submissions.size(), 3U);
  const std::vector<std::string> names = names_of(board);
  const auto few = static_cast<std::size_t>(std::ranges::find(names, "few") - names.begin());
  ASSERT_LT(few, names.size());
  EXPECT_DOUBLE_EQ(board.micro[0][few].average, 3.0 / 12);
  EXPECT_THAT(board.submissions[few].warnings, testing::Contains(HasSubstr("3 of 12 models")));
}

TEST_F(JudgeSubmissions, MatchesModelsByIds) {
  std::string matrix = "id";  // models in reverse order
  for (int i = 11; i >= 0; --i) matrix += fmt::format(",m{}", i);
  matrix += "\n";
  for (int i = 11; i >= 0; --i) {
    matrix += fmt::format("m{}", i);
    for (int j = 11; j >= 0; --j) matrix += fmt::format(",{}", i == j ? 0 : i % 3 == j % 3 ? 1 : 2);
    matrix += "\n";
  }
  small.add("backwards.csv", matrix);
  const Leaderboard board = small.judged();
  ASSERT_EQ(board.submissions.size(), 3U);
  EXPECT_EQ(board.submissions[0].submission.name, "backwards");
  EXPECT_DOUBLE_EQ(board.micro[0][0].average, 1);
}

TEST_F(JudgeSubmissions, GivesSubmissionsUniqueNames) {
  small.add("again.csv", small_matrix(0));
  small.add("again.json", R"({"name": "good"})");
  const Leaderboard board = small.judged();
  ASSERT_EQ(board.submissions.size(), 3U);
  EXPECT_NE(board.submissions[0].submission.name, board.submissions[1].submission.name);
  EXPECT_THAT(board.submissions[1].warnings, testing::Contains(HasSubstr("same bytes")));
}

TEST_F(JudgeSubmissions, RanksASingleSubmissionFirst) {
  std::filesystem::remove(small.submissions() / "poor.csv");
  const Leaderboard board = small.judged();
  ASSERT_EQ(board.submissions.size(), 1U);
  EXPECT_EQ(board.micro[0][0].rank, 1U);
  EXPECT_TRUE(board.micro[0][0].interval);
}

TEST_F(JudgeSubmissions, FailsIfNoSubmissionIsValid) {
  small.add("good.csv", "0,1\n1,0\n");
  small.add("poor.csv", "0,1\n1,0\n");
  EXPECT_THAT(test::input_error_of([&] { std::ignore = small.judged(); }),
              testing::AllOf(HasSubstr("good.csv"), HasSubstr("poor.csv"), HasSubstr("12")));
}

TEST_F(JudgeSubmissions, RejectsARankingMeasureThatIsNotEvaluated) {
  JudgingOptions options = small.options();
  options.rank_by = "P@10";
  Cache none;
  EXPECT_THAT(test::input_error_of([&] { judge_submissions(small.found(), options, none); }), HasSubstr("P@10"));
  options.evaluation.measures = {measure_of("P@10"), measure_of("NN")};
  options.rank_by = "NN";
  EXPECT_EQ(judge_submissions(small.found(), options, none).rank_by, 1U);
}

TEST_F(JudgeSubmissions, ReevaluatesOnlyChangedSubmissions) {
  const auto used = [&](const JudgingOptions& options) {
    Cache cache(at("cache"));
    const Leaderboard board = judge_submissions(small.found(), options, cache);
    const CacheUse use = cache.report().uses[static_cast<std::size_t>(EntryKind::evaluation)];
    return std::pair(use.hits, use.computed);
  };
  EXPECT_EQ(used(small.options()), std::pair(std::size_t{0}, std::size_t{2}));
  EXPECT_EQ(used(small.options()), std::pair(std::size_t{2}, std::size_t{0}));
  small.add("third.csv", small_matrix(1));
  EXPECT_EQ(used(small.options()), std::pair(std::size_t{2}, std::size_t{1}));
  small.add("third.csv", small_matrix(0.5));
  EXPECT_EQ(used(small.options()), std::pair(std::size_t{2}, std::size_t{1}));
  small.add("third.json", R"({"name": "another name"})");
  EXPECT_EQ(used(small.options()), std::pair(std::size_t{3}, std::size_t{0})) << "a description changes no score";
  JudgingOptions paper = small.options();
  paper.evaluation.protocol = Protocol::paper;
  EXPECT_EQ(used(paper), std::pair(std::size_t{0}, std::size_t{3}));
  test::write_text(small.labels(), test_board::small_labels() + "m12,a\n");
  EXPECT_EQ(test::input_error_of([&] { used(small.options()); }).substr(0, 4), "none") << "other labels, other answers";
}

/// Labels of the small board whose second line, for m1, is another one.
std::string labels_with(const std::string& header, const std::string& of_m1, const std::string& of_others) {
  std::string text = header + "\n";
  for (int i = 0; i < test_board::models; ++i) {
    text += fmt::format("m{},{}{}\n", i, std::string(1, static_cast<char>('a' + i % 3)), i == 1 ? of_m1 : of_others);
  }
  return text;
}

TEST_F(JudgeSubmissions, CacheKeyContainsEveryInput) {
  const auto computed = [&](const JudgingOptions& options) {
    Cache cache(at("cache"));
    judge_submissions(small.found(), options, cache);
    const CacheUse use = cache.report().uses[static_cast<std::size_t>(EntryKind::evaluation)];
    EXPECT_EQ(use.hits + use.computed, 2U);
    return use.computed;
  };
  const auto labels = [&](const std::string& name, const std::string& text) { return folder_.file(name, text); };
  std::string other_order = test_board::small_labels();
  other_order.replace(other_order.find("m1,b\nm2,c\n"), 10, "m2,c\nm1,b\n");
  std::string ids;
  std::string qrels;
  for (int i = 0; i < test_board::models; ++i) {
    ids += fmt::format("m{}\n", i);
    qrels += fmt::format("m{} 0 m{} 1\n", i, (i + 3) % test_board::models);
  }
  MeasureDefinition changed = *measure_of("NN").definition;
  ++changed.version;
  using Change = std::function<void(JudgingOptions&)>;
  const std::vector<std::pair<std::string, Change>> changes{
      {"protocol", [&](JudgingOptions& o) { o.evaluation.protocol = Protocol::paper; }},
      {"ties", [&](JudgingOptions& o) { o.evaluation.ties = Ties::expected; }},
      {"measures", [&](JudgingOptions& o) { o.evaluation.measures = {measure_of("NN")}; }},
      {"order of measures",
       [&](JudgingOptions& o) {
         o.evaluation.measures = {measure_of("FT"), measure_of("NN")};
       }},
      {"version of a measure",
       [&](JudgingOptions& o) {
         o.evaluation.measures = {{"NN", &changed}};
       }},
      {"curve", [&](JudgingOptions& o) { o.evaluation.curve = CurveKind::trec; }},
      {"minimum class size", [&](JudgingOptions& o) { o.evaluation.minimum_class_size = 3; }},
      {"order", [&](JudgingOptions& o) { o.files.order = RowOrder::file; }},
      {"ids", [&](JudgingOptions& o) { o.files.ids = labels("ids.txt", ids); }},
      {"qrels",
       [&](JudgingOptions& o) {
         o.files.labels.clear();
         o.files.ids = labels("ids.txt", ids);
         o.files.qrels = labels("q.qrels", qrels);
       }},
      {"class of a model",
       [&](JudgingOptions& o) {
         std::string text = test_board::small_labels();
         o.files.labels = labels("class.csv", text.replace(text.find("m1,b"), 4, "m1,a"));
       }},
      {"name of a class",
       [&](JudgingOptions& o) {
         std::string text = test_board::small_labels();
         for (char& c : text) c = c == 'b' ? 'B' : c;
         o.files.labels = labels("name.csv", text);
       }},
      {"order of labels", [&](JudgingOptions& o) { o.files.labels = labels("order.csv", other_order); }},
      {"subclasses",
       [&](JudgingOptions& o) { o.files.labels = labels("sub.csv", labels_with("id,class,subclass", ",x", ",y")); }},
      {"one subclass",
       [&](JudgingOptions& o) { o.files.labels = labels("sub.csv", labels_with("id,class,subclass", ",y", ",y")); }},
      {"queries",
       [&](JudgingOptions& o) {
         o.files.labels = labels("split.csv", labels_with("id,class,split", ",target", ",both"));
       }},
      {"targets",
       [&](JudgingOptions& o) {
         o.files.labels = labels("split.csv", labels_with("id,class,split", ",query", ",both"));
       }},
      {"file of targets", [&](JudgingOptions& o) { o.files.targets = small.labels(); }},
      {"shared ids",
       [&](JudgingOptions& o) {
         o.files.targets = small.labels();
         o.files.shared_ids = true;
       }},
  };
  EXPECT_EQ(computed(small.options()), 2U);
  for (const auto& [name, change] : changes) {
    JudgingOptions options = small.options();
    change(options);
    EXPECT_EQ(computed(options), 2U) << name;
    EXPECT_EQ(computed(options), 0U) << name;
  }
  EXPECT_EQ(computed(small.options()), 0U);
}

TEST_F(JudgeSubmissions, ReevaluatesFeaturesForAnotherDistanceFunction) {
  std::filesystem::remove(small.submissions() / "good.csv");  // a matrix of distances
  for (const char* distance : {"l1", "l2"}) {
    JudgingOptions options = small.options();
    options.files.distance = distance;
    Cache cache(at("cache"));
    judge_submissions(small.found(), options, cache);
    EXPECT_EQ(cache.report().uses[static_cast<std::size_t>(EntryKind::evaluation)].computed, 1U) << distance;
  }
}

// Seven of eighteen queries are found by both, each other ones: equal scores, whatever the rounding of their sums.
TEST_F(JudgeSubmissions, GivesEqualScoresTheSameRank) {
  std::string labels = "id,class\n";
  for (int i = 0; i < 18; ++i) labels += fmt::format("{},{}\n", i, i / 6);
  JudgingOptions options;
  options.files.labels = folder_.file("labels.csv", labels);
  options.evaluation.measures = {measure_of("NN")};
  options.standings.resampling.resamples = 10;
  FoundSubmissions found;
  for (const int shift : {0, 1, 2, 3, 4, 5}) {
    std::string matrix;
    for (int i = 0; i < 18; ++i) {
      const bool hit = (5 * i + shift) % 18 < 7;
      for (int j = 0; j < 18; ++j) {
        const bool near = i != j && (i / 6 == j / 6) == hit;
        matrix += fmt::format("{} ", i == j ? 0 : near ? 1 + j : 100 + j);
      }
      matrix += "\n";
    }
    found.submissions.push_back({.file = folder_.file(fmt::format("{}.txt", shift), matrix)});
  }
  Cache none;
  const Leaderboard board = judge_submissions(found, options, none);
  ASSERT_EQ(board.submissions.size(), 6U);
  for (const MethodStanding& standing : board.micro[0]) {
    EXPECT_NEAR(standing.average, 7.0 / 18, 1e-15);
    EXPECT_EQ(standing.rank, 1U);
  }
}

TEST_F(JudgeSubmissions, ResultsDoNotDependOnTheCache) {
  Cache first(at("cache"));
  Cache second(at("cache"));
  const Leaderboard computed = small.judged(first);
  const Leaderboard found = small.judged(second);
  for (std::size_t i = 0; i < 2; ++i) {
    const Evaluation& a = computed.submissions[i].evaluation;
    const Evaluation& b = found.submissions[i].evaluation;
    EXPECT_EQ(a.per_query, b.per_query);
    EXPECT_EQ(a.per_class, b.per_class);
    EXPECT_EQ(a.micro, b.micro);
    EXPECT_EQ(a.macro, b.macro);
    EXPECT_EQ(a.queries, b.queries);
    EXPECT_EQ(a.query_classes, b.query_classes);
    EXPECT_EQ(a.classes, b.classes);
    EXPECT_EQ(a.measures, b.measures);
    EXPECT_EQ(a.micro_curve.precision, b.micro_curve.precision);
    EXPECT_EQ(a.macro_curve.recall, b.macro_curve.recall);
    EXPECT_EQ(a.class_curves.size(), b.class_curves.size());
    EXPECT_EQ(a.queries_with_ties, b.queries_with_ties);
    EXPECT_EQ(a.first_tier_bounds.pessimistic, b.first_tier_bounds.pessimistic);
    EXPECT_EQ(a.first_tier_bounds.optimistic, b.first_tier_bounds.optimistic);
    EXPECT_EQ(computed.submissions[i].warnings, found.submissions[i].warnings);
    EXPECT_EQ(computed.submissions[i].fit_for_report, found.submissions[i].fit_for_report);
  }
  EXPECT_EQ(computed.class_names, found.class_names);
}

}  // namespace

}  // namespace shapegauge
