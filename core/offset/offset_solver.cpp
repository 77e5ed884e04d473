#include "shapegauge/core/offset/offset_solver.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <tbb/enumerable_thread_specific.h>
#include <utility>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/offset/block_distances.h"
#include "shapegauge/core/offset/mean_normals.h"
#include "shapegauge/core/offset/nearest_offset_point.h"
#include "shapegauge/core/offset/offset_exit.h"
#include "shapegauge/core/offset/offset_sites.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

namespace {

using Clock = std::chrono::steady_clock;

/// Exterior cells up to this distance from O(r), in cells, have a site. Every point of the offset surface is within a
/// cell of a site.
constexpr double site_band = 0.9;
/// Sides of a sample: along its normal and against it.
constexpr std::array<double, 2> sides{1, -1};
/// Spacing of the points that determine the closest triangle, in units of r. Distances are too large by at most .25^2 /
/// 16 of r.
constexpr double point_spacing = 0.25;
constexpr double max_spacing = 0.7;
constexpr double max_points = 6e6;
constexpr std::size_t max_blocks = std::size_t{1} << 24U;

/// Parameters of a grid.
struct Layout {
  double offset;
  double cell;
  double spacing;  ///< in cells
};

/// Returns the parameters for an offset, or for a larger one that keeps within the bounds of memory.
Layout choose_layout(const Shape& shape, const Eigen::AlignedBox3d& bounds, const OffsetSolverOptions& options) {
  Layout layout{options.offset, options.offset / options.cells_per_offset, point_spacing * options.cells_per_offset};
  const SurfaceExtent extent(shape);
  while (true) {
    const BlockGrid grid(bounds, layout.offset, layout.cell);
    if ((grid.blocks.cast<double>().array() > 1e6).any() ||
        grid.blocks.cast<double>().prod() > static_cast<double>(max_blocks)) {
      // Enlarges cells first, then the offset.
      layout.cell *= 1.1;
      layout.offset = std::max(layout.offset, 2.5 * layout.cell);
      layout.spacing = point_spacing * layout.offset / layout.cell;
      continue;
    }
    if (extent.max_points(layout.spacing * layout.cell) <= max_points + 2 * extent.pieces) return layout;
    if (layout.spacing * 1.2 <= max_spacing * grid.r) {
      layout.spacing *= 1.2;
    } else {
      layout.cell *= 1.1;
      layout.offset *= 1.1;
    }
  }
}

/// Samples of a block: a range of order_.
struct Group {
  std::size_t begin, end;
};

/// Solver of all samples, with their shared data.
class Solver {
 public:
  Solver(const Shape& shape, const ExteriorGrid& exterior, const OffsetSites& sites, const MeanNormals& means,
         const Points& points, const Points& normals, std::vector<std::int32_t> likely, OffsetResults& results)
      : shape_(shape),
        exterior_(exterior),
        grid_(exterior.grid()),
        sites_(sites),
        means_(means),
        points_(points),
        normals_(normals),
        likely_(std::move(likely)),
        results_(results) {
    sort();
  }

  void solve(bool parallel) {
    if (parallel) {
      tbb::enumerable_thread_specific<Scratch> scratches([this] { return Scratch(*this); });
      parallel_for(std::size_t{0}, groups_.size(), [&](std::size_t g) { solve_group(groups_[g], scratches.local()); });
    } else {
      Scratch scratch(*this);
      for (const Group& group : groups_) {
        check_interruption();
        solve_group(group, scratch);
      }
    }
  }

 private:
  struct Sample {
    Eigen::Vector3d p, normal;
    std::int32_t triangle;  ///< that probably contains it
  };

  /// Sample whose q is found by iteration, from p raised on either side.
  struct Search {
    Eigen::Index index;
    Sample sample;
    std::array<Eigen::Vector3d, 2> places;
  };

  /// Scratch data of a group of samples. The buffers are reused by later groups.
  struct Scratch {
    explicit Scratch(const Solver& solver) : sites(solver.exterior_, solver.sites_) {}
    NearbySites sites;
    std::vector<Search> searches;
    Eigen::AlignedBox3d places;  ///< bounding box of the places of all searches
    double reach = 0;            ///< sites within this distance of the places have been collected
    std::vector<NearbySites::Site> starts;
    NearbyPoints surface;
  };

