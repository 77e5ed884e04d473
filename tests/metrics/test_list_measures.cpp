// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <gmock/gmock.h>
#include <map>
#include <random>
#include <rapidcheck/gtest.h>

#include "shapegauge/metrics/evaluation.h"
#include "tests/metrics/list_of_hits.h"

namespace shapegauge {

namespace {

const std::vector<std::string> names{"P@N", "R@N", "F1@N", "mAP@N", "nDCG@N"};

// The measures of the contest on ShapeNetCore, by their definition: `list` has the grades of a query's list, 0 for a
// model of another class, and `relevant` those of all models of its class. Both are cut off after 1000.
std::vector<double> literal_measures(std::vector<int> list, std::vector<int> relevant) {
  std::ranges::sort(relevant, std::greater<>());
  list.resize(std::min<std::size_t>(list.size(), 1000));
  relevant.resize(std::min<std::size_t>(relevant.size(), 1000));
  const auto gain = [](const std::vector<int>& grades) {
    double sum = 0;
    for (std::size_t rank = 1; rank <= grades.size(); ++rank) {
      sum += rank == 1 ? grades[0] : grades[rank - 1] * std::log(2) / std::log(static_cast<double>(rank));
    }
    return sum;
  };
  double hits = 0;
  double precisions = 0;
  for (std::size_t rank = 1; rank <= list.size(); ++rank) {
    if (list[rank - 1] == 0) continue;
    ++hits;
    precisions += hits / static_cast<double>(rank);
  }
  const auto possible = static_cast<double>(relevant.size());
  const double precision = list.empty() ? 0 : hits / static_cast<double>(list.size());
  const double recall = hits / possible;
  const double f1 = hits == 0 ? 0 : 2 * precision * recall / (precision + recall);
  return {precision, recall, f1, precisions / possible, gain(list) / gain(relevant)};
}

// Grade of a model for a query, by the ids of their classes and subclasses, as the contest has it: a model of no
// subclass has its class as one. Subclass 0 stands for none.
int literal_grade(int query_class, int query_subclass, int model_class, int model_subclass) {
  if (query_class != model_class) return 0;
  const auto id = [](int label, int subclass) { return subclass == 0 ? label : 1000 + subclass; };
  if (id(query_class, query_subclass) == id(model_class, model_subclass)) return 3;
  return query_class == id(model_class, model_subclass) ? 2 : 1;
}

// Models with classes, subclasses and a list for each, which begins with the model itself.
struct Contest {
  std::vector<int> classes;
  std::vector<int> subclasses;
  std::vector<std::vector<std::size_t>> lists;
};

std::string subclass_name(int subclass) { return subclass == 0 ? "" : std::to_string(subclass); }

Evaluation evaluated(const Contest& contest) {
  const std::size_t count = contest.classes.size();
  RetrievalTask task = leave_one_out(contest.classes);
  std::vector<std::string> subclasses;
  for (const int subclass : contest.subclasses) subclasses.push_back(subclass_name(subclass));
  task.query_subclasses = task.target_subclasses = number_subclasses(subclasses);
  RankedAnswerLists answers(count);
  for (std::size_t query = 0; query < count; ++query) {
    if (contest.lists[query].empty()) task.query_classes[query] = no_class;
    for (const std::size_t model : contest.lists[query]) {
      answers[query].push_back({static_cast<Eigen::Index>(model), static_cast<double>(answers[query].size())});
    }
  }
  return evaluate(answers, task, {.protocol = Protocol::paper, .measures = measures_of(names)});
}

// Compares the means over queries, and over classes of the means over their queries.
void expect_literal(const Contest& contest) {
  const Evaluation evaluation = evaluated(contest);
  std::map<int, std::vector<std::vector<double>>> by_class;
  std::vector<std::vector<double>> all;
  for (const Eigen::Index row : evaluation.queries) {
    const auto query = static_cast<std::size_t>(row);
    const auto grade = [&](std::size_t model) {
      return literal_grade(contest.classes[query], contest.subclasses[query], contest.classes[model],
                           contest.subclasses[model]);
    };
    std::vector<int> list;
    for (const std::size_t model : contest.lists[query]) list.push_back(grade(model));
    std::vector<int> relevant;
    for (std::size_t model = 0; model < contest.classes.size(); ++model) {
      if (grade(model) > 0) relevant.push_back(grade(model));
    }
    all.push_back(literal_measures(list, relevant));
    by_class[contest.classes[query]].push_back(all.back());
  }
  const auto mean = [](const std::vector<std::vector<double>>& rows, std::size_t column) {
    double sum = 0;
    for (const std::vector<double>& row : rows) sum += row[column];
    return sum / static_cast<double>(rows.size());
  };
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    EXPECT_NEAR(evaluation.micro[column], mean(all, i), 1e-12) << names[i];
    double macro = 0;
    for (const auto& [label, rows] : by_class) macro += mean(rows, i);
    EXPECT_NEAR(evaluation.macro[column], macro / static_cast<double>(by_class.size()), 1e-12) << names[i];
  }
}

Contest random_contest(unsigned seed, std::size_t count) {
  std::mt19937 random(seed);
  const auto below = [&](std::size_t bound) {
    return std::uniform_int_distribution<std::size_t>(0, bound - 1)(random);
  };
  Contest contest;
  for (std::size_t i = 0; i < count; ++i) {
    contest.classes.push_back(i < 4 ? static_cast<int>(i % 2) : static_cast<int>(below(3)));
    contest.subclasses.push_back(static_cast<int>(below(4)));
  }
  contest.subclasses[0] = 1;
  for (std::size_t query = 0; query < count; ++query) {
    std::vector<std::size_t> list;
    for (std::size_t i = 0; i < count; ++i) list.push_back(i);
    std::ranges::shuffle(list, random);
    std::swap(list[0], *std::ranges::find(list, query));
    list.resize(1 + below(count));
    contest.lists.push_back(list);
  }
  return contest;
}

RC_GTEST_PROP(RankedListMeasures, MatchADirectImplementation, ()) {
  expect_literal(random_contest(*rc::gen::arbitrary<unsigned>(), *rc::gen::inRange<std::size_t>(4, 30)));
}

TEST(RankedListMeasures, IgnoreRanksBeyondAThousand) {
  // 1,200 models of class 0, every third of them of a subclass, and 100 of class 1. Three queries have lists.
  Contest contest;
  for (int i = 0; i < 1300; ++i) {
    contest.classes.push_back(i < 1200 ? 0 : 1);
    contest.subclasses.push_back(i % 3 == 0 ? 1 : 0);
  }
  contest.lists.resize(1300);
  for (const std::size_t query : {0U, 7U, 1250U}) {
    contest.lists[query].push_back(query);
    for (std::size_t i = 1; i < 1300; ++i) contest.lists[query].push_back((query + 1299 - i) % 1300);
  }
  expect_literal(contest);
}

TEST(RankedListMeasures, MatchAWorkedExample) {
  // Grades 3 (the query), 0, 1 and a list that ends; a fourth model of grade 2 is not found.
  RankedList list = list_of_runs({{.size = 1, .hits = 1, .misses = 0, .grade = 3},
                                  {.size = 1, .hits = 0},
                                  {.size = 1, .hits = 1, .misses = 0, .grade = 1}},
                                 true, 1);
  list.grades = {3, 2, 1};
  const auto value = [&](const std::string& name) { return measure_of(name).value(list); };
  EXPECT_DOUBLE_EQ(value("P@N"), 2.0 / 3);
  EXPECT_DOUBLE_EQ(value("R@N"), 2.0 / 3);
  EXPECT_DOUBLE_EQ(value("F1@N"), 2.0 / 3);
  EXPECT_DOUBLE_EQ(value("mAP@N"), (1 + 2.0 / 3) / 3);
  EXPECT_DOUBLE_EQ(value("nDCG@N"), (3 + 1 / std::log2(3)) / (3 + 2 + 1 / std::log2(3)));
}

TEST(RankedListMeasures, AreZeroForAnEmptyList) {
  const RankedList list = list_of_runs({}, false, 3);
  for (const std::string& name : names) EXPECT_EQ(measure_of(name).value(list), 0) << name;
}

TEST(RankedListMeasures, AreTheMeanOverAllOrdersOfTies) {
  // A hit, then two hits among five tied models, then a miss: the mean over the ten placings of the two.
  for (const std::size_t count : {2U, 4U, 6U, 7U}) {
    double sum = 0;
    std::vector<bool> tied{false, false, false, true, true};
    do {
      std::vector<bool> hits{true};
      hits.insert(hits.end(), tied.begin(), tied.end());
      hits.push_back(false);
      sum += sum_of_precisions(list_of_hits(hits), count);
    } while (std::next_permutation(tied.begin(), tied.end()));
    const RankedList list = list_of_runs({{1, 1}, {5, 2}, {1, 0}});
    EXPECT_NEAR(sum_of_precisions(list, count), sum / 10, 1e-14) << count;
  }
}

TEST(SubclassGrade, MatchesTheGradesOfShapenet16) {
  EXPECT_EQ(subclass_grade(4, 4), 3);
  EXPECT_EQ(subclass_grade(no_subclass, no_subclass), 3);
  EXPECT_EQ(subclass_grade(4, no_subclass), 2);
  EXPECT_EQ(subclass_grade(no_subclass, 4), 1);
  EXPECT_EQ(subclass_grade(4, 5), 1);
}

TEST(NumberedSubclasses, AreEmptyIfNoSubclassHasAName) {
  EXPECT_TRUE(number_subclasses(std::vector<std::string>{"", ""}).empty());
  EXPECT_THAT(number_subclasses(std::vector<std::string>{"b", "", "a", "b"}),
              testing::ElementsAre(0, no_subclass, 1, 0));
}

}  // namespace

}  // namespace shapegauge
