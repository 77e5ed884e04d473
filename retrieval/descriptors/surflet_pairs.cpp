// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/descriptors/surflet_pairs.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/fields/proxy_source.h"
#include "shapegauge/retrieval/l1_distance.h"

namespace shapegauge {

namespace {

constexpr std::array surflet_pairs_table = {
    option_of<&SurfletPairsOptions::distance_bins>("distance_bins", {.low = 2, .high = 64},
                                                   "Number of bins for the distance between two points."),
    option_of<&SurfletPairsOptions::angle_bins>(
        "angle_bins", {.low = 2, .high = 16},
        "Number of bins for each of three cosines: between the two normals, and between each normal and the connecting "
        "line."),
    option_of<&SurfletPairsOptions::largest_distance>(
        "largest_distance", {.low = 1, .high = 100},
        "Upper end of the distance bins, in multiples of the shape's mean pair distance; larger distances count in the "
        "last bin."),
};
constexpr auto surflet_pairs_parameters = parameters_of(surflet_pairs_table);

constexpr std::size_t dimensions = 4;

/// Histogram over the unit cube of several dimensions, with multilinear weights.
class MultilinearHistogram {
 public:
  explicit MultilinearHistogram(const std::array<int, dimensions>& bins)
      : bins_(bins),
        shares_(Eigen::VectorXd::Zero(std::accumulate(bins.begin(), bins.end(), Eigen::Index{1}, std::multiplies()))) {
    Eigen::Index stride = 1;
    for (std::size_t d = dimensions; d-- > 0;) {
      strides_[d] = stride;
      stride *= bins[d];
    }
  }

  void add(const std::array<double, dimensions>& point, double weight) {
    Eigen::Index first = 0;
    std::array<double, dimensions> upper{};  // weight of the upper of two bins
    for (std::size_t d = 0; d < dimensions; ++d) {
      const double position = std::clamp(point[d] * bins_[d] - 0.5, 0.0, bins_[d] - 1.0);
      const int below = std::min(static_cast<int>(position), bins_[d] - 2);
      upper[d] = position - below;
      first += below * strides_[d];
    }
    for (unsigned corner = 0; corner < 1U << dimensions; ++corner) {
      const std::bitset<dimensions> above(corner);
      Eigen::Index bin = first;
      double share = weight;
      for (std::size_t d = 0; d < dimensions; ++d) {
        bin += above[d] ? strides_[d] : 0;
        share *= above[d] ? upper[d] : 1 - upper[d];
      }
      shares_[bin] += share;
    }
  }

  /// Returns the square roots of the normalised bins.
  [[nodiscard]] Eigen::VectorXf square_roots() const { return (shares_ / shares_.sum()).cwiseSqrt().cast<float>(); }

 private:
  std::array<int, dimensions> bins_;
  std::array<Eigen::Index, dimensions> strides_{};
  Eigen::VectorXd shares_;
};

/// Calls visit(i, j, distance, weight) for each pair of landmarks at different positions.
template <typename Visit>
void for_each_pair(const Points& points, const Eigen::VectorXd& areas, const Visit& visit) {
  for (Eigen::Index i = 0; i < areas.size(); ++i) {
    for (Eigen::Index j = i + 1; j < areas.size(); ++j) {
      const double distance = (points.row(j) - points.row(i)).norm();
      if (distance > 0) visit(i, j, distance, areas[i] * areas[j]);
    }
  }
}

/// Returns the weighted mean distance of the pairs; NaN if there are none.
double mean_pair_distance(const Points& points, const Eigen::VectorXd& areas) {
  double sum = 0;
  double total = 0;
  for_each_pair(points, areas, [&](Eigen::Index, Eigen::Index, double distance, double weight) {
    sum += weight * distance;
    total += weight;
  });
  return sum / total;
}

}  // namespace

Eigen::VectorXf surflet_pairs(ProxySource& source, const SurfletPairsOptions& options) {
  check_options("surflet_pairs", surflet_pairs_table, options);
  const Eigen::VectorXd areas = source.geodesics().areas / source.geodesics().areas.sum();
  const Points& points = source.proxy().points;
  const Points& normals = source.proxy().normals;
  const double mean = mean_pair_distance(points, areas);
  if (!(mean > 0))
    throw InputError("the descriptor surflet_pairs needs a shape with extent; check it for coincident points");
  check_interruption();
  MultilinearHistogram histogram({options.distance_bins, options.angle_bins, options.angle_bins, options.angle_bins});
  for_each_pair(points, areas, [&](Eigen::Index i, Eigen::Index j, double distance, double weight) {
    const Eigen::RowVector3d line = (points.row(j) - points.row(i)) / distance;
    const auto [lesser, greater] =
        std::minmax({std::abs(normals.row(i).dot(line)), std::abs(normals.row(j).dot(line))});
    histogram.add(
        {distance / mean / options.largest_distance, std::abs(normals.row(i).dot(normals.row(j))), greater, lesser},
        weight);
  });
  return histogram.square_roots();
}

Descriptor surflet_pairs_descriptor() {
  return {.name = "surflet_pairs",
          .description = "Distances and angles of pairs of points with normals (after Wahl et al. 2003).",
          .parameters = surflet_pairs_parameters,
          .version = version_on_proxy(1),
          .describe =
              [](const DescriptorInput& input, const LearntFeatures&, const DescriptorSettings& settings) {
                const SurfletPairsOptions options = options_from(surflet_pairs_table, settings.values);
                return call_with_proxy(input, [&](ProxySource& source) { return surflet_pairs(source, options); });
              },
          .distance = l1_distance};
}

}  // namespace shapegauge
