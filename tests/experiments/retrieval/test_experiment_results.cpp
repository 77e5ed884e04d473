// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "shapegauge/experiments/retrieval/experiment_results.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Results of two methods for five models.
ExperimentResults two_methods() {
  ExperimentResults results;
  for (const char* id : {"a", "b", "c", "d", "e"}) results.models.emplace_back().id = id;
  for (const char* name : {"first", "second"}) {
    MethodResults method{.name = name,
                         .distances = {},
                         .overview = {},
                         .evaluations = {Evaluation{}},
                         .signatures = {},
                         .histogram_ranges = {}};
    method.evaluations.front().queries = {0, 1, 2, 3, 4};
    results.methods.push_back(method);
  }
  return results;
}

TEST(IncompleteMethods, AreListedWithTheFirstThreeFailedModels) {
  ExperimentResults results = two_methods();
  EXPECT_THAT(incomplete_methods(results), IsEmpty());
  results.methods[1].failures = {{.model = 0, .message = "empty"},
                                 {.model = 2, .message = "flat"},
                                 {.model = 3, .message = "open"},
                                 {.model = 4, .message = "huge"}};
  EXPECT_THAT(
      incomplete_methods(results),
      ElementsAre("method \"second\" cannot process 4 of 5 models, which count as not found: a (empty), c (flat), "
                  "d (open) and 1 more"));
  results.methods[1].failures.resize(1);
  EXPECT_THAT(incomplete_methods(results),
              ElementsAre("method \"second\" cannot process 1 of 5 models, which count as not found: a (empty)"));
}

TEST(RunWarnings, IncludeTheRemarksOfMethods) {
  ExperimentResults results = two_methods();
  results.methods[1].remark = "odd";
  EXPECT_THAT(run_warnings(results), ElementsAre("method \"second\": odd"));
}

TEST(RunWarnings, ReportOutliersUnlessTheyAreRemoved) {
  ExperimentResults results = two_methods();
  results.shapes.resize(5);
  results.shapes[3].diagnostics.outliers = 2;  // in the file
  EXPECT_THAT(run_warnings(results), ElementsAre(testing::StartsWith("1 of 5 shapes are clouds with outliers")));
  results.configuration.preparation.remove_outliers = true;
  EXPECT_THAT(run_warnings(results), IsEmpty());
}

TEST(RunWarnings, ReportNormalsUnrelatedToTheSurface) {
  ExperimentResults results = two_methods();
  results.shapes.resize(5);
  results.shapes[1].diagnostics.stray_normals = true;
  EXPECT_THAT(run_warnings(results), ElementsAre(testing::StartsWith("1 of 5 shapes are clouds whose normals")));
}

TEST(RunWarnings, ReportTiesWithTheirEffectUnderEachProtocol) {
  ExperimentResults results = two_methods();
  EXPECT_THAT(run_warnings(results), IsEmpty());
  Evaluation& evaluation = results.methods[0].evaluations.front();
  evaluation.queries_with_ties = 2;
  const std::string tied =
      "method \"first\": 2 of 5 queries have relevant and other models at equal distance, ordered by \"ties\": "
      "\"index\"";
  EXPECT_THAT(run_warnings(results), ElementsAre(tied)) << "no order changes FT";
  evaluation.first_tier_bounds = {.pessimistic = 0.25, .optimistic = 0.5};
  Evaluation other = evaluation;
  other.protocol = Protocol::paper;
  other.first_tier_bounds = {.pessimistic = 0.4, .optimistic = 0.6};
  results.methods[0].evaluations.push_back(other);
  EXPECT_THAT(run_warnings(results),
              ElementsAre(tied + "; FT ranges from 25.0 to 50.0 (psb), 40.0 to 60.0 (paper) with their order"));
}

}  // namespace

}  // namespace shapegauge
