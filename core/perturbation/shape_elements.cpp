#include "shapegauge/core/perturbation/shape_elements.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "shapegauge/core/error.h"

namespace shapegauge {

namespace {

/// Moves the rows that are not marked to the front and drops the others.
template <typename Rows>
void remove_rows(Rows& rows, const std::vector<bool>& removed) {
  Eigen::Index kept = 0;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    if (removed[static_cast<std::size_t>(i)]) continue;
    if (kept != i) rows.row(kept) = rows.row(i);
    ++kept;
  }
  rows.conservativeResize(kept, Eigen::NoChange);
}

}  // namespace

Eigen::Index element_count(const Shape& shape) {
  return is_cloud(shape) ? shape.vertices.rows() : shape.triangles.rows();
}

std::vector<bool> random_selection(Eigen::Index count, double fraction, RandomNumbers& random) {
  if (!(fraction >= 0 && fraction <= 1)) {
    throw InputError(fmt::format("a fraction of the shape's parts must be from 0 to 1, not {}", fraction));
  }
  std::vector<bool> selected(static_cast<std::size_t>(count));
  auto wanted = static_cast<double>(std::llround(fraction * static_cast<double>(count)));
  auto remaining = static_cast<double>(count);
  for (auto&& mark : selected) {
    mark = random.uniform(0, remaining) < wanted;
    if (mark) --wanted;
    --remaining;
  }
  return selected;
}

Shape without_elements(Shape shape, const std::vector<bool>& removed) {
  if (std::ranges::find(removed, false) == removed.end()) {
    throw InputError(fmt::format("nothing would be left of the shape's {} {}", removed.size(),
                                 is_cloud(shape) ? "points" : "faces"));
  }
  if (is_cloud(shape)) {
    remove_rows(shape.vertices, removed);
    if (shape.normals.rows() > 0) remove_rows(shape.normals, removed);
  } else {
    remove_rows(shape.triangles, removed);
  }
  return shape;
}

}  // namespace shapegauge