  void sort();
  void solve_group(const Group& group, Scratch& scratch) const;
  [[nodiscard]] bool is_on_surface(const Sample& sample, NearbyPoints& nearby) const;
  [[nodiscard]] bool is_on_own_triangle(const Sample& sample, double near_enough) const;
  bool is_on_any_triangle(const GridPoints& points, const Eigen::Vector3d& p, double near_enough,
                          NearbyPoints& nearby) const;
  void finish(Eigen::Index index, const Eigen::Vector3d& p, const Eigen::Vector3d& q) const;
  [[nodiscard]] std::optional<Eigen::Vector3d> direct(const Sample& sample,
                                                      std::array<Eigen::Vector3d, 2>& places) const;
  [[nodiscard]] std::optional<double> depth_of(const Eigen::Vector3d& x) const;
  [[nodiscard]] std::int32_t covering_triangle(const Sample& sample, const Eigen::Vector3d& x) const;
  [[nodiscard]] std::optional<Eigen::Vector3d> refine(const Sample& sample, const Eigen::Vector3d& place,
                                                      std::uint32_t site,
                                                      const std::optional<Eigen::Vector3d>& known) const;
  Eigen::Vector3d search(const Search& task, Scratch& scratch, OffsetOutcome& outcome) const;
  std::array<double, 2> measure(const std::array<Eigen::Vector3d, 2>& places, Scratch& scratch) const;

  /// Maximum decrease of the distance, in cells, from a site to its refined point, with few exceptions. With fine cells
  /// it is up to 0.133 r.
  [[nodiscard]] double gain() const { return std::max(0.4, 0.133 * grid_.r); }
  /// Margin, in cells, for further sites if the iterations from the first ones fail.
  [[nodiscard]] double extended_margin() const { return 3 * gain(); }

  const Shape& shape_;
  const ExteriorGrid& exterior_;
  const BlockGrid& grid_;
  const OffsetSites& sites_;
  const MeanNormals& means_;
  const Points& points_;
  const Points& normals_;
  std::vector<std::int32_t> likely_;  ///< by sample: triangle that probably contains it
  OffsetResults& results_;
  std::vector<Eigen::Index> order_;
  std::vector<Group> groups_;
};

/// Returns for each sample a triangle that probably contains it: its own if all faces are sampled, one of its vertex's
/// if all vertices are.
std::vector<std::int32_t> likely_triangles(const Shape& shape, Eigen::Index samples) {
  std::vector<std::int32_t> likely(static_cast<std::size_t>(samples), 0);
  if (samples == (is_cloud(shape) ? shape.vertices.rows() : shape.triangles.rows())) {
    std::iota(likely.begin(), likely.end(), 0);
  } else if (samples == shape.vertices.rows()) {
    for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
      for (int k = 0; k < 3; ++k)
        likely[static_cast<std::size_t>(shape.triangles(f, k))] = static_cast<std::int32_t>(f);
    }
  }
  return likely;
}

/// Sorts the samples by block. Those outside the grid are missing.
void Solver::sort() {
  constexpr unsigned index_bits = 40;
  static_assert(max_blocks <= std::size_t{1} << (64 - index_bits));
  std::vector<std::uint64_t> places;  // block index in the high bits, sample index in the low ones
  places.reserve(static_cast<std::size_t>(points_.rows()));
  for (Eigen::Index i = 0; i < points_.rows(); ++i) {
    const Eigen::Vector3d p = grid_.to_cells(points_.row(i).transpose());
    const Eigen::Vector3d end = (block_edge * grid_.blocks).cast<double>();
    const bool is_in_grid = p.allFinite() && (p.array() >= 0).all() && (p.array() < end.array()).all();
    if (!is_in_grid || !normals_.row(i).allFinite()) continue;
    places.push_back(std::uint64_t{grid_.block_index(grid_.block_of(p))} << index_bits | static_cast<std::uint64_t>(i));
  }
  std::sort(places.begin(), places.end());
  order_.reserve(places.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (k == 0 || places[k] >> index_bits != places[k - 1] >> index_bits) groups_.push_back({k, k});
    groups_.back().end = k + 1;
    order_.push_back(static_cast<Eigen::Index>(places[k] & ((std::uint64_t{1} << index_bits) - 1)));
  }
}

