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

Json intervals_json(const Evaluation& evaluation, const std::vector<ConfidenceInterval>& intervals) {
  Json json = Json::object();
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    json[evaluation.measures[i]] = {intervals[i].low, intervals[i].high};
  }
  return json;
}

}  // namespace

Json evaluation_json(const Evaluation& evaluation, std::span<const std::string> class_names,
                     const EvaluationIntervals& intervals) {
  Json per_class = Json::object();
  for (std::size_t i = 0; i < evaluation.classes.size(); ++i) {
    const std::string& name = class_names[static_cast<std::size_t>(evaluation.classes[i])];
    per_class[name] = measures_json(evaluation, evaluation.per_class.row(static_cast<Eigen::Index>(i)));
  }
  Json json{{"protocol", name_of(evaluation.protocol)},
            {"ties", name_of(evaluation.ties)},
            {"queries", evaluation.queries.size()},
            {"queries_with_ties", evaluation.queries_with_ties},
            {"models_never_queries", evaluation.models_left_out},
            {"micro", measures_json(evaluation, evaluation.micro)},
            {"macro", measures_json(evaluation, evaluation.macro)}};
  if (!intervals.micro.empty()) {
    json["intervals"] = {{"micro", intervals_json(evaluation, intervals.micro)},
                         {"macro", intervals_json(evaluation, intervals.macro)}};
  }
  json["per_class"] = std::move(per_class);
  return json;
}

}  // namespace shapegauge
