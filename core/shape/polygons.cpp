// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/shape/polygons.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "shapegauge/core/base/text.h"

namespace shapegauge {

namespace {

/// Returns the label with the largest total area.
std::int32_t largest(const std::map<std::int32_t, double>& area_of_label) {
  const auto less_area = [](const auto& a, const auto& b) { return a.second < b.second; };
  return std::ranges::max_element(area_of_label, less_area)->first;
}

}  // namespace

Eigen::Index polygon_count(const Shape& shape) {
  return has_polygons(shape) ? shape.polygons.count : shape.triangles.rows();
}

std::vector<double> polygon_shares(const Shape& shape) {
  std::vector<double> triangles(static_cast<std::size_t>(polygon_count(shape)), 0);
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    ++triangles[static_cast<std::size_t>(polygon_of(shape, f))];
  }
  std::vector<double> shares;
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    shares.push_back(1 / triangles[static_cast<std::size_t>(polygon_of(shape, f))]);
  }
  return shares;
}

std::vector<std::int32_t> labels_of_polygons(const Shape& shape, std::span<const std::int32_t> of_triangles) {
  if (!has_polygons(shape)) return {of_triangles.begin(), of_triangles.end()};
  const Eigen::VectorXd areas = triangle_areas(shape);
  std::vector<std::int32_t> labels(static_cast<std::size_t>(polygon_count(shape)), 0);
  std::map<std::int32_t, double> area_of_label;
  for (Eigen::Index f = 0; f < areas.size(); ++f) {
    const std::int32_t polygon = polygon_of(shape, f);
    area_of_label[of_triangles[static_cast<std::size_t>(f)]] += areas[f];
    const bool last = f + 1 == areas.size() || polygon_of(shape, f + 1) != polygon;
    if (!last) continue;
    labels[static_cast<std::size_t>(polygon)] = largest(area_of_label);
    area_of_label.clear();
  }
  return labels;
}

std::vector<std::int32_t> labels_of_triangles(const Shape& shape, std::span<const std::int32_t> of_polygons) {
  std::vector<std::int32_t> labels;
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    labels.push_back(of_polygons[static_cast<std::size_t>(polygon_of(shape, f))]);
  }
  return labels;
}

std::optional<std::string> polygon_note(const Shape& shape) {
  if (!has_polygons(shape)) return std::nullopt;
  return fmt::format("{} of the file became {}", count_text(polygon_count(shape), "face", "faces"),
                     count_text(shape.triangles.rows(), "triangle", "triangles"));
}

}  // namespace shapegauge
