// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/metrics/naive_evaluation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapegauge::naive {
namespace {

// Returns true if all models but the query are infinitely far from it.
bool finds_nothing(const Matrix& distances, int query) {
  for (int model = 0; model < distances.cols(); ++model) {
    if (model != query && distances(query, model) < std::numeric_limits<double>::infinity()) return false;
  }
  return true;
}

// h[i], for ranks i = 1 ... of the list without the query, which is empty if it finds nothing. h[0] is not used.
std::vector<int> hits_without_query(const Matrix& distances, const std::vector<int>& labels, int query,
                                    const std::vector<int>& tie_order) {
  const auto tie_rank = [&](int model) {
    return tie_order.empty() ? model : tie_order.at(static_cast<std::size_t>(model));
  };
  if (finds_nothing(distances, query)) return {0};
  const int count = static_cast<int>(labels.size());
  std::vector<int> h(labels.size(), 0);
  for (int model = 0; model < count; ++model) {
    if (model == query) continue;
    int rank = 1;
    for (int other = 0; other < count; ++other) {
      if (other == query || other == model) continue;
      const bool nearer = distances(query, other) < distances(query, model);
      const bool tied_and_earlier =
          distances(query, other) == distances(query, model) && tie_rank(other) < tie_rank(model);
      if (nearer || tied_and_earlier) ++rank;
    }
    h.at(static_cast<std::size_t>(rank)) =
        labels.at(static_cast<std::size_t>(model)) == labels.at(static_cast<std::size_t>(query));
  }
  return h;
}

int length(const std::vector<int>& h) { return static_cast<int>(h.size()) - 1; }

// Ranks beyond the end of the list are misses.
double sum_of_first(const std::vector<int>& h, int last) {
  double sum = 0;
  for (int i = 1; i <= std::min(last, length(h)); ++i) sum += h.at(static_cast<std::size_t>(i));
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

std::vector<double> psb_measures(const std::vector<int>& h, int relevant) {
  const int k = std::min(32, length(h));
  const std::vector<int> all_hits(static_cast<std::size_t>(relevant) + 1, 1);
  return {sum_of_first(h, 1),
          sum_of_first(h, relevant) / relevant,
          sum_of_first(h, 2 * relevant) / relevant,
          2 * sum_of_first(h, k) / (k + relevant),
          discounted(h, length(h)) / discounted(all_hits, relevant),
          average_precision(h, length(h), relevant)};
}

std::vector<int> with_query_in_front(const std::vector<int>& h) {
  std::vector<int> longer = {0, 1};
  for (std::size_t i = 1; i < h.size(); ++i) longer.push_back(h[i]);
  return longer;
}

// `h` is the list with the query in front.
std::vector<double> paper_measures(const std::vector<int>& h, int class_size) {
  const int k = std::min(32, length(h));
  const double precision = sum_of_first(h, k) / k;
  const double recall = sum_of_first(h, k) / class_size;
  const std::vector<int> all_hits(static_cast<std::size_t>(class_size) + 1, 1);
  return {sum_of_first(h, 2) - 1,
          sum_of_first(h, class_size) / class_size,
          sum_of_first(h, 2 * class_size) / class_size,
          2 / (1 / precision + 1 / recall),
          discounted(h, length(h)) / discounted(all_hits, class_size),
          average_precision(h, length(h), class_size)};
}

int size_of_class(const std::vector<int>& labels, int query) {
  return static_cast<int>(std::ranges::count(labels, labels.at(static_cast<std::size_t>(query))));
}

// Points (recall, precision) at the hits; the precision at those that are not in the list is 0.
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
  while (std::ssize(points) < relevant) points.push_back({(std::ssize(points) + 1.0) / relevant, 0});
  return points;
}

constexpr double between_recalls = 1e-9;  // far below any difference between two recalls, far above their rounding

double interpolated(const std::vector<Point>& points, double recall) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::abs(points[i].recall - recall) < between_recalls) return points[i].precision;
    if (i == 0 || recall > points[i].recall || recall < points[i - 1].recall) continue;
    const double fraction = (recall - points[i - 1].recall) / (points[i].recall - points[i - 1].recall);
    return (1 - fraction) * points[i - 1].precision + fraction * points[i].precision;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double last_reached(const std::vector<Point>& points, double recall) {
  double precision = 1;  // the point (0, 1)
  for (const Point& point : points) {
    if (point.recall <= recall + between_recalls) precision = point.precision;
  }
  return precision;
}

