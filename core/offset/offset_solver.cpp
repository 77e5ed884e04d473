// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/offset/offset_solver.h"

#include <array>
#include <cstddef>
#include <limits>
#include <tbb/enumerable_thread_specific.h>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/core/offset/grid_layout.h"
#include "shapegauge/core/offset/mean_normals.h"
#include "shapegauge/core/offset/offset_depth.h"
#include "shapegauge/core/offset/offset_exit.h"
#include "shapegauge/core/offset/offset_search.h"
#include "shapegauge/core/offset/offset_sites.h"
#include "shapegauge/core/offset/on_surface.h"
#include "shapegauge/core/offset/point_search.h"
#include "shapegauge/core/offset/sample_order.h"

/// The steps of docs/methods/offset_sdf.md#algorithm: solve_on_grid() finds the points, the exterior and the sites;
/// BatchSolver finds q and q' of the samples, a batch at a time.

namespace shapegauge {

namespace {

/// Exterior cells up to this distance from O(r), in cells, have a site. Every point of the offset surface is within a
/// cell of a site.
constexpr double site_band = 0.9;

/// What all samples share.
struct Problem {
  const Shape& shape;
  const Points& points;
  const Points& normals;
  const std::vector<std::int32_t>& triangles;  ///< per sample: triangle that probably contains it
  const ExteriorGrid& exterior;
  const OffsetSites& sites;
  const MeanNormals& means;
  const SampleOrder& order;

  [[nodiscard]] double r() const { return exterior.grid().r; }
};

/// Solver of one batch of samples at a time. Its buffers are reused by later ones.
class BatchSolver {
 public:
  BatchSolver(const Problem& problem, OffsetResults& results)
      : problem_(problem),
        results_(results),
        closest_(problem.exterior.grid(), problem.exterior.surface()),
        search_(problem.exterior, problem.sites, closest_) {}
  BatchSolver(const BatchSolver&) = delete;
  BatchSolver& operator=(const BatchSolver&) = delete;
  BatchSolver(BatchSolver&&) = delete;
  BatchSolver& operator=(BatchSolver&&) = delete;
  ~BatchSolver() = default;

  void solve(const SampleOrder::Range& batch) {
    collect_samples(batch);
    find_q_along_normals();
    raise_covered_samples();
    search_q();
    find_opposite_points();
  }

 private:
  struct Sample {
    Eigen::Index index;
    Eigen::Vector3d p, normal;
    std::int32_t triangle;  ///< that probably contains it
    std::size_t group;
    bool is_direct = false;
    Eigen::Vector3d q = Eigen::Vector3d::Zero();  ///< if direct
    std::array<double, 2> depths{};               ///< of p + r n and p - r n inside O(r)
  };

  void collect_samples(const SampleOrder::Range& batch);
  void find_q_along_normals();
  void raise_covered_samples();
  void search_q();
  void find_opposite_points();
  [[nodiscard]] std::array<Eigen::Vector3d, 2> raised_to_both_sides(const Sample& sample) const;
  void set_q(Eigen::Index index, const Eigen::Vector3d& p, const Eigen::Vector3d& q, OffsetOutcome outcome);

