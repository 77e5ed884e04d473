#include "shapegauge/experiments/results/evaluation_json.h"

namespace shapegauge {

namespace {

using Json = nlohmann::ordered_json;

Json measures_json(const Evaluation& evaluation, const Eigen::VectorXd& values) {
  Json json = Json::object();
  for (std::size_t i = 0; i < evaluation.measures.size(); ++i) {
    json[evaluation.measures[i]] = values[static_cast<Eigen::Index>(i)];
  }
  return json;
}

}  // namespace

Json evaluation_json(const Evaluation& evaluation, std::span<const std::string> class_names) {
  Json per_class = Json::object();
  for (std::size_t i = 0; i < evaluation.classes.size(); ++i) {
    const std::string& name = class_names[static_cast<std::size_t>(evaluation.classes[i])];
    per_class[name] = measures_json(evaluation, evaluation.per_class.row(static_cast<Eigen::Index>(i)));
  }
  return {{"protocol", name_of(evaluation.protocol)},
          {"ties", "index"},
          {"queries", evaluation.queries.size()},
          {"models_never_queries", evaluation.models_left_out},
          {"micro", measures_json(evaluation, evaluation.micro)},
          {"macro", measures_json(evaluation, evaluation.macro)},
          {"per_class", std::move(per_class)}};
}

}  // namespace shapegauge
