// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/pages/score_json.h"

#include <nlohmann/json.hpp>
#include <vector>

#include "shapegauge/pages/html_page.h"

namespace shapegauge {
namespace {

Eigen::Map<const Eigen::VectorXd> vector_of(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

}  // namespace

nlohmann::ordered_json rounded_scores(const Eigen::Ref<const Eigen::VectorXd>& scores) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const double score : scores) json.push_back(rounded_to_digits(score, score_digits));
  return json;
}

nlohmann::ordered_json rounded_rows(const Eigen::MatrixXd& scores) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (Eigen::Index row = 0; row < scores.rows(); ++row) json.push_back(rounded_scores(scores.row(row).transpose()));
  return json;
}

nlohmann::ordered_json chart_data_json(const Evaluation& evaluation) {
  return {{"protocol", name_of(evaluation.protocol)},
          {"measures", evaluation.measures},
          {"micro", rounded_scores(evaluation.micro)},
          {"macro", rounded_scores(evaluation.macro)},
          {"classes", evaluation.classes},
          {"per_class", rounded_rows(evaluation.per_class)},
          {"recall", evaluation.micro_curve.recall},
          {"micro_curve", rounded_scores(vector_of(evaluation.micro_curve.precision))},
          {"macro_curve", rounded_scores(vector_of(evaluation.macro_curve.precision))}};
}

nlohmann::ordered_json table_json(const TextTable& table) {
  return {{"header", table.header}, {"text_columns", table.text_columns}, {"rows", table.rows}};
}

}  // namespace shapegauge