  const Problem& problem_;
  OffsetResults& results_;
  ClosestTriangles closest_;
  OffsetSearch search_;
  std::vector<Sample> samples_;
  std::vector<CoveredSample> covered_;
  std::vector<OffsetDepthTask> depths_;
  std::vector<std::size_t> tested_;  ///< sample of each depth
  std::vector<OffsetExitTask> rays_;
  std::vector<Eigen::Index> ray_samples_;
  std::vector<std::uint32_t> nearby_;  ///< buffer of is_on_surface()
};

/// Collects the samples of a batch that lie on the surface.
void BatchSolver::collect_samples(const SampleOrder::Range& batch) {
  const BlockGrid& grid = problem_.exterior.grid();
  samples_.clear();
  for (std::size_t group = batch.begin; group < batch.end; ++group) {
    for (std::size_t k = problem_.order.groups[group].begin; k < problem_.order.groups[group].end; ++k) {
      const Eigen::Index index = problem_.order.samples[k];
      const Eigen::Vector3d p = grid.to_cells(problem_.points.row(index).transpose());
      const std::int32_t triangle = problem_.triangles[static_cast<std::size_t>(index)];
      if (!is_on_surface(problem_.exterior, problem_.shape, p, triangle, nearby_)) continue;
      samples_.push_back({.index = index,
                          .p = p,
                          .normal = problem_.normals.row(index).transpose(),
                          .triangle = triangle,
                          .group = group});
    }
  }
}

/// Finds the samples whose q is p + r n or, if that is covered, p - r n.
void BatchSolver::find_q_along_normals() {
  for (const std::size_t side : {0U, 1U}) {
    depths_.clear();
    tested_.clear();
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const Sample& sample = samples_[i];
      if (sample.is_direct || sample.normal.isZero()) continue;
      depths_.push_back({.x = sample.p + (side == 0 ? 1.0 : -1.0) * problem_.r() * sample.normal});
      tested_.push_back(i);
    }
    find_offset_depths(problem_.exterior, closest_, depths_);
    for (std::size_t i = 0; i < tested_.size(); ++i) {
      Sample& sample = samples_[tested_[i]];
      sample.is_direct = depths_[i].is_exterior;
      sample.q = depths_[i].x;
      sample.depths[side] = depths_[i].depth;
    }
  }
}

/// Returns p' on either side of a sample.
std::array<Eigen::Vector3d, 2> BatchSolver::raised_to_both_sides(const Sample& sample) const {
  const Eigen::Vector3d& p = sample.p;
  if (sample.normal.isZero()) return {p, p};
  const Eigen::Vector3d mean = problem_.means.at(p, sample.normal);
  return {raised(p, sample.normal, mean, sample.depths[0], problem_.r()),
          raised(p, -sample.normal, -mean, sample.depths[1], problem_.r())};
}

/// Sets q of the direct samples, and raises the others.
void BatchSolver::raise_covered_samples() {
  covered_.clear();
  rays_.clear();
  ray_samples_.clear();
  for (const Sample& sample : samples_) {
    if (sample.is_direct) {
      set_q(sample.index, sample.p, sample.q, OffsetOutcome::direct);
      continue;
    }
    covered_.push_back({.index = sample.index,
                        .p = sample.p,
                        .raised = raised_to_both_sides(sample),
                        .triangle = sample.triangle,
                        .group = sample.group});
  }
}

/// Finds q of the raised samples.
void BatchSolver::search_q() {
  const std::vector<SearchedPoint>& found = search_.find(covered_);
  for (std::size_t i = 0; i < covered_.size(); ++i) {
    set_q(covered_[i].index, covered_[i].p, found[i].q,
          found[i].has_converged ? OffsetOutcome::searched : OffsetOutcome::undecided);
  }
}

/// Sets the results that follow from q, and adds the ray to q'.
void BatchSolver::set_q(Eigen::Index index, const Eigen::Vector3d& p, const Eigen::Vector3d& q, OffsetOutcome outcome) {
  const double height = (q - p).norm();
  const Eigen::Vector3d outward = (q - p) / height;
  results_.outcomes[static_cast<std::size_t>(index)] = outcome;
  results_.directions.row(index) = outward.transpose();
  results_.heights[index] = height * problem_.exterior.grid().cell;
  rays_.push_back({.origin = p, .direction = -outward});
  ray_samples_.push_back(index);
}

/// Finds q', where the rays enter the exterior again, and computes the values.
void BatchSolver::find_opposite_points() {
  find_offset_exits(problem_.exterior, closest_, rays_);
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    const Eigen::Index index = ray_samples_[i];
    // Both ends are at least r away from p, except for rounding in single precision.
    const double beyond = (rays_[i].exit - 2 * problem_.r()) * problem_.exterior.grid().cell;
    const double value = results_.heights[index] + beyond;
    results_.values[index] = value < 0 ? 0 : value;  // not std::max, which makes 0 of NaN
  }
}

/// Returns results of which nothing is known yet.
OffsetResults missing_results(Eigen::Index samples, double offset, double build_seconds) {
  OffsetResults results;
  results.values = Eigen::VectorXd::Constant(samples, std::numeric_limits<double>::quiet_NaN());
  results.heights = results.values;
  results.directions = Points::Zero(samples, 3);
  results.outcomes.assign(static_cast<std::size_t>(samples), OffsetOutcome::missing);
  results.offset = offset;
  results.build_seconds = build_seconds;
  return results;
}

}  // namespace

OffsetResults solve_on_grid(const Shape& shape, const Points& points, const Points& normals,
                            const OffsetSolverOptions& options, const std::vector<std::int32_t>& triangles) {
  const Stopwatch stopwatch;
  const Eigen::AlignedBox3d bounds = bounding_box(shape);
  const GridLayout layout = choose_grid_layout(shape, bounds, options.offset, options.cells_per_offset);
  const BlockGrid grid(bounds, layout.offset, layout.cell);
  const GridSurface surface(grid, shape, layout.spacing, options.parallel);  // 1. points
  const ExteriorGrid exterior(grid, surface, site_band, options.parallel);   // 2. flood fill
  const OffsetSites sites(exterior, site_band, options.parallel);            // 3. sites
  const MeanNormals means(grid, shape, surface, options.parallel);
  OffsetResults results = missing_results(points.rows(), layout.offset, stopwatch.seconds());

  const SampleOrder order(grid, points, normals);  // 4. and 5.: q and q'
  const std::vector<std::int32_t> likely = triangles.empty() ? likely_triangles(shape, points.rows()) : triangles;
  const Problem problem{shape, points, normals, likely, exterior, sites, means, order};
  tbb::enumerable_thread_specific<BatchSolver> solvers([&] { return BatchSolver(problem, results); });
  for_each_index(options.parallel, std::size_t{0}, order.batches.size(), [&](std::size_t b) {
    check_interruption();
    solvers.local().solve(order.batches[b]);
  });
  return results;
}

}  // namespace shapegauge
