// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <gmock/gmock.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/results/evaluation_plots.h"
#include "tests/support/test_files.h"

namespace shapegauge {
namespace {

std::vector<std::string> texts_in(const Drawing& drawing) {
  std::vector<std::string> texts;
  for (const auto& element : drawing.elements) {
    if (const auto* const text = std::get_if<DrawnText>(&element)) texts.push_back(text->text);
  }
  return texts;
}

Evaluation small_evaluation() {
  Eigen::MatrixXd distances = Eigen::MatrixXd::Constant(4, 4, 2);
  distances.topLeftCorner(2, 2).setOnes();
  return evaluate(distances, std::vector<int>{0, 0, 1, 1}, {});
}

TEST(EvaluationPlots, ContainThePrecisionRecallCurvesReadFromATable) {
  const Evaluation evaluation = small_evaluation();
  const std::vector<NamedEvaluation> named{{.method = "a, \"b\"", .evaluation = &evaluation},
                                           {.method = "other", .evaluation = &evaluation}};
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "pr_curves.csv";
  test::write_text(path, to_csv(precision_recall_table(named)));
  const std::vector<NamedCurve> curves = read_curves(path);
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[0].method, "a, \"b\"");
  EXPECT_EQ(curves[0].curve.recall, evaluation.micro_curve.recall);
  EXPECT_NEAR(curves[1].curve.precision[3], evaluation.micro_curve.precision[3], 1e-6);
  EXPECT_THAT(texts_in(curves_plot(curves)), testing::IsSupersetOf({"Recall", "Precision", "a, \"b\"", "other"}));
}

TEST(EvaluationPlots, RejectTablesWithoutCurves) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "x.csv";
  const std::string header = "method,protocol,recall,precision,macro_precision\n";
  for (const std::string& text : {std::string("a,b\n1,2\n"), header + "m,psb,0.1\n", header + "m,psb,0.1,many,1\n"}) {
    test::write_text(path, text);
    EXPECT_THROW(read_curves(path), InputError) << text;
  }
}

TEST(EvaluationPlots, DrawTheScoresOfClassesAsBars) {
  const Evaluation evaluation = small_evaluation();
  const NamedEvaluation named{.method = "m", .evaluation = &evaluation};
  const std::vector<std::string> names{"ants", "cups"};
  EXPECT_THAT(texts_in(class_plot({&named, 1}, names, "NN")), testing::IsSupersetOf({"ants", "cups", "NN (%)"}));
  EXPECT_THROW(class_plot({&named, 1}, names, "XY"), InputError);
}

TEST(EvaluationPlots, DrawTheScoresOfMethodsAsBars) {
  const std::vector<std::string> methods{"a", "b"};
  const std::vector<std::string> measures{"NN", "FT"};
  MethodComparison comparison;
  comparison.averages = Eigen::Vector2d(0.5, 0.9);
  comparison.intervals = {{0.4, 0.6}, {0.8, 1}};
  const std::vector<MethodComparison> comparisons(2, comparison);
  EXPECT_THAT(texts_in(scores_plot(methods, measures, comparisons, 0.95)),
              testing::IsSupersetOf({"NN", "FT", "a", "b"}));
}

}  // namespace
}  // namespace shapegauge
