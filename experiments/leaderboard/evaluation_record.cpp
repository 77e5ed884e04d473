#include "shapegauge/experiments/leaderboard/evaluation_record.h"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace shapegauge {

namespace {

using Json = nlohmann::json;

Json record_of(const Eigen::MatrixXd& matrix) {
  return {{"rows", matrix.rows()},
          {"columns", matrix.cols()},
          {"values", std::vector<double>(matrix.data(), matrix.data() + matrix.size())}};
}

Eigen::MatrixXd matrix_of(const Json& record) {
  const auto rows = record.at("rows").get<Eigen::Index>();
  const auto columns = record.at("columns").get<Eigen::Index>();
  const auto values = record.at("values").get<std::vector<double>>();
  // An index out of range throws as at() of JSON does.
  if (rows < 0 || columns < 0 || std::ssize(values) != rows * columns) static_cast<void>(Json::array().at(0));
  return Eigen::Map<const Eigen::MatrixXd>(values.data(), rows, columns);
}

Json record_of(const PrecisionRecallCurve& curve) { return {{"recall", curve.recall}, {"precision", curve.precision}}; }

PrecisionRecallCurve curve_of(const Json& record) {
  return {.recall = record.at("recall").get<std::vector<double>>(),
          .precision = record.at("precision").get<std::vector<double>>()};
}

}  // namespace

Json to_record(const Evaluation& evaluation) {
  Json class_curves = Json::array();
  for (const PrecisionRecallCurve& curve : evaluation.class_curves) class_curves.push_back(record_of(curve));
  return {{"protocol", name_of(evaluation.protocol)},
          {"ties", name_of(evaluation.ties)},
          {"curve", name_of(evaluation.curve)},
          {"measures", evaluation.measures},
          {"queries", evaluation.queries},
          {"query_classes", evaluation.query_classes},
          {"per_query", record_of(evaluation.per_query)},
          {"classes", evaluation.classes},
          {"per_class", record_of(evaluation.per_class)},
          {"micro", record_of(Eigen::MatrixXd(evaluation.micro))},
          {"macro", record_of(Eigen::MatrixXd(evaluation.macro))},
          {"micro_curve", record_of(evaluation.micro_curve)},
          {"macro_curve", record_of(evaluation.macro_curve)},
          {"class_curves", class_curves},
          {"models_left_out", evaluation.models_left_out},
          {"queries_with_ties", evaluation.queries_with_ties},
          {"pessimistic", evaluation.first_tier_bounds.pessimistic},
          {"optimistic", evaluation.first_tier_bounds.optimistic}};
}

Evaluation evaluation_from_record(const Json& record) {
  Evaluation evaluation;
  evaluation.protocol = protocol_of(record.at("protocol").get<std::string>()).value_or(Protocol::psb);
  evaluation.ties = ties_of(record.at("ties").get<std::string>()).value_or(Ties::index);
  evaluation.curve = curve_kind_of(record.at("curve").get<std::string>()).value_or(CurveKind::psb);
  record.at("measures").get_to(evaluation.measures);
  record.at("queries").get_to(evaluation.queries);
  record.at("query_classes").get_to(evaluation.query_classes);
  evaluation.per_query = matrix_of(record.at("per_query"));
  record.at("classes").get_to(evaluation.classes);
  evaluation.per_class = matrix_of(record.at("per_class"));
  evaluation.micro = matrix_of(record.at("micro"));
  evaluation.macro = matrix_of(record.at("macro"));
  evaluation.micro_curve = curve_of(record.at("micro_curve"));
  evaluation.macro_curve = curve_of(record.at("macro_curve"));
  for (const Json& curve : record.at("class_curves")) evaluation.class_curves.push_back(curve_of(curve));
  record.at("models_left_out").get_to(evaluation.models_left_out);
  record.at("queries_with_ties").get_to(evaluation.queries_with_ties);
  record.at("pessimistic").get_to(evaluation.first_tier_bounds.pessimistic);
  record.at("optimistic").get_to(evaluation.first_tier_bounds.optimistic);
  return evaluation;
}

}  // namespace shapegauge
