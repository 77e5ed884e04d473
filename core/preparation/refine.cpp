#include "shapegauge/core/preparation/refine.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <map>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

namespace {

using Corners = std::array<std::int32_t, 3>;
/// An edge between two places, the lesser first.
using Edge = std::pair<std::int32_t, std::int32_t>;

/// A mesh that grows. Vertices at the same place are known by the first.
class GrowingMesh {
 public:
  explicit GrowingMesh(const Shape& shape) : merged_(merged_by_place(shape.vertices)) {
    for (Eigen::Index v = 0; v < shape.vertices.rows(); ++v) vertices_.emplace_back(shape.vertices.row(v).transpose());
    for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
      triangles_.push_back({shape.triangles(f, 0), shape.triangles(f, 1), shape.triangles(f, 2)});
    }
  }

  /// Cuts the longest edges; says whether any was too long and there was room for all middles.
  bool cut(double longest, std::size_t most_vertices) {
    std::map<Edge, std::int32_t> middles;
    for (const Corners& corners : triangles_) {
      const int side = longest_side(corners);
      if (length(corners, side) > longest) middles.emplace(edge(corners, side), -1);
    }
    if (middles.empty() || vertices_.size() + middles.size() > most_vertices) return false;
    for (auto& [ends, middle] : middles) {
      middle = static_cast<std::int32_t>(vertices_.size());
      vertices_.emplace_back((at(ends.first) + at(ends.second)) / 2);
      merged_.push_back(middle);
    }
    std::vector<Corners> finer;
    for (const Corners& corners : triangles_) append_parts(corners, middles, finer);
    triangles_ = std::move(finer);
    return true;
  }

  [[nodiscard]] Shape shape() const {
    Shape shape;
    shape.vertices.resize(std::ssize(vertices_), 3);
    shape.triangles.resize(std::ssize(triangles_), 3);
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      shape.vertices.row(static_cast<Eigen::Index>(v)) = vertices_[v].transpose();
    }
    for (std::size_t f = 0; f < triangles_.size(); ++f) {
      const Corners& corners = triangles_[f];
      shape.triangles.row(static_cast<Eigen::Index>(f)) << corners[0], corners[1], corners[2];
    }
    return shape;
  }

 private:
  [[nodiscard]] const Eigen::Vector3d& at(std::int32_t vertex) const {
    return vertices_[static_cast<std::size_t>(vertex)];
  }

  /// Side k leads from corner k to the next.
  [[nodiscard]] Edge edge(const Corners& corners, int side) const {
    const auto place = [&](int corner) {
      return merged_[static_cast<std::size_t>(corners[static_cast<std::size_t>(corner % 3)])];
    };
    return std::minmax({place(side), place(side + 1)});
  }

  [[nodiscard]] double length(const Corners& corners, int side) const {
    const Edge ends = edge(corners, side);
    return (at(ends.first) - at(ends.second)).norm();
  }

  /// Of equal ones the same in all triangles, whatever their first corner.
  [[nodiscard]] int longest_side(const Corners& corners) const {
    const auto key = [&](int side) { return std::pair(length(corners, side), edge(corners, side)); };
    int longest = 0;
    for (const int side : {1, 2}) {
      if (key(longest) < key(side)) longest = side;
    }
    return longest;
  }

  /// Cuts a triangle at the middles of its sides, first of all at the longest of those.
  void append_parts(const Corners& corners, const std::map<Edge, std::int32_t>& middles,
                    std::vector<Corners>& parts) const {
    int cut = -1;
    for (int side = 0; side < 3; ++side) {
      if (!middles.contains(edge(corners, side))) continue;
      if (cut < 0 || length(corners, cut) < length(corners, side)) cut = side;
    }
    if (cut < 0) {
      parts.push_back(corners);
      return;
    }
    const std::int32_t middle = middles.at(edge(corners, cut));
    const auto corner = [&](int offset) { return corners[static_cast<std::size_t>((cut + offset) % 3)]; };
    append_parts({corner(0), middle, corner(2)}, middles, parts);
    append_parts({middle, corner(1), corner(2)}, middles, parts);
  }

  std::vector<Eigen::Vector3d> vertices_;
  std::vector<std::int32_t> merged_;
  std::vector<Corners> triangles_;
};

}  // namespace

Shape refined(Shape shape, const RefinementOptions& options) {
  if (!(options.longest_edge > 0 && options.longest_edge <= 10)) {
    throw InputError(
        fmt::format("the longest edge of a refined mesh must be above 0 and at most 10, in square roots of "
                    "the area, not {}",
                    options.longest_edge));
  }
  if (options.most_vertices < 3) {
    throw InputError(fmt::format("a refined mesh has at least 3 vertices, not {}", options.most_vertices));
  }
  require_usable(shape);
  const double longest = options.longest_edge * std::sqrt(surface_area(shape));
  if (!(longest > 0) || !std::isfinite(longest)) return shape;
  GrowingMesh mesh(shape);
  bool any = false;
  while (mesh.cut(longest, static_cast<std::size_t>(options.most_vertices))) any = true;
  return any ? mesh.shape() : shape;
}

}  // namespace shapegauge
