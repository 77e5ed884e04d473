// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/experiments/evaluation/evaluate_files.h"
#include "shapegauge/experiments/results/evaluation_tables.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/retrieval/distances.h"
#include "tests/datasets/files/write_matrix.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

// Features of more models than one block of rows, with ties and duplicates.
DistanceMatrix many_features(Eigen::Index models) {
  RandomNumbers random(3);
  DistanceMatrix features = DistanceMatrix::NullaryExpr(
      models, 6, [&] { return static_cast<double>(1 + static_cast<int>(random.uniform(0, 4))); });
  features.row(models - 1) = features.row(2);
  return features;
}

class EvaluateFiles : public test::FolderTest {
 protected:
  static constexpr Eigen::Index models = 270;

  void SetUp() override {
    write_npy(at("features.npy"), many_features(models));
    std::string labels = "id,class\n";
    std::string sets = "id,class,split\n";
    for (Eigen::Index model = 0; model < models; ++model) {
      const std::string line = std::to_string(model) + ",class" + std::to_string(model * model % 7);
      labels += line + "\n";
      sets += line + (model % 3 == 0 ? ",query\n" : ",target\n");
    }
    test::write_text(at("labels.csv"), labels);
    test::write_text(at("sets.csv"), sets);
  }

  // All scores and warnings as text with full precision.
  [[nodiscard]] static std::string all_output(const EvaluatedFiles& evaluated) {
    const EvaluationTask& task = evaluated.data.task;
    const std::vector<NamedEvaluation> one{
        {.method = "m",
         .evaluation = &evaluated.evaluation,
         .intervals = intervals_of(evaluated.evaluation, {.resampling = {.resamples = 50}})}};
    const ScoreStyle all_digits{.percent = false, .decimals = 17};
    std::string text = evaluation_json(evaluated.evaluation, task.class_names, one[0].intervals).dump();
    text += to_csv(summary_table(one, all_digits)) + to_csv(per_query_table(one, task.query_ids, task.class_names));
    text += to_csv(per_class_table(one, task.class_names)) + to_csv(precision_recall_table(one));
    text += to_csv(class_curves_table(one, task.class_names));
    for (const std::string& warning : evaluated.warnings) text += warning + "\n";
    return text;
  }

  // Compares features, their matrix from a text file (read as a whole), and their matrix from a file read in blocks.
  void expect_same(const std::string& distance, const std::string& labels, const EvaluationOptions& options) const {
    const std::string by_rows =
        all_output(evaluate_files({.matrix = at("features.npy"), .labels = at(labels), .distance = distance}, options));
    const DistanceMatrix matrix = distance_matrix(many_features(models).cast<float>(), distance);
    write_npy(at("matrix.npy"), matrix);
    write_csv_matrix(at("matrix.csv"), matrix, {});
    for (const char* name : {"matrix.npy", "matrix.csv"}) {
      EXPECT_EQ(all_output(evaluate_files({.matrix = at(name), .labels = at(labels)}, options)), by_rows)
          << distance << " " << labels << " " << name;
    }
  }
};

TEST_F(EvaluateFiles, FeaturesHaveTheScoresOfTheirDistanceMatrixForEveryDistanceFunction) {
  for (const std::string& distance : distances().names()) expect_same(distance, "labels.csv", {});
}

TEST_F(EvaluateFiles, FeaturesHaveTheScoresOfTheirDistanceMatrixForEveryProtocolAndTieOrder) {
  for (const std::string& protocol : list_of_words<Protocol>()) {
    for (const std::string& ties : list_of_words<Ties>()) {
      for (const char* labels : {"labels.csv", "sets.csv"}) {
        expect_same("l1", labels,
                    {.protocol = value_of_word<Protocol>(protocol).value(), .ties = value_of_word<Ties>(ties).value()});
      }
    }
  }
}

TEST_F(EvaluateFiles, WarnsOfModelsWithIdenticalFeatures) {
  const EvaluatedFiles evaluated =
      evaluate_files({.matrix = at("features.npy"), .labels = at("labels.csv"), .distance = "l2"}, {});
  const DistanceMatrix features = many_features(models);
  int repeats = 0;
  for (Eigen::Index row = 0; row < models; ++row) {
    for (Eigen::Index earlier = 0; earlier < row; ++earlier) {
      if (features.row(row) != features.row(earlier)) continue;
      ++repeats;
      break;
    }
  }
  EXPECT_THAT(evaluated.warnings, Contains(HasSubstr(std::to_string(repeats) + " rows repeat an earlier one")));
}

