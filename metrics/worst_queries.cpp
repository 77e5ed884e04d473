#include "shapegauge/metrics/worst_queries.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

namespace shapegauge {

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
