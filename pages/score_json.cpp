#include "shapegauge/pages/score_json.h"

namespace shapegauge {

nlohmann::ordered_json rounded_rows(const Eigen::MatrixXd& scores) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (Eigen::Index row = 0; row < scores.rows(); ++row) json.push_back(rounded_scores(scores.row(row)));
  return json;
}

nlohmann::ordered_json charted_json(const Evaluation& evaluation) {
  return {{"protocol", name_of(evaluation.protocol)},
          {"measures", evaluation.measures},
          {"micro", rounded_scores(evaluation.micro)},
          {"macro", rounded_scores(evaluation.macro)},
          {"classes", evaluation.classes},
          {"per_class", rounded_rows(evaluation.per_class)},
          {"recall", evaluation.micro_curve.recall},
          {"micro_curve", rounded_scores(evaluation.micro_curve.precision)},
          {"macro_curve", rounded_scores(evaluation.macro_curve.precision)}};
}

}  // namespace shapegauge