double largest_from(const std::vector<Point>& points, double recall) {
  double precision = 0;
  for (const Point& point : points) {
    if (point.recall >= recall - between_recalls) precision = std::max(precision, point.precision);
  }
  return precision;
}

double reciprocal_rank(const std::vector<int>& h) {
  for (int i = 1; i <= length(h); ++i) {
    if (h.at(static_cast<std::size_t>(i)) == 1) return 1.0 / i;
  }
  return 0;
}

double area_below(const std::vector<Point>& points) {
  double area = points.front().recall * points.front().precision;
  for (std::size_t i = 1; i < points.size(); ++i) {
    area += (points[i].recall - points[i - 1].recall) * (points[i].precision + points[i - 1].precision) / 2;
  }
  return area;
}

// P@1, P@5, R@3, R@9, F1@4, MRR, nDCG, R-prec, AUC-PR.
std::vector<double> text_retrieval_measures(const std::vector<int>& h, int relevant) {
  const auto precision = [&](int k) { return sum_of_first(h, k) / k; };
  const auto recall = [&](int k) { return sum_of_first(h, k) / relevant; };
  const double f1 = precision(4) > 0 ? 2 / (1 / precision(4) + 1 / recall(4)) : 0;
  double gained = 0;
  double ideal = 0;
  for (int i = 1; i <= length(h); ++i) gained += h.at(static_cast<std::size_t>(i)) / std::log2(i + 1);
  for (int i = 1; i <= relevant; ++i) ideal += 1 / std::log2(i + 1);
  return {precision(1),
          precision(5),
          recall(3),
          recall(9),
          f1,
          reciprocal_rank(h),
          gained / ideal,
          recall(relevant),
          area_below(points_at_hits(h, relevant))};
}

// `h` is the list with the query in front.
double bulls_eye(const std::vector<int>& h, int class_size) { return sum_of_first(h, 2 * class_size) / class_size; }

}  // namespace

std::vector<std::string> measure_names() {
  return {"NN",  "FT",  "ST",   "E",   "DCG",  "mAP",    "P@1",    "P@5",
          "R@3", "R@9", "F1@4", "MRR", "nDCG", "R-prec", "AUC-PR", "BEP"};
}

std::vector<double> measures_of(const Matrix& distances, const std::vector<int>& labels, int query, Protocol protocol,
                                const std::vector<int>& tie_order) {
  const std::vector<int> h = hits_without_query(distances, labels, query, tie_order);
  if (length(h) == 0) return std::vector<double>(measure_names().size(), 0);  // no answer
  const int class_size = size_of_class(labels, query);
  const bool paper = protocol == Protocol::paper;
  const std::vector<int> judged = paper ? with_query_in_front(h) : h;
  const int relevant = paper ? class_size : class_size - 1;
  std::vector<double> values = paper ? paper_measures(judged, class_size) : psb_measures(h, relevant);
  for (const double value : text_retrieval_measures(judged, relevant)) values.push_back(value);
  values.push_back(bulls_eye(with_query_in_front(h), class_size));
  return values;
}

std::vector<double> precisions_of(const Matrix& distances, const std::vector<int>& labels, int query,
                                  Protocol protocol) {
  const std::vector<int> h = hits_without_query(distances, labels, query, {});
  const int class_size = size_of_class(labels, query);
  std::vector<double> precisions;
  if (length(h) == 0) {  // no answer: 0, where the protocol defines something
    const bool psb = protocol == Protocol::psb;
    for (int j = psb ? 1 : 0; j <= (psb ? 20 : 10); ++j) {
      precisions.push_back(psb && j * (class_size - 1) < 20 ? std::numeric_limits<double>::quiet_NaN() : 0);
    }
    return precisions;
  }
  if (protocol == Protocol::psb) {
    for (int j = 1; j <= 20; ++j) precisions.push_back(interpolated(points_at_hits(h, class_size - 1), 0.05 * j));
    return precisions;
  }
  if (protocol == Protocol::trec) {
    for (int j = 0; j <= 10; ++j) precisions.push_back(largest_from(points_at_hits(h, class_size - 1), 0.1 * j));
    return precisions;
  }
  const std::vector<Point> points = points_at_hits(with_query_in_front(h), class_size);
  for (int j = 0; j <= 10; ++j) precisions.push_back(last_reached(points, 0.1 * j));
  return precisions;
}

}  // namespace shapegauge::naive
