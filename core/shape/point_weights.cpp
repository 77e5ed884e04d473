#include "shapegauge/core/shape/point_weights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <numeric>
#include <vector>

#include "shapegauge/core/error.h"
#include "shapegauge/core/shape/point_neighbours.h"
#include "shapegauge/core/shape/unit_frame.h"

namespace shapegauge {

namespace {

// More neighbours see around corners and through thin parts. Of a regular grid whole shells lie at one distance, which
// makes single numbers of neighbours err by up to a third, their mean by a tenth.
constexpr Eigen::Index fewest_neighbours = 5;
constexpr Eigen::Index most_neighbours = 12;
// 4 is beyond the noise: fewer than 2 in 10,000 points of a surface, of random points or of a mesh, are above it.
constexpr double largest_ratio = 4;

/// The different places among points, in an order that only depends on the places.
struct Places {
  Points points;
  std::vector<Eigen::Index> place_of;   ///< of each of the original points
  std::vector<Eigen::Index> points_at;  ///< number of original points at each place
};

Places places_of(const Points& points) {
  const auto coordinates = [&](Eigen::Index i) { return std::array{points(i, 0), points(i, 1), points(i, 2)}; };
  std::vector<Eigen::Index> order(static_cast<std::size_t>(points.rows()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::ranges::sort(order, {}, coordinates);
  Places places{Points(points.rows(), 3), std::vector<Eigen::Index>(order.size()),
                std::vector<Eigen::Index>(order.size())};
  Eigen::Index count = 0;
  for (const Eigen::Index i : order) {
    if (count == 0 || places.points.row(count - 1) != points.row(i)) places.points.row(count++) = points.row(i);
    places.place_of[static_cast<std::size_t>(i)] = count - 1;
    ++places.points_at[static_cast<std::size_t>(count - 1)];
  }
  places.points.conservativeResize(count, 3);
  return places;
}

void require_finite(const Points& points, double diagonal) {
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (!points.row(i).allFinite()) {
      throw InputError(fmt::format("point {} has a coordinate that is not a finite number", i));
    }
  }
  if (!std::isfinite(diagonal)) throw InputError("the extent of the points is too large for a number");
}

/// Mean over numbers of neighbours k of pi d^2 / k, d being the distance to the k-th.
Eigen::VectorXd disc_areas(const PointNeighbours& nearest) {
  const Eigen::Index most = nearest.distances.cols();
  const Eigen::Index fewest = std::min(fewest_neighbours, most);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(nearest.distances.rows());
  for (Eigen::Index k = fewest; k <= most; ++k) {
    sum += nearest.distances.col(k - 1).cwiseAbs2() / static_cast<double>(k);
  }
  return std::numbers::pi * sum / static_cast<double>(most - fewest + 1);
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The weights, none more than `largest_ratio` times the median of its neighbours'.
Eigen::VectorXd capped(const Eigen::VectorXd& weights, const PointNeighbours& nearest) {
  Eigen::VectorXd result = weights;
  std::vector<double> around(static_cast<std::size_t>(nearest.indices.cols()));
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    for (std::size_t k = 0; k < around.size(); ++k) {
      around[k] = weights[nearest.indices(i, static_cast<Eigen::Index>(k))];
    }
    result[i] = std::min(weights[i], largest_ratio * median(around));
  }
  return result;
}

}  // namespace

Eigen::VectorXd point_weights(const Points& points) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(points.rows());
  const UnitFrame frame = unit_frame({points, {}, {}});
  require_finite(points, frame.diagonal);
  Places places = places_of(points);
  if (places.points.rows() < 2) return weights;
  // In coordinates near 1, squares neither vanish nor overflow.
  for (Eigen::Index i = 0; i < places.points.rows(); ++i) {
    places.points.row(i) = frame.to_unit(places.points.row(i).transpose()).transpose();
  }
  const PointNeighbours nearest = nearest_neighbours(places.points, most_neighbours);
  const Eigen::VectorXd of_places = capped(disc_areas(nearest), nearest);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Index place = places.place_of[static_cast<std::size_t>(i)];
    const auto sharing = static_cast<double>(places.points_at[static_cast<std::size_t>(place)]);
    weights[i] = of_places[place] / sharing * frame.diagonal * frame.diagonal;
  }
  return weights;
}

}  // namespace shapegauge
