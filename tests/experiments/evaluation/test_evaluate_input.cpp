#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/experiments/evaluation/evaluate_input.h"
#include "shapegauge/experiments/files/npy.h"
#include "shapegauge/experiments/results/evaluation_tables.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/experiments/text_files.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<std::string> ids = {"a", "b", "c", "d"};

TEST(MatrixRemarks, NothingOddIsNoRemark) { EXPECT_THAT(matrix_warnings({}, ids, false), IsEmpty()); }

TEST(MatrixRemarks, SayWhatWasFoundAndWhatItDoes) {
  MatrixFindings findings;
  findings.negative = 1;
  findings.infinite = 2;
  findings.asymmetric_pairs = 3;
  findings.largest_asymmetry = 0.25;
  findings.nonzero_diagonal = 4;
  findings.rows_nearest_to_others = 4;
  findings.equal_rows = {{3, 1}};
  findings.constant_rows = {0, 2};
  EXPECT_THAT(matrix_warnings(findings, ids, false),
              ElementsAre(HasSubstr("1 distance is negative"), HasSubstr("2 distances are infinite"),
                          HasSubstr("in 4 of 4 rows the query is the farthest"),
                          HasSubstr("not symmetric: 3 pairs of entries (i, j) and (j, i) differ, by up to 0.25"),
                          HasSubstr("4 entries are not 0 on the diagonal"),
                          HasSubstr("1 row repeats an earlier one (first: d repeats b)"),
                          HasSubstr("2 rows have all distances equal (first: a)")));
}

TEST(MatrixRemarks, OfSimilaritiesSayNothingOfSignsAndTheDiagonal) {
  MatrixFindings findings;
  findings.negative = 12;
  findings.nonzero_diagonal = 4;
  EXPECT_THAT(matrix_warnings(findings, ids, true), IsEmpty());
}

}  // namespace

namespace {

// Features of so many models that they do not come as one block of rows, with ties and some repeated.
DistanceMatrix many_features(Eigen::Index models) {
  RandomNumbers random(3);
  DistanceMatrix features = DistanceMatrix::NullaryExpr(
      models, 6, [&] { return static_cast<double>(1 + static_cast<int>(random.uniform(0, 4))); });
  features.row(models - 1) = features.row(2);
  return features;
}

class EvaluateInput : public testing::Test {
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
    test_experiments::write_text(at("labels.csv"), labels);
    test_experiments::write_text(at("sets.csv"), sets);
  }

  [[nodiscard]] std::filesystem::path at(const std::string& name) const { return folder_.path() / name; }

  // All figures, and all remarks, as text with all digits.
  [[nodiscard]] std::string all_output(const EvaluationFiles& files, const EvaluationOptions& options) const {
    const EvaluationInput input = read_evaluation_input(files);
    EXPECT_EQ(input.features.has_value(), !files.whole_matrix);
    const CheckedEvaluation checked = evaluate_and_check(input, options);
    const std::vector<NamedEvaluation> one{
        {.method = "m",
         .evaluation = &checked.evaluation,
         .intervals = intervals_of(checked.evaluation, {.resampling = {.resamples = 50}})}};
    const FigureStyle all_digits{.percent = false, .decimals = 17};
    std::string text = evaluation_json(checked.evaluation, input.class_names, one[0].intervals).dump();
    text += to_csv(summary_table(one, all_digits)) + to_csv(per_query_table(one, input.query_ids, input.class_names));
    text += to_csv(per_class_table(one, input.class_names)) + to_csv(precision_recall_table(one));
    text += to_csv(class_curves_table(one, input.class_names));
    for (const std::string& remark : matrix_warnings(checked.findings, input.query_ids, false)) text += remark + "\n";
    return text;
  }

  void expect_same(const std::string& distance, const std::string& labels, const EvaluationOptions& options) const {
    const EvaluationFiles by_rows{.matrix = at("features.npy"), .labels = at(labels), .distance = distance};
    EvaluationFiles whole = by_rows;
    whole.whole_matrix = true;
    EXPECT_EQ(all_output(by_rows, options), all_output(whole, options)) << distance << " " << labels;
  }

 private:
  test_io::TemporaryFolder folder_;
};

TEST_F(EvaluateInput, FeaturesByRowsAreTheirMatrixToTheByteForEveryDistance) {
  for (const std::string& distance : distance_names()) expect_same(distance, "labels.csv", {});
}

TEST_F(EvaluateInput, FeaturesByRowsAreTheirMatrixToTheByteUnderEveryConvention) {
  for (const std::string& protocol : protocol_names()) {
    for (const std::string& ties : ties_names()) {
      for (const char* labels : {"labels.csv", "sets.csv"}) {
        expect_same("l1", labels, {.protocol = protocol_of(protocol).value(), .ties = ties_of(ties).value()});
      }
    }
  }
}

TEST_F(EvaluateInput, WhatIsOddAboutTheDistancesOfFeaturesIsFound) {
  const EvaluationInput input =
      read_evaluation_input({.matrix = at("features.npy"), .labels = at("labels.csv"), .distance = "l2"});
  const MatrixFindings findings = evaluate_and_check(input, {}).findings;
  EXPECT_THAT(findings.equal_rows, testing::Contains(testing::Pair(models - 1, 2)));
}

}  // namespace

}  // namespace shapegauge
