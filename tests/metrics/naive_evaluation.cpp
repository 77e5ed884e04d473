#include "tests/metrics/naive_evaluation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapegauge::naive {
namespace {

// h[i], for ranks i = 1 ... of the list without the query. h[0] is not used.
std::vector<int> hits_without_query(const Matrix& distances, const std::vector<int>& labels, int query) {
  const int count = static_cast<int>(labels.size());
  std::vector<int> h(labels.size(), 0);
  for (int model = 0; model < count; ++model) {
    if (model == query) continue;
    int rank = 1;
    for (int other = 0; other < count; ++other) {
      if (other == query || other == model) continue;
      const bool nearer = distances(query, other) < distances(query, model);
      const bool tied_and_earlier = distances(query, other) == distances(query, model) && other < model;
      if (nearer || tied_and_earlier) ++rank;
    }
    h.at(static_cast<std::size_t>(rank)) =
        labels.at(static_cast<std::size_t>(model)) == labels.at(static_cast<std::size_t>(query));
  }
  return h;
}

double sum_of_first(const std::vector<int>& h, int last) {
  double sum = 0;
  for (int i = 1; i <= last; ++i) sum += h.at(static_cast<std::size_t>(i));
  return sum;
}

double discounted(const std::vector<int>& h, int last) {
  double sum = last >= 1 ? h.at(1) : 0;
  for (int i = 2; i <= last; ++i) sum += h.at(static_cast<std::size_t>(i)) / std::log2(i);
  return sum;
}

double average_precision(const std::vector<int>& h, int last, int relevant) {
  double sum = 0;
  for (int i = 1; i <= last; ++i) {
    if (h.at(static_cast<std::size_t>(i)) == 1) sum += sum_of_first(h, i) / i;
  }
  return sum / relevant;
}

std::vector<double> psb_measures(const std::vector<int>& h, int models, int class_size) {
  const int relevant = class_size - 1;
  const int k = std::min(32, models - 1);
  const std::vector<int> all_hits(static_cast<std::size_t>(relevant) + 1, 1);
  return {static_cast<double>(h.at(1)),
          sum_of_first(h, relevant) / relevant,
          sum_of_first(h, std::min(2 * relevant, models - 1)) / relevant,
          2 * sum_of_first(h, k) / (k + relevant),
          discounted(h, models - 1) / discounted(all_hits, relevant),
          average_precision(h, models - 1, relevant)};
}

std::vector<int> with_query_in_front(const std::vector<int>& h) {
  std::vector<int> longer = {0, 1};
  for (std::size_t i = 1; i < h.size(); ++i) longer.push_back(h[i]);
  return longer;
}

// `h` is the list with the query in front.
std::vector<double> paper_measures(const std::vector<int>& h, int models, int class_size) {
  const int k = std::min(32, models);
  const double precision = sum_of_first(h, k) / k;
  const double recall = sum_of_first(h, k) / class_size;
  const std::vector<int> all_hits(static_cast<std::size_t>(class_size) + 1, 1);
  return {static_cast<double>(h.at(2)),
          sum_of_first(h, class_size) / class_size,
          sum_of_first(h, std::min(2 * class_size, models)) / class_size,
          2 / (1 / precision + 1 / recall),
          discounted(h, models) / discounted(all_hits, class_size),
          average_precision(h, models, class_size)};
}

int size_of_class(const std::vector<int>& labels, int query) {
  return static_cast<int>(std::ranges::count(labels, labels.at(static_cast<std::size_t>(query))));
}

// Points (recall, precision) at the hits.
struct Point {
  double recall;
  double precision;
};

std::vector<Point> points_at_hits(const std::vector<int>& h, int relevant) {
  std::vector<Point> points;
  for (int i = 1; i < static_cast<int>(h.size()); ++i) {
    if (h.at(static_cast<std::size_t>(i)) == 0) continue;
    points.push_back({sum_of_first(h, i) / relevant, sum_of_first(h, i) / i});
  }
  return points;
}

constexpr double rounding = 1e-9;  // far below any difference between two recalls, far above their rounding

double interpolated(const std::vector<Point>& points, double recall) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::abs(points[i].recall - recall) < rounding) return points[i].precision;
    if (i == 0 || recall > points[i].recall || recall < points[i - 1].recall) continue;
    const double fraction = (recall - points[i - 1].recall) / (points[i].recall - points[i - 1].recall);
    return (1 - fraction) * points[i - 1].precision + fraction * points[i].precision;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double last_reached(const std::vector<Point>& points, double recall) {
  double precision = 1;  // the point (0, 1)
  for (const Point& point : points) {
    if (point.recall <= recall + rounding) precision = point.precision;
  }
  return precision;
}

}  // namespace

std::vector<double> measures_of(const Matrix& distances, const std::vector<int>& labels, int query, Protocol protocol) {
  const std::vector<int> h = hits_without_query(distances, labels, query);
  const int models = static_cast<int>(labels.size());
  const int class_size = size_of_class(labels, query);
  return protocol == Protocol::psb ? psb_measures(h, models, class_size)
                                   : paper_measures(with_query_in_front(h), models, class_size);
}

std::vector<double> precisions_of(const Matrix& distances, const std::vector<int>& labels, int query,
                                  Protocol protocol) {
  const std::vector<int> h = hits_without_query(distances, labels, query);
  const int class_size = size_of_class(labels, query);
  std::vector<double> precisions;
  if (protocol == Protocol::psb) {
    for (int j = 1; j <= 20; ++j) precisions.push_back(interpolated(points_at_hits(h, class_size - 1), 0.05 * j));
    return precisions;
  }
  const std::vector<Point> points = points_at_hits(with_query_in_front(h), class_size);
  for (int j = 0; j <= 10; ++j) precisions.push_back(last_reached(points, 0.1 * j));
  return precisions;
}

}  // namespace shapegauge::naive
