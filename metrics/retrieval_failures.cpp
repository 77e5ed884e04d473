#include "shapegauge/metrics/retrieval_failures.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tbb/parallel_for.h>
#include <vector>

#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {

Eigen::MatrixXi confusion_matrix(const DistanceTable& distances, std::span<const int> labels,
                                 std::span<const Eigen::Index> queries, int classes) {
  const Eigen::Index models = distances.rows();
  if (models != distances.cols() || static_cast<std::size_t>(models) != labels.size() || models < 2) {
    throw std::invalid_argument("a confusion matrix needs two models or more, and a class and distances for each");
  }
  const auto is_class = [&](int label) { return label >= 0 && label < classes; };
  const auto is_model = [&](Eigen::Index query) { return query >= 0 && query < models; };
  if (!std::ranges::all_of(labels, is_class)) throw std::invalid_argument("a label is not the number of a class");
  if (!std::ranges::all_of(queries, is_model)) throw std::invalid_argument("a query is not a row of the matrix");

  std::vector<int> answers(queries.size());
  tbb::parallel_for(std::size_t{0}, queries.size(), [&](std::size_t i) {
    answers[i] = labels[static_cast<std::size_t>(ranked_models(distances, queries[i]).front())];
  });
  Eigen::MatrixXi confusion = Eigen::MatrixXi::Zero(classes, classes);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    ++confusion(labels[static_cast<std::size_t>(queries[i])], answers[i]);
  }
  return confusion;
}

std::vector<std::size_t> worst_queries(const Evaluation& evaluation, std::string_view measure, std::size_t count) {
  const auto column = std::ranges::find(evaluation.measures, measure);
  if (column == evaluation.measures.end()) {
    throw std::invalid_argument("the evaluation has no measure " + std::string(measure));
  }
  const auto values = evaluation.per_query.col(column - evaluation.measures.begin());
  std::vector<std::size_t> order(evaluation.queries.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[static_cast<Eigen::Index>(i)]; });
  order.resize(std::min(count, order.size()));
  return order;
}

}  // namespace shapegauge
