#include "shapegauge/experiments/comparison/value_errors.h"

#include <cmath>
#include <limits>
#include <tbb/parallel_for.h>
#include <vector>

#include "shapegauge/core/shape/unit_frame.h"
#include "shapegauge/core/spatial/surface_tree.h"
#include "shapegauge/experiments/comparison/weighted_quantile.h"

namespace shapegauge {

namespace {

/// The value of the reference nearest to each point.
Eigen::VectorXd nearest_values(const Points& points, const PlacedValues& reference) {
  const Shape sites{.vertices = reference.points, .triangles = {}};
  const UnitFrame frame = unit_frame(sites);
  const SurfaceTree tree(in_unit_frame(sites, frame));
  Eigen::VectorXd nearest(points.rows());
  tbb::parallel_for(Eigen::Index{0}, points.rows(), [&](Eigen::Index i) {
    const auto hit = tree.closest(frame.to_unit(points.row(i).transpose()));
    nearest[i] = reference.values[hit.value().triangle];
  });
  return nearest;
}

}  // namespace

PlacedValues placed_values(const Samples& samples, const Eigen::VectorXd& values, double unit) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i]) && samples.weights[i] > 0) kept.push_back(i);
  }
  return {.points = samples.points(kept, Eigen::all) * unit, .values = values(kept) * unit};
}

ValueErrors value_errors(const PlacedValues& placed, const PlacedValues& reference, double reference_diagonal) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (placed.values.size() == 0 || reference.values.size() == 0) return {none, none, none, none};
  const Eigen::VectorXd expected = nearest_values(placed.points, reference);
  const Eigen::VectorXd errors = (placed.values - expected).cwiseAbs();
  // Without an error there is none relative to a value of 0 either.
  const Eigen::VectorXd relative =
      errors.binaryExpr(expected, [](double error, double value) { return error == 0 ? 0 : error / value; });
  const Eigen::VectorXd once = Eigen::VectorXd::Ones(errors.size());
  return {.median = weighted_quantile(errors, once, 0.5) / reference_diagonal,
          .percentile_90 = weighted_quantile(errors, once, 0.9) / reference_diagonal,
          .relative_median = weighted_quantile(relative, once, 0.5),
          .relative_percentile_90 = weighted_quantile(relative, once, 0.9)};
}

}  // namespace shapegauge