/// Tests the triangle that probably contains the sample, then those of the surface's points near it.
bool Solver::is_on_surface(const Sample& sample, NearbyPoints& nearby) const {
  const GridSurface& surface = exterior_.surface();
  const Eigen::Vector3d& p = sample.p;
  const double near_enough = std::max(1e-3 * grid_.r, 1e-6 / grid_.cell);  // displacement of a sample by rounding
  return surface.triangles.is_over_face(p, sample.triangle, near_enough) ||
         surface.triangles.squared_distance(p, sample.triangle) <= near_enough * near_enough ||
         is_on_own_triangle(sample, near_enough) || is_on_any_triangle(surface.points, p, near_enough, nearby) ||
         is_on_any_triangle(surface.omitted, p, near_enough, nearby);
}

/// Tests in double precision: single precision loses the interior of triangles a thousand times as long as wide. The
/// edges are tested as well, for triangles too thin for double precision.
bool Solver::is_on_own_triangle(const Sample& sample, double near_enough) const {
  if (is_cloud(shape_)) return false;
  const auto is_near = [&](const Eigen::Vector3d& x) { return (x - sample.p).norm() <= near_enough; };
  const Triangle own = triangle_in_cells(grid_, shape_, sample.triangle);
  return is_near(closest_point(own, sample.p)) || is_near(closest_point_on_segment(own.a, own.b, sample.p)) ||
         is_near(closest_point_on_segment(own.b, own.c, sample.p)) ||
         is_near(closest_point_on_segment(own.c, own.a, sample.p));
}

bool Solver::is_on_any_triangle(const GridPoints& points, const Eigen::Vector3d& p, double near_enough,
                                NearbyPoints& nearby) const {
  if (points.empty()) return false;
  // Maximum distance of a point of a triangle from its samples: the apex of an equilateral one.
  const double reach = 1.5 * exterior_.surface().spacing + near_enough;
  std::array<std::int32_t, TriangleTable::batch_size> triangles{};
  TriangleTable::Vectors vectors;
  points.find_runs(grid_, p, reach, nearby.runs);
  for (const auto& [begin, end] : nearby.runs) {
    const std::size_t count = end - begin;
    if (nearby.squared.size() < count + grid_padding) nearby.squared.resize(count + grid_padding);
    if (nearby.index.size() < count) nearby.index.resize(count);
    squared_distances(&points.x[begin], &points.y[begin], &points.z[begin], count, p.cast<float>(),
                      nearby.squared.data());
    const std::size_t found =
        indices_within(nearby.squared.data(), count, static_cast<float>(reach * reach), nearby.index.data());
    for (std::size_t i = 0; i < found; i += triangles.size()) {
      for (std::size_t lane = 0; lane < triangles.size(); ++lane) {
        triangles[lane] = points.triangle[begin + nearby.index[std::min(i + lane, found - 1)]];
      }
      exterior_.surface().triangles.vectors_to(p, triangles.data(), vectors);
      const float least = *std::min_element(vectors.squared.begin(), vectors.squared.end());
      if (static_cast<double>(least) <= near_enough * near_enough) return true;
    }
  }
  return false;
}

/// Returns the depth of a place inside O(r), in units of r; 1 if no surrounding cell has a triangle. Returns nothing
/// for an exterior place.
std::optional<double> Solver::depth_of(const Eigen::Vector3d& x) const {
  constexpr double slack = 1e-3;
  const CellsAround around = cells_around(exterior_, x);
  TriangleTable::Vectors vectors;
  if (!vectors_around(exterior_, around, x, vectors)) {
    return around.touches_exterior ? std::nullopt : std::optional<double>(1);
  }
  const auto closest = std::min_element(vectors.squared.begin(), vectors.squared.end());
  auto squared = static_cast<double>(*closest);
  const double least = (1 - slack) * grid_.r;
  if (squared >= least * least && around.touches_exterior) return std::nullopt;
  if (squared >= std::pow((1 - blend_depth) * grid_.r, 2)) {
    // A small depth must be accurate: a triangle that is nearest to no cell may be closer.
    const Eigen::Vector3d place = x - vectors.vector(static_cast<std::size_t>(closest - vectors.squared.begin()));
    const std::int32_t triangle = closest_triangle_near(grid_, exterior_.surface(), place, closest_reach, x);
    if (triangle >= 0) squared = std::min(squared, exterior_.surface().triangles.squared_distance(x, triangle));
  }
  return std::max(1 - std::sqrt(squared) / grid_.r, 0.0);
}