TEST_F(EvaluateFiles, WarnsOfFeaturesThatAreEqualInSinglePrecision) {
  DistanceMatrix features(models, 1);
  for (Eigen::Index row = 0; row < models; ++row) features(row, 0) = 1e9 + static_cast<double>(row) / models;
  write_npy(at("far.npy"), features);
  const EvaluatedFiles evaluated =
      evaluate_files({.matrix = at("far.npy"), .labels = at("labels.csv"), .distance = "l2"}, {});
  EXPECT_THAT(evaluated.warnings, Contains(HasSubstr(std::to_string(models - 1) + " rows equal others")));
}

TEST_F(EvaluateFiles, RejectsIdsOfRowsWithoutIdsOfColumns) {
  test::write_text(at("m.txt"), "1 2 3\n4 5 6\n");
  test::write_text(at("queries.csv"), "id,class\na,x\nb,y\n");
  test::write_text(at("targets.csv"), "id,class\nd,x\ne,y\nf,y\n");
  test::write_text(at("rows.txt"), "b\na\n");
  const auto error = test::input_error_of([&] {
    (void)open_evaluation_files(
        {.matrix = at("m.txt"), .labels = at("queries.csv"), .targets = at("targets.csv"), .ids = at("rows.txt")});
  });
  EXPECT_THAT(error, AllOf(HasSubstr("rows.txt"), HasSubstr("columns of "), HasSubstr("m.txt")));
}

TEST_F(EvaluateFiles, RejectsAnIdsFileWithoutIds) {
  test::write_text(at("none.txt"), "\n");
  const auto error = test::input_error_of([&] {
    (void)open_evaluation_files(
        {.matrix = at("features.npy"), .labels = at("labels.csv"), .ids = at("none.txt"), .distance = "l2"});
  });
  EXPECT_THAT(error, HasSubstr("none.txt has no ids"));
}

TEST_F(EvaluateFiles, RejectsIdsThatDoNotMatchTheMatrix) {
  test::write_text(at("m.csv"), "id,a,b,c\na,0,1,2\nb,1,0,3\nc,2,3,0\n");
  test::write_text(at("classes.csv"), "id,class\na,x\nb,x\nc,y\n");
  test::write_text(at("same.txt"), "a.off\nb\nc\n");
  test::write_text(at("other.txt"), "a\nc\nb\n");
  const auto opened = [&](const std::string& ids) {
    return open_evaluation_files({.matrix = at("m.csv"), .labels = at("classes.csv"), .ids = at(ids)});
  };
  EXPECT_EQ(opened("same.txt").distances.rows, 3);
  EXPECT_THAT(
      test::input_error_of([&] { (void)opened("other.txt"); }),
      AllOf(HasSubstr("row 2 has the id \"b\" in "), HasSubstr("m.csv, but \"c\" in "), HasSubstr("other.txt")));
}

/// Warnings for a matrix of four models in two classes.
class MatrixWarnings : public test::FolderTest {
 protected:
  [[nodiscard]] std::vector<std::string> warnings_of(const std::string& matrix, bool similarity = false) const {
    test::write_text(at("labels.csv"), "id,class\na,x\nb,x\nc,y\nd,y\n");
    test::write_text(at("m.txt"), matrix);
    return evaluate_files({.matrix = at("m.txt"), .labels = at("labels.csv"), .similarity = similarity}, {}).warnings;
  }
};

TEST_F(MatrixWarnings, AreEmptyForAMatrixWithoutAnomalies) {
  EXPECT_THAT(warnings_of("0 1 2 3\n1 0 4 5\n2 4 0 6\n3 5 6 0\n"), IsEmpty());
}

TEST_F(MatrixWarnings, ReportRowsOfInfiniteDistances) {
  EXPECT_THAT(warnings_of("0 inf inf inf\ninf 0 4 5\ninf 4 0 6\ninf 5 6 0\n"),
              ElementsAre(HasSubstr("3 distances are infinite"),
                          HasSubstr("1 query is at infinite distance from all models (first: a): no model is found")));
}

