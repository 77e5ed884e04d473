#include "shapegauge/core/preparation/taubin_smoothing.h"

#include <cmath>
#include <fmt/format.h>

#include "shapegauge/core/error.h"

namespace shapegauge {

namespace {

/// Moves every vertex towards the mean of its neighbours, by a fraction of the way (away from it where negative).
void step(Points& vertices, Points& before, const VertexNeighbours& neighbours, double fraction) {
  before = vertices;
  for (Eigen::Index v = 0; v < vertices.rows(); ++v) {
    const auto around = neighbours.of(v);
    if (around.empty()) continue;
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (const std::int32_t u : around) sum += before.row(u);
    vertices.row(v) += fraction * (sum / static_cast<double>(around.size()) - before.row(v));
  }
}

}  // namespace

Points taubin_smoothed(const Points& vertices, const VertexNeighbours& neighbours, double pass_band) {
  if (!(pass_band > 0 && pass_band < 1)) {
    throw InputError(fmt::format("the pass band of the smoothing is {}: it must lie between 0 and 1", pass_band));
  }
  constexpr double inward = 0.5;
  const double outward = 1 / (pass_band - 1 / inward);  // 1 / inward + 1 / outward = pass_band
  const int rounds = static_cast<int>(std::ceil(2 / pass_band)) + 3;
  Points smoothed = vertices;
  Points before;
  for (int round = 0; round < rounds; ++round) {
    step(smoothed, before, neighbours, inward);
    step(smoothed, before, neighbours, outward);
  }
  return smoothed;
}

}  // namespace shapegauge
