#include "shapegauge/core/shape/point_neighbours.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nanoflann.hpp>
#include <tbb/parallel_for.h>
#include <vector>

namespace shapegauge {

namespace {

/// The points as nanoflann asks for them.
struct PointSource {
  const Points& points;

  [[nodiscard]] std::size_t kdtree_get_point_count() const { return static_cast<std::size_t>(points.rows()); }
  [[nodiscard]] double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return points(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(axis));
  }
  template <typename Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;  // the tree finds it
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointSource>, PointSource, 3,
                                                 std::int32_t>;

/// Room for the answer to one query, the point itself included.
struct Query {
  explicit Query(std::size_t count) : indices(count), squared_distances(count) {}
  std::vector<std::int32_t> indices;
  std::vector<double> squared_distances;
};

void find(const Tree& tree, const Points& points, Eigen::Index i, PointNeighbours& result) {
  const auto count = static_cast<std::size_t>(result.indices.cols() + 1);
  Query query(count);
  tree.knnSearch(points.row(i).data(), count, query.indices.data(), query.squared_distances.data());
  // Where so many points are at its place that the point itself is not among those found, the last one goes.
  const auto self = std::find(query.indices.begin(), query.indices.end() - 1, static_cast<std::int32_t>(i));
  const std::ptrdiff_t place = self - query.indices.begin();
  query.indices.erase(self);
  query.squared_distances.erase(query.squared_distances.begin() + place);
  std::ranges::copy(query.indices, result.indices.row(i).data());
  std::ranges::transform(query.squared_distances, result.distances.row(i).data(),
                         [](double d) { return std::sqrt(d); });
}

}  // namespace

PointNeighbours nearest_neighbours(const Points& points, Eigen::Index k) {
  const Eigen::Index n = points.rows();
  k = std::clamp<Eigen::Index>(k, 0, std::max<Eigen::Index>(n - 1, 0));
  PointNeighbours result;
  result.indices.resize(n, k);
  result.distances.resize(n, k);
  if (k == 0) return result;
  const PointSource source{points};
  const Tree tree(3, source);
  tbb::parallel_for(tbb::blocked_range<Eigen::Index>(0, n, 256), [&](const tbb::blocked_range<Eigen::Index>& block) {
    for (Eigen::Index i = block.begin(); i != block.end(); ++i) find(tree, points, i, result);
  });
  return result;
}

}  // namespace shapegauge
