// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/sdf/offset_sdf.h"

#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/core/offset/offset_solver.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

namespace {

void require_extent(const Shape& shape) {
  const double diagonal = bounding_box_diagonal(shape);
  if (diagonal > 0 && std::isfinite(diagonal)) return;
  throw InputError(
      fmt::format("the shape has no usable extent (the diagonal of its bounding box is {}): an offset SDF needs "
                  "triangles or points "
                  "that span some space",
                  diagonal));
}

void check(const OffsetSdfOptions& options) {
  require_in_bounds("the offset, a fraction of the bounding-box diagonal,", options.offset,
                    OffsetSdfOptions::offset_bounds);
}

UnitFrame unit_frame_of(const Shape& shape) {
  require_usable(shape);
  require_extent(shape);
  return unit_frame(shape);
}

/// r / h. The table of docs/methods/offset_sdf.md#guarantees lists the accuracy of each.
double cells_per_offset(OffsetAccuracy accuracy) {
  switch (accuracy) {
    case OffsetAccuracy::fast:
      return 2.5;
    case OffsetAccuracy::fine:
      return 5;
    default:
      return 3;
  }
}

/// Gives each sample the value, direction and outcome of sample from[i].
void copy_results(OffsetResults& results, const std::vector<std::int32_t>& from) {
  results.values = results.values(from).eval();
  results.directions = results.directions(from, Eigen::all).eval();
  const std::vector<OffsetOutcome> outcomes = results.outcomes;
  for (std::size_t i = 0; i < from.size(); ++i) results.outcomes[i] = outcomes[static_cast<std::size_t>(from[i])];
}

OffsetSdfOutcomes count(const OffsetResults& results, double offset) {
  OffsetSdfOutcomes outcomes;
  outcomes.total = results.outcomes.size();
  for (const OffsetOutcome outcome : results.outcomes) {
    outcomes.direct += outcome == OffsetOutcome::direct ? 1 : 0;
    outcomes.searched += outcome == OffsetOutcome::searched ? 1 : 0;
    outcomes.undecided += outcome == OffsetOutcome::undecided ? 1 : 0;
    outcomes.missing += outcome == OffsetOutcome::missing ? 1 : 0;
  }
  if (results.offset > offset) outcomes.enlarged = outcomes.total - outcomes.missing;
  return outcomes;
}

}  // namespace

OffsetSdfSolver::OffsetSdfSolver(const Shape& shape) : frame_(unit_frame_of(shape)) {
  const Stopwatch stopwatch;
  mesh_ = distinct_triangles(shape);
  closed_ = is_closed(mesh_.shape);
  mesh_.shape = in_unit_frame(mesh_.shape, frame_);
  build_seconds_ = stopwatch.seconds();
}

/// By sample, the distinct triangle that it lies on; empty where the solver determines it.
std::vector<std::int32_t> OffsetSdfSolver::triangles_of(const Samples& samples) const {
  std::vector<std::int32_t> triangles = samples.triangles;
  for (std::int32_t& triangle : triangles) triangle = mesh_.triangle_of[static_cast<std::size_t>(triangle)];
  const bool all_faces = samples.site == SampleSite::faces && samples.points.rows() == std::ssize(mesh_.triangle_of);
  if (mesh_.has_duplicates() && all_faces) triangles = mesh_.triangle_of;
  return triangles;
}

OffsetSdfResult OffsetSdfSolver::solve(const Samples& samples, const OffsetSdfOptions& options) const {
  check(options);
  const Stopwatch stopwatch;
  const Points points = (samples.points.rowwise() - frame_.centre.transpose()) / frame_.diagonal;
  OffsetResults results = solve_on_grid(
      mesh_.shape, points, samples.normals,
      {.offset = options.offset, .cells_per_offset = cells_per_offset(options.accuracy), .parallel = options.parallel},
      triangles_of(samples));
  const bool all_vertices = samples.site == SampleSite::vertices && points.rows() == std::ssize(mesh_.vertex_of);
  if (mesh_.has_duplicates() && all_vertices) copy_results(results, mesh_.vertex_of);
  OffsetSdfResult result;
  result.values = results.values * frame_.diagonal;
  result.outcomes = count(results, options.offset);
  if (!closed_) {
    result.outcomes.two_sided = static_cast<std::size_t>((results.values.array() < 0.5 * results.offset).count());
  }
  result.normals = std::move(results.directions);
  result.offset = results.offset;
  result.build_seconds = results.build_seconds;
  result.query_seconds = stopwatch.seconds() - results.build_seconds;
  return result;
}

OffsetSdfResult offset_sdf(const Shape& shape, const Samples& samples, const OffsetSdfOptions& options) {
  check(options);
  const OffsetSdfSolver solver(shape);
  OffsetSdfResult result = solver.solve(samples, options);
  result.build_seconds += solver.build_seconds();
  return result;
}

}  // namespace shapegauge