TEST_F(MatrixWarnings, IgnoreAsymmetryByRounding) {
  EXPECT_THAT(warnings_of("0 1.0000000000000002 2 3\n1 0 4 5\n2 4 0 6\n3 5 6 0\n"), IsEmpty());
  EXPECT_THAT(warnings_of("0 1.00000000001 2 3\n1 0 4 5\n2 4 0 6\n3 5 6 0\n"),
              ElementsAre(HasSubstr("not symmetric: 1 pair")));
}

TEST_F(MatrixWarnings, ReportNegativeInfiniteAsymmetricAndRepeatedDistances) {
  EXPECT_THAT(warnings_of("0 -1 2 inf\n1 0 4 5\n2 4.25 0.5 6\n3 5 6 0\n"),
              ElementsAre(HasSubstr("1 distance is negative"), HasSubstr("1 distance is infinite"),
                          HasSubstr("not symmetric: 3 pairs of entries (i, j) and (j, i) differ, by up to 2;"),
                          HasSubstr("1 entry is not 0 on the diagonal")));
  EXPECT_THAT(warnings_of("0 1 2 3\n1 0 1 1\n2 1 0 4\n0 1 2 3\n"),
              ElementsAre(HasSubstr("not symmetric: 2 pairs"), HasSubstr("1 entry is not 0"),
                          HasSubstr("1 row repeats an earlier one (first: d repeats a)"),
                          HasSubstr("1 row has all distances equal (first: b)")));
  EXPECT_THAT(warnings_of("0 1 2 3\n0 0 4 5\n0 0 0 6\n0 0 0 0\n"),
              Contains(HasSubstr("triangular: in 6 pairs of entries (i, j) and (j, i) one is 0")));
  EXPECT_THAT(warnings_of("9 3 2 1\n3 9 2 1\n2 2 9 4\n1 1 4 9\n"),
              Contains(HasSubstr("in 4 of 4 rows the query is the farthest")));
}

TEST_F(MatrixWarnings, AreEmptyForSimilaritiesButReportDistancesDeclaredAsSimilarities) {
  EXPECT_THAT(warnings_of("9 3 2 1\n3 9 2 1\n2 2 9 4\n1 1 4 9\n", true), IsEmpty());
  EXPECT_THAT(warnings_of("0 1 2 3\n1 0 4 5\n2 4 0 6\n3 5 6 0\n", true),
              Contains(HasSubstr("matrix of distances, which take no `similarity=true`")));
}

TEST_F(MatrixWarnings, ReportThatEachQueryHasAnotherModelAtDistanceZero) {
  EXPECT_THAT(warnings_of("0 0 2 3\n0 0 4 5\n2 4 0 0\n3 5 0 0\n"),
              Contains(HasSubstr("each query has another model at distance 0")));
  EXPECT_THAT(warnings_of("0 0 2 3\n0 0 4 5\n2 4 0 6\n3 5 6 0\n"), Not(Contains(HasSubstr("at distance 0"))));
}

// Twenty models of two classes, in which each is nearest to one of the other class.
TEST(ChanceWarning, AppearsIfTheNearestNeighbourScoreIsFarBelowChance) {
  const test::TemporaryFolder folder;
  std::string labels = "id,class\n";
  std::string far;
  std::string near;
  for (int i = 0; i < 20; ++i) {
    labels += fmt::format("{},c{}\n", i, i % 2);
    for (int j = 0; j < 20; ++j) {
      const int step = (j - i + 20) % 20;
      far += fmt::format("{} ", i == j ? 0 : step % 2 == 0 ? 30 + step : step);
      near += fmt::format("{} ", i == j ? 0 : step % 2 == 0 ? step : 30 + step);
    }
    far += "\n";
    near += "\n";
  }
  const auto file = folder.file("labels.csv", labels);
  const auto warnings = [&](const std::string& matrix) {
    return evaluate_files({.matrix = folder.file("m.txt", matrix), .labels = file}, {}).warnings;
  };
  EXPECT_THAT(warnings(far), Contains(HasSubstr("NN is 0.0 %, far below the 47.4 % of a random order")));
  EXPECT_THAT(warnings(near), Not(Contains(HasSubstr("random order"))));
}

