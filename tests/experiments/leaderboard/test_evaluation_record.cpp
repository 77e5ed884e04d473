#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/experiments/leaderboard/evaluation_record.h"

namespace shapegauge {
namespace {

using Json = nlohmann::json;

/// An evaluation of random distances between models of classes of different sizes.
Evaluation random_evaluation(const EvaluationOptions& options) {
  RandomNumbers random(4);
  const std::vector<int> labels{0, 0, 0, 1, 1, 2, 2, 2, 2, 3};
  DistanceMatrix distances(10, 10);
  for (double& distance : distances.reshaped()) distance = static_cast<double>(random.below(12));
  return evaluate(distances, labels, options);
}

void expect_equal(const PrecisionRecallCurve& a, const PrecisionRecallCurve& b) {
  EXPECT_EQ(a.recall, b.recall);
  EXPECT_EQ(a.precision, b.precision);
}

void expect_equal(const Evaluation& a, const Evaluation& b) {
  EXPECT_EQ(a.protocol, b.protocol);
  EXPECT_EQ(a.ties, b.ties);
  EXPECT_EQ(a.curve, b.curve);
  EXPECT_EQ(a.measures, b.measures);
  EXPECT_EQ(a.queries, b.queries);
  EXPECT_EQ(a.query_classes, b.query_classes);
  EXPECT_EQ(a.per_query, b.per_query);
  EXPECT_EQ(a.classes, b.classes);
  EXPECT_EQ(a.per_class, b.per_class);
  EXPECT_EQ(a.micro, b.micro);
  EXPECT_EQ(a.macro, b.macro);
  expect_equal(a.micro_curve, b.micro_curve);
  expect_equal(a.macro_curve, b.macro_curve);
  ASSERT_EQ(a.class_curves.size(), b.class_curves.size());
  for (std::size_t c = 0; c < a.class_curves.size(); ++c) expect_equal(a.class_curves[c], b.class_curves[c]);
  EXPECT_EQ(a.models_left_out, b.models_left_out);
  EXPECT_EQ(a.queries_with_ties, b.queries_with_ties);
  EXPECT_EQ(a.first_tier_bounds.pessimistic, b.first_tier_bounds.pessimistic);
  EXPECT_EQ(a.first_tier_bounds.optimistic, b.first_tier_bounds.optimistic);
}

TEST(EvaluationRecord, ComesBackBitByBit) {
  for (const Protocol protocol : {Protocol::psb, Protocol::paper}) {
    for (const Ties ties : {Ties::index, Ties::pessimistic, Ties::optimistic}) {
      const Evaluation written = random_evaluation({.protocol = protocol, .ties = ties});
      ASSERT_GT(written.queries_with_ties, 0);
      ASSERT_EQ(written.models_left_out, 1);
      ASSERT_NE(written.first_tier_bounds.pessimistic, written.first_tier_bounds.optimistic);
      expect_equal(evaluation_from_record(to_record(written)), written);
      expect_equal(evaluation_from_record(Json::parse(to_record(written).dump())), written);
      expect_equal(evaluation_from_record(Json::from_cbor(Json::to_cbor(to_record(written)))), written);
    }
  }
}

TEST(EvaluationRecord, AnotherFormIsAnError) {
  const Json record = to_record(random_evaluation({}));
  for (const auto& item : record.items()) {
    Json changed = record;
    changed.erase(item.key());
    EXPECT_THROW(evaluation_from_record(changed), Json::exception) << "without " << item.key();
    changed = record;
    changed[item.key()] = {{"x", nullptr}};
    EXPECT_THROW(evaluation_from_record(changed), Json::exception) << item.key() << " of another type";
  }
  for (const char* key : {"per_query", "per_class", "micro"}) {
    Json changed = record;
    changed[key]["rows"] = changed[key]["rows"].get<int>() + 1;
    EXPECT_THROW(evaluation_from_record(changed), Json::exception) << key << " with too few values";
    changed[key]["rows"] = -1;
    EXPECT_THROW(evaluation_from_record(changed), Json::exception) << key;
  }
  EXPECT_THROW(evaluation_from_record(Json()), Json::exception);
}

}  // namespace
}  // namespace shapegauge