/// Returns the distances from a sample raised on either side to the nearest site, after collecting all sites that the
/// search may use: those up to extended_margin() beyond a distance that exceeds the smaller one by at most gain(). If
/// the larger exceeds the smaller by more, it is a lower bound.
std::array<double, 2> Solver::measure(const std::array<Eigen::Vector3d, 2>& places, Scratch& scratch) const {
  constexpr double first_reach = 1.6;  // in units of r
  if (scratch.reach == 0) {
    scratch.reach = first_reach * grid_.r;
    scratch.sites.collect(scratch.places, scratch.reach);
  }
  std::array<double, 2> distances = scratch.sites.measure(places);
  const double beyond = 1.01 * (gain() + extended_margin());
  if (std::min(distances[0], distances[1]) + beyond < scratch.reach) return distances;
  // The nearest site of any place in the box is at most half of its diagonal farther than that of its centre.
  const double from_middle = scratch.sites.distance_to_nearest(scratch.places.center());
  scratch.reach = from_middle + scratch.places.diagonal().norm() / 2 + beyond;
  scratch.sites.collect(scratch.places, scratch.reach);
  return scratch.sites.measure(places);
}

/// Returns a triangle that covers x, a result of the iteration: the sample's own or, if no surrounding cell is exterior
/// (at the end of a wedge), any. Returns -1 if there is none.
std::int32_t Solver::covering_triangle(const Sample& sample, const Eigen::Vector3d& x) const {
  constexpr double slack = 1e-3;  // of r
  if ((x - sample.p).norm() < (1 - slack) * grid_.r) return sample.triangle;
  if (cells_around(exterior_, x).touches_exterior) return -1;
  const std::int32_t closest = closest_triangle_near(grid_, exterior_.surface(), x, grid_.r, x);
  if (closest < 0) return -1;
  const double least = (1 - slack) * grid_.r;
  return exterior_.surface().triangles.squared_distance(x, closest) < least * least ? closest : -1;
}

/// Returns the point of E(r) nearest to the raised sample, in the neighbourhood of a site.
std::optional<Eigen::Vector3d> Solver::refine(const Sample& sample, const Eigen::Vector3d& place, std::uint32_t site,
                                              const std::optional<Eigen::Vector3d>& known) const {
  constexpr int max_repeats = 3;
  constexpr double nearly_free = 0.8;  // of r
  auto x = nearest_offset_point(exterior_, place, sites_.place(site), sites_.triangle(site), known);
  for (int i = 0; x && i < max_repeats; ++i) {
    const std::int32_t triangle = covering_triangle(sample, *x);
    if (triangle < 0) break;
    x = nearest_offset_point(exterior_, place, *x, triangle, known);  // continue from there with this triangle
  }
  if (!x) return std::nullopt;
  const double height = (*x - sample.p).norm();
  if (height < nearly_free * grid_.r) return std::nullopt;
  if (height < grid_.r) *x = sample.p + grid_.r / height * (*x - sample.p);
  return x;
}

/// Returns q: the nearer of the points of E(r) nearest to p raised on either side.
Eigen::Vector3d Solver::search(const Search& task, Scratch& scratch, OffsetOutcome& outcome) const {
  const Sample& sample = task.sample;
  const std::array<Eigen::Vector3d, 2>& places = task.places;
  constexpr double apart = 2;
  constexpr std::size_t max_starts = 3;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  double best = infinite;
  Eigen::Vector3d q = sample.p + grid_.r * Eigen::Vector3d::UnitZ();  // if there are no sites
  double nearest_site = infinite;
  Eigen::Vector3d nearest_place = q;
  // The nearer side first, whatever the orientation of the normal.
  const std::array<double, 2> distances = measure(places, scratch);
  const std::size_t first = distances[0] <= distances[1] ? 0 : 1;
  for (const std::size_t side : {first, 1 - first}) {
    const double distance = distances[side];
    if (distance - gain() > std::min(best, nearest_site)) break;
    scratch.sites.start_sites(side, gain(), apart, max_starts, scratch.starts);
    if (distance < nearest_site) {
      nearest_site = distance;
      nearest_place = sites_.place(scratch.starts.front().site);
    }
    std::optional<Eigen::Vector3d> known;  // found from this side
    const auto refine_all = [&] {
      for (const NearbySites::Site& start : scratch.starts) {
        const bool is_known = best < infinite && (sites_.place(start.site) - q).norm() < apart;
        if (is_known || static_cast<double>(start.distance) - gain() > best) continue;
        const auto x = refine(sample, places[side], start.site, known);
        if (!x || !((*x - places[side]).norm() < best)) continue;
        best = (*x - places[side]).norm();
        q = *x;
        known = q;
      }
    };
    refine_all();
    if (!(best < infinite)) {
      scratch.sites.start_sites(side, extended_margin(), apart / 2, 3 * max_starts, scratch.starts);
      refine_all();
    }
    if (places[0] == places[1]) break;
  }
  if (best < infinite) return q;
  outcome = OffsetOutcome::undecided;
  return nearest_place;
}