TEST_F(EvaluateFiles, RejectsDistancesAsFeatures) {
  test::write_text(at("three.csv"), "id,class\na,x\nb,x\nc,y\n");
  test::write_text(at("d.csv"), "id,a,b,c\na,0,1,2\nb,1,0,3\nc,2,3,0\n");
  EXPECT_THAT(test::input_error_of(
                  [&] { open_evaluation_files({.matrix = at("d.csv"), .labels = at("three.csv"), .distance = "l1"}); }),
              AllOf(HasSubstr("d.csv"), HasSubstr("not features")));
}

TEST_F(EvaluateFiles, WarnsOfTrecRunsWhoseScoresAreDistances) {
  const auto warnings_of = [&](const char* run) {
    test::write_text(at("x.run"), run);
    return evaluate_files({.matrix = at("x.run"), .labels = at("labels.csv")}, {}).warnings;
  };
  EXPECT_THAT(warnings_of("0 Q0 1 1 0.1 r\n0 Q0 2 2 0.2 r\n1 Q0 0 1 0.1 r\n1 Q0 2 2 0.3 r\n"),
              Contains(HasSubstr("in 2 of 2 lists the scores rise")));
  EXPECT_THAT(warnings_of("0 Q0 1 1 0.2 r\n0 Q0 2 2 0.1 r\n"), Not(Contains(HasSubstr("the scores rise"))));
}

TEST_F(EvaluateFiles, WarnsIfQueriesFindThemselvesUnlessIdsAreDeclaredShared) {
  test::write_text(at("q.csv"), "id,class\na,x\nb,x\n");
  test::write_text(at("t.csv"), "id,class\na,x\nb,x\nc,y\n");
  test::write_text(at("d.txt"), "0 1 2\n1 0 3\n");
  for (const bool shared : {false, true}) {
    const EvaluatedFiles evaluated = evaluate_files(
        {.matrix = at("d.txt"), .labels = at("q.csv"), .targets = at("t.csv"), .shared_ids = shared}, {});
    EXPECT_THAT(evaluated.warnings, Contains(HasSubstr("they find themselves")).Times(shared ? 0 : 1));
  }
}

TEST_F(EvaluateFiles, RejectsMatrixSettingsForRankedLists) {
  using Change = void (*)(EvaluationFiles&);
  const std::vector<std::pair<const char*, Change>> changes{
      {"`similarity`", [](EvaluationFiles& files) { files.similarity = true; }},
      {"`distance`", [](EvaluationFiles& files) { files.distance = "l1"; }},
      {"`order`", [](EvaluationFiles& files) { files.order = RowOrder::natural; }},
      {"`ids`", [](EvaluationFiles& files) { files.ids = "ids.txt"; }},
      {"`variable`", [](EvaluationFiles& files) { files.variable = "D"; }}};
  test::write_text(at("lists.run"), "0 Q0 1 1 2 run\n");
  test::write_text(at("q.qrels"), "0 0 1 1\n");
  for (const bool judged : {false, true}) {
    EvaluationFiles files{.matrix = at("lists.run")};
    (judged ? files.qrels : files.labels) = judged ? at("q.qrels") : at("labels.csv");
    EXPECT_NO_THROW(open_evaluation_files(files));
    for (const auto& [setting, change] : changes) {
      EvaluationFiles changed = files;
      change(changed);
      EXPECT_THAT(test::input_error_of([&] { open_evaluation_files(changed); }), HasSubstr(setting));
    }
  }
}

TEST_F(EvaluateFiles, MatchesIdsThatDifferInFolderOrExtension) {
  test::write_text(at("paths.csv"), "id,class\ncat/a,cat\ncat/b,cat\ndog/c,dog\n");
  test::write_text(at("names.csv"), "id,class\na.obj,cat\nb.obj,cat\nc.obj,dog\n");
  for (const auto& [ids, labels] : {std::pair{"a,b,c", "paths.csv"},
                                    {"x/cat/a,x/cat/b,x/dog/c", "paths.csv"},
                                    {"cat/a,cat/b,dog/c", "names.csv"}}) {
    std::istringstream names(ids);
    std::string matrix = std::string("id,") + ids + "\n";
    for (std::string name; std::getline(names, name, ',');) matrix += name + ",1,2,3\n";
    test::write_text(at("d.csv"), matrix);
    const EvaluationData data = open_evaluation_files({.matrix = at("d.csv"), .labels = at(labels)});
    EXPECT_THAT(data.task.retrieval.query_classes, ElementsAre(0, 0, 1)) << ids;
  }
}

}  // namespace

}  // namespace shapegauge
