// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/preparation/outliers.h"

#include <algorithm>
#include <fmt/format.h>

#include "shapegauge/core/base/median.h"
#include "shapegauge/core/shape/point_cloud.h"

namespace shapegauge {

std::vector<bool> outliers(const Shape& shape) {
  constexpr double max_distance = 10;  // of the sixth neighbour, in point spacings
  constexpr double max_fraction = 0.01;
  require_usable(shape);
  std::vector<bool> marked(static_cast<std::size_t>(shape.vertices.rows()));
  if (!is_cloud(shape) || marked.empty()) return marked;
  const std::vector<double> distances = distances_to_sixth_neighbour(shape.vertices);
  std::vector<double> reordered = distances;
  const double limit = max_distance * lower_quantile(reordered, 0.5);
  if (!(limit > 0) || lower_quantile(reordered, 1 - max_fraction) > limit) return marked;
  for (std::size_t i = 0; i < marked.size(); ++i) marked[i] = distances[i] > limit;
  return marked;
}

std::size_t outlier_count(const Shape& shape) {
  return static_cast<std::size_t>(std::ranges::count(outliers(shape), true));
}

std::string outlier_text(std::size_t count, Eigen::Index points) {
  return fmt::format("{} of {} points are outliers, more than 10 point spacings from their neighbours", count, points);
}

std::optional<std::string> outlier_warning(const Shape& shape) {
  const std::size_t count = outlier_count(shape);
  if (count == 0) return std::nullopt;
  return outlier_text(count, shape.vertices.rows()) +
         ": the size and the area of the shape are too large; use `remove_outliers=true`";
}

Shape without_outliers(Shape shape) {
  const std::vector<bool> marked = outliers(shape);
  std::vector<Eigen::Index> inliers;
  for (std::size_t i = 0; i < marked.size(); ++i) {
    if (!marked[i]) inliers.push_back(static_cast<Eigen::Index>(i));
  }
  if (inliers.size() == marked.size()) return shape;
  shape.vertices = shape.vertices(inliers, Eigen::all).eval();
  if (shape.normals.rows() > 0) shape.normals = shape.normals(inliers, Eigen::all).eval();
  return shape;
}

}  // namespace shapegauge