/// Returns q if it is p + r n or p - r n. Otherwise returns nothing and sets `places` to p raised on either side.
std::optional<Eigen::Vector3d> Solver::direct(const Sample& sample, std::array<Eigen::Vector3d, 2>& places) const {
  const auto& [p, normal, triangle] = sample;
  places = {p, p};
  if (normal.isZero()) return std::nullopt;
  std::array<double, 2> depths;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Eigen::Vector3d end = p + sides[i] * grid_.r * normal;
    const std::optional<double> depth = depth_of(end);
    if (!depth) return end;
    depths[i] = *depth;
  }
  const Eigen::Vector3d mean = means_.at(p, normal);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    places[i] = raised(p, sides[i] * normal, sides[i] * mean, depths[i], grid_.r);
  }
  return std::nullopt;
}

/// Computes the results that follow from q.
void Solver::finish(Eigen::Index index, const Eigen::Vector3d& p, const Eigen::Vector3d& q) const {
  const double r = grid_.r;
  const double height = (q - p).norm();
  const Eigen::Vector3d outward = (q - p) / height;
  results_.directions.row(index) = outward.transpose();
  results_.heights[index] = height * grid_.cell;
  // Both ends are at least r away from p, except for rounding in single precision.
  const double exit = offset_exit(exterior_, p, -outward);
  results_.values[index] = std::max(0.0, (height - r) + (exit - r)) * grid_.cell;
}

/// Solves the direct samples first; sites are collected around the others only.
void Solver::solve_group(const Group& group, Scratch& scratch) const {
  scratch.searches.clear();
  scratch.places.setEmpty();
  scratch.reach = 0;
  for (std::size_t k = group.begin; k < group.end; ++k) {
    const Eigen::Index i = order_[k];
    Search task{.index = i,
                .sample = {grid_.to_cells(points_.row(i).transpose()), normals_.row(i).transpose(),
                           likely_[static_cast<std::size_t>(i)]},
                .places = {}};
    if (!is_on_surface(task.sample, scratch.surface)) continue;
    if (const auto q = direct(task.sample, task.places)) {
      results_.outcomes[static_cast<std::size_t>(i)] = OffsetOutcome::direct;
      finish(i, task.sample.p, *q);
      continue;
    }
    for (const Eigen::Vector3d& place : task.places) scratch.places.extend(place);
    scratch.searches.push_back(task);
  }
  for (const Search& task : scratch.searches) {
    OffsetOutcome& outcome = results_.outcomes[static_cast<std::size_t>(task.index)];
    outcome = OffsetOutcome::searched;
    finish(task.index, task.sample.p, search(task, scratch, outcome));
  }
}

}  // namespace

OffsetResults solve_on_grid(const Shape& shape, const Points& points, const Points& normals,
                            const OffsetSolverOptions& options, const std::vector<std::int32_t>& triangles) {
  const Clock::time_point start = Clock::now();
  const Eigen::AlignedBox3d bounds = bounding_box(shape);
  const Layout layout = choose_layout(shape, bounds, options);
  const BlockGrid grid(bounds, layout.offset, layout.cell);
  const GridSurface surface(grid, shape, layout.spacing, options.parallel);
  const ExteriorGrid exterior(grid, surface, site_band, options.parallel);
  const OffsetSites sites(exterior, site_band, options.parallel);
  const MeanNormals means(grid, shape, surface);
  OffsetResults results;
  results.offset = layout.offset;
  results.build_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  results.values = Eigen::VectorXd::Constant(points.rows(), std::numeric_limits<double>::quiet_NaN());
  results.heights = results.values;
  results.directions = Points::Zero(points.rows(), 3);
  results.outcomes.assign(static_cast<std::size_t>(points.rows()), OffsetOutcome::missing);
  Solver(shape, exterior, sites, means, points, normals,
         triangles.empty() ? likely_triangles(shape, points.rows()) : triangles, results)
      .solve(options.parallel);
  return results;
}

}  // namespace shapegauge
