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

/// Exterior cells no farther from O(r) than this, in cells, have a site: every place of the offset surface is within a
/// cell of one.
constexpr double site_band = 0.9;
/// A sample's, along its normal and against it.
constexpr std::array<double, 2> sides{1, -1};
/// The points that say which triangle is closest are this far apart, in parts of r: they are too far by .25^2 / 16 of
/// r.
constexpr double point_spacing = 0.25;
constexpr double widest_spacing = 0.7;
constexpr double most_points = 6e6;
constexpr std::size_t most_blocks = std::size_t{1} << 24U;

/// What a grid needs to be made.
struct Layout {
  double offset;
  double cell;
  double spacing;  ///< in cells
};

/// The cells and points for an offset, or for the least offset above it for which there are not too many.
Layout lay_out(const Shape& shape, const Eigen::AlignedBox3d& bounds, const OffsetGridOptions& options) {
  Layout layout{options.offset, options.offset / options.cells_per_offset, point_spacing * options.cells_per_offset};
  const SurfaceExtent extent(shape);
  while (true) {
    const BlockGrid grid(bounds, layout.offset, layout.cell);
    if ((grid.blocks.cast<double>().array() > 1e6).any() ||
        grid.blocks.cast<double>().prod() > static_cast<double>(most_blocks)) {
      // First larger cells, then a larger offset.
      layout.cell *= 1.1;
      layout.offset = std::max(layout.offset, 2.5 * layout.cell);
      layout.spacing = point_spacing * layout.offset / layout.cell;
      continue;
    }
    if (extent.most_points(layout.spacing * layout.cell) <= most_points + 2 * extent.pieces) return layout;
    if (layout.spacing * 1.2 <= widest_spacing * grid.r) {
      layout.spacing *= 1.2;
    } else {
      layout.cell *= 1.1;
      layout.offset *= 1.1;
    }
  }
}

/// The samples of a block, one after the other in `order`.
struct Group {
  std::size_t begin, end;
};

/// What all samples have in common.
class Solver {
 public:
  Solver(const Shape& shape, const ExteriorGrid& exterior, const OffsetSites& sites, const MeanNormals& means,
         const Points& points, const Points& normals, std::vector<std::int32_t> likely, OffsetAnswers& answers)
      : shape_(shape),
        exterior_(exterior),
        grid_(exterior.grid()),
        sites_(sites),
        means_(means),
        points_(points),
        normals_(normals),
        likely_(std::move(likely)),
        answers_(answers) {
    sort();
  }

  void solve(bool parallel) {
    if (parallel) {
      tbb::enumerable_thread_specific<Room> rooms([this] { return Room(*this); });
      parallel_for(std::size_t{0}, groups_.size(), [&](std::size_t g) { answer(groups_[g], rooms.local()); });
    } else {
      Room room(*this);
      for (const Group& group : groups_) {
        check_interruption();
        answer(group, room);
      }
    }
  }

 private:
  struct Sample {
    Eigen::Vector3d p, normal;
    std::int32_t triangle;  ///< that it is likely to lie on
  };

  /// A sample whose q must be searched: near either of two places, p raised on either side.
  struct Search {
    Eigen::Index index;
    Sample sample;
    std::array<Eigen::Vector3d, 2> places;
  };

  /// What a group keeps from sample to sample, and its memory from group to group, without an influence on the answers.
  struct Room {
    explicit Room(const Solver& solver) : sites(solver.exterior_, solver.sites_) {}
    NearbySites sites;
    std::vector<Search> searches;
    Eigen::AlignedBox3d places;  ///< of the searches
    double reach = 0;            ///< all sites within this of the places have been collected
    std::vector<NearbySites::Site> starts;
    NearbyPoints surface;
  };

  void sort();
  void answer(const Group& group, Room& room) const;
  [[nodiscard]] bool is_on_surface(const Sample& sample, NearbyPoints& nearby) const;
  [[nodiscard]] bool is_on_own_triangle(const Sample& sample, double near_enough) const;
  bool touches(const GridPoints& points, const Eigen::Vector3d& p, double near_enough, NearbyPoints& nearby) const;
  void finish(Eigen::Index index, const Eigen::Vector3d& p, const Eigen::Vector3d& q) const;
  [[nodiscard]] std::optional<Eigen::Vector3d> direct(const Sample& sample,
                                                      std::array<Eigen::Vector3d, 2>& places) const;
  [[nodiscard]] std::optional<double> depth_of(const Eigen::Vector3d& x) const;
  [[nodiscard]] std::int32_t covering(const Sample& sample, const Eigen::Vector3d& x) const;
  [[nodiscard]] std::optional<Eigen::Vector3d> refine(const Sample& sample, const Eigen::Vector3d& place,
                                                      std::uint32_t site,
                                                      const std::optional<Eigen::Vector3d>& known) const;
  Eigen::Vector3d search(const Search& task, Room& room, OffsetOutcome& outcome) const;
  std::array<double, 2> measure(const std::array<Eigen::Vector3d, 2>& places, Room& room) const;

  /// A refined point is nearer than its site, by no more than this as a rule, in cells: however fine they are, it may
  /// be 0.133 r.
  [[nodiscard]] double gain() const { return std::max(0.4, 0.133 * grid_.r); }
  /// Where that leads nowhere, sites are tried that are farther than the nearest by so many cells.
  [[nodiscard]] double farther() const { return 3 * gain(); }

  const Shape& shape_;
  const ExteriorGrid& exterior_;
  const BlockGrid& grid_;
  const OffsetSites& sites_;
  const MeanNormals& means_;
  const Points& points_;
  const Points& normals_;
  std::vector<std::int32_t> likely_;  ///< triangles that the samples are likely to lie on
  OffsetAnswers& answers_;
  std::vector<Eigen::Index> order_;
  std::vector<Group> groups_;
};

/// For each sample a triangle that it is likely to lie on: its own where all faces are sampled, one of its vertex's
/// where all vertices are.
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

/// Sorts the samples by blocks; those that are in none are missing.
void Solver::sort() {
  constexpr unsigned index_bits = 40;
  static_assert(most_blocks <= std::size_t{1} << (64 - index_bits));
  std::vector<std::uint64_t> places;  // a block and, below it, a sample
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

/// By the triangle that it is likely to lie on, then by those of the surface's points near p.
bool Solver::is_on_surface(const Sample& sample, NearbyPoints& nearby) const {
  const GridSurface& surface = exterior_.surface();
  const Eigen::Vector3d& p = sample.p;
  const double near_enough = std::max(1e-3 * grid_.r, 1e-6 / grid_.cell);  // what rounding may have moved a sample by
  return surface.triangles.is_over_face(p, sample.triangle, near_enough) ||
         surface.triangles.squared_distance(p, sample.triangle) <= near_enough * near_enough ||
         is_on_own_triangle(sample, near_enough) || touches(surface.points, p, near_enough, nearby) ||
         touches(surface.left_out, p, near_enough, nearby);
}

/// In double precision: single precision loses the middle of a triangle that is a thousand times as long as wide. Where
/// a triangle is too thin even for double precision, the distances to its edges decide.
bool Solver::is_on_own_triangle(const Sample& sample, double near_enough) const {
  if (is_cloud(shape_)) return false;
  const auto is_near = [&](const Eigen::Vector3d& x) { return (x - sample.p).norm() <= near_enough; };
  const Triangle own = triangle_in_cells(grid_, shape_, sample.triangle);
  return is_near(closest_point(own, sample.p)) || is_near(closest_point_on_segment(own.a, own.b, sample.p)) ||
         is_near(closest_point_on_segment(own.b, own.c, sample.p)) ||
         is_near(closest_point_on_segment(own.c, own.a, sample.p));
}

bool Solver::touches(const GridPoints& points, const Eigen::Vector3d& p, double near_enough,
                     NearbyPoints& nearby) const {
  if (points.empty()) return false;
  // The apex of an equilateral triangle is as far from the points of its columns as that.
  const double reach = 1.5 * exterior_.surface().spacing + near_enough;
  std::array<std::int32_t, TriangleTable::at_once> triangles{};
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

/// How deep a place is inside of O(r), in parts of r, 1 where it is farther inside than the cells around know of;
/// nothing where it is exterior.
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
  if (squared >= std::pow((1 - shallow) * grid_.r, 2)) {
    // Shallow: it matters how deep. Perhaps a triangle that no cell knows of is closer.
    const Eigen::Vector3d place = x - vectors.vector(static_cast<std::size_t>(closest - vectors.squared.begin()));
    const std::int32_t triangle = closest_triangle_about(grid_, exterior_.surface(), place, closest_reach, x);
    if (triangle >= 0) squared = std::min(squared, exterior_.surface().triangles.squared_distance(x, triangle));
  }
  return std::max(1 - std::sqrt(squared) / grid_.r, 0.0);
}

/// The distances from a sample raised on either side to the nearest site, once all that may be asked for have been
/// collected: those farther by no more than farther() than a distance that exceeds the smaller by no more than gain().
/// The larger is at least as large as given where it exceeds the smaller by more.
std::array<double, 2> Solver::measure(const std::array<Eigen::Vector3d, 2>& places, Room& room) const {
  constexpr double first_reach = 1.6;  // in parts of r
  if (room.reach == 0) {
    room.reach = first_reach * grid_.r;
    room.sites.collect(room.places, room.reach);
  }
  std::array<double, 2> distances = room.sites.measure(places);
  const double beyond = 1.01 * (gain() + farther());
  if (std::min(distances[0], distances[1]) + beyond < room.reach) return distances;
  // From the middle of the box none is farther than this; from a place in it by half of its diagonal at most.
  const double from_middle = room.sites.distance_to_nearest(room.places.center());
  room.reach = from_middle + room.places.diagonal().norm() / 2 + beyond;
  room.sites.collect(room.places, room.reach);
  return room.sites.measure(places);
}

/// A triangle that covers x, a point that the cells around it took for exterior: the sample's own, or, where none of
/// those cells is exterior (at the end of a wedge), any. -1 where none does.
std::int32_t Solver::covering(const Sample& sample, const Eigen::Vector3d& x) const {
  constexpr double slack = 1e-3;  // of r
  if ((x - sample.p).norm() < (1 - slack) * grid_.r) return sample.triangle;
  if (cells_around(exterior_, x).touches_exterior) return -1;
  const std::int32_t closest = closest_triangle_about(grid_, exterior_.surface(), x, grid_.r, x);
  if (closest < 0) return -1;
  const double least = (1 - slack) * grid_.r;
  return exterior_.surface().triangles.squared_distance(x, closest) < least * least ? closest : -1;
}

/// The point of E(r) nearest to a place of the raised sample, about a site.
std::optional<Eigen::Vector3d> Solver::refine(const Sample& sample, const Eigen::Vector3d& place, std::uint32_t site,
                                              const std::optional<Eigen::Vector3d>& known) const {
  constexpr int most_times = 3;
  constexpr double nearly_free = 0.8;  // of r
  auto x = nearest_offset_point(exterior_, place, sites_.place(site), sites_.triangle(site), known);
  for (int i = 0; x && i < most_times; ++i) {
    const std::int32_t triangle = covering(sample, *x);
    if (triangle < 0) break;
    x = nearest_offset_point(exterior_, place, *x, triangle, known);  // on from there, with it
  }
  if (!x) return std::nullopt;
  const double height = (*x - sample.p).norm();
  if (height < nearly_free * grid_.r) return std::nullopt;
  if (height < grid_.r) *x = sample.p + grid_.r / height * (*x - sample.p);
  return x;
}

/// Of the points of E(r) nearest to p raised on either side, the one for which that is nearer.
Eigen::Vector3d Solver::search(const Search& task, Room& room, OffsetOutcome& outcome) const {
  const auto& [index, sample, places] = task;
  constexpr double apart = 2;
  constexpr std::size_t most_starts = 3;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  double best = infinite;
  Eigen::Vector3d q = sample.p + grid_.r * Eigen::Vector3d::UnitZ();  // where there are no sites: around no shape
  double nearest_site = infinite;
  Eigen::Vector3d nearest_place = q;
  // The nearer side first, whichever way the normal points.
  const std::array<double, 2> distances = measure(places, room);
  const std::size_t first = distances[0] <= distances[1] ? 0 : 1;
  for (const std::size_t side : {first, 1 - first}) {
    const double distance = distances[side];
    if (distance - gain() > std::min(best, nearest_site)) break;
    room.sites.starts(side, gain(), apart, most_starts, room.starts);
    if (distance < nearest_site) {
      nearest_site = distance;
      nearest_place = sites_.place(room.starts.front().site);
    }
    std::optional<Eigen::Vector3d> known;  // from this side
    const auto refine_all = [&] {
      for (const NearbySites::Site& start : room.starts) {
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
      room.sites.starts(side, farther(), apart / 2, 3 * most_starts, room.starts);
      refine_all();
    }
    if (places[0] == places[1]) break;
  }
  if (best < infinite) return q;
  outcome = OffsetOutcome::undecided;
  return nearest_place;
}

/// q, where it is p + r n or p - r n; else nothing, and p raised on either side.
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

/// The answer that follows from q.
void Solver::finish(Eigen::Index index, const Eigen::Vector3d& p, const Eigen::Vector3d& q) const {
  const double r = grid_.r;
  const double height = (q - p).norm();
  const Eigen::Vector3d outward = (q - p) / height;
  answers_.directions.row(index) = outward.transpose();
  answers_.heights[index] = height * grid_.cell;
  // Both ends are at least r away from p, up to what single precision loses.
  const double exit = offset_exit(exterior_, p, -outward);
  answers_.values[index] = std::max(0.0, (height - r) + (exit - r)) * grid_.cell;
}

/// First all whose q need not be searched: the sites are collected about the others only.
void Solver::answer(const Group& group, Room& room) const {
  room.searches.clear();
  room.places.setEmpty();
  room.reach = 0;
  for (std::size_t k = group.begin; k < group.end; ++k) {
    const Eigen::Index i = order_[k];
    Search task{.index = i,
                .sample = {grid_.to_cells(points_.row(i).transpose()), normals_.row(i).transpose(),
                           likely_[static_cast<std::size_t>(i)]},
                .places = {}};
    if (!is_on_surface(task.sample, room.surface)) continue;
    if (const auto q = direct(task.sample, task.places)) {
      answers_.outcomes[static_cast<std::size_t>(i)] = OffsetOutcome::direct;
      finish(i, task.sample.p, *q);
      continue;
    }
    for (const Eigen::Vector3d& place : task.places) room.places.extend(place);
    room.searches.push_back(task);
  }
  for (const Search& task : room.searches) {
    OffsetOutcome& outcome = answers_.outcomes[static_cast<std::size_t>(task.index)];
    outcome = OffsetOutcome::searched;
    finish(task.index, task.sample.p, search(task, room, outcome));
  }
}

}  // namespace

OffsetAnswers answer_by_grid(const Shape& shape, const Points& points, const Points& normals,
                             const OffsetGridOptions& options, const std::vector<std::int32_t>& triangles) {
  const Clock::time_point start = Clock::now();
  const Eigen::AlignedBox3d bounds = bounding_box(shape);
  const Layout layout = lay_out(shape, bounds, options);
  const BlockGrid grid(bounds, layout.offset, layout.cell);
  const GridSurface surface(grid, shape, layout.spacing, options.parallel);
  const ExteriorGrid exterior(grid, surface, site_band, options.parallel);
  const OffsetSites sites(exterior, site_band, options.parallel);
  const MeanNormals means(grid, shape, surface);
  OffsetAnswers answers;
  answers.offset = layout.offset;
  answers.build_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  answers.values = Eigen::VectorXd::Constant(points.rows(), std::numeric_limits<double>::quiet_NaN());
  answers.heights = answers.values;
  answers.directions = Points::Zero(points.rows(), 3);
  answers.outcomes.assign(static_cast<std::size_t>(points.rows()), OffsetOutcome::missing);
  Solver(shape, exterior, sites, means, points, normals,
         triangles.empty() ? likely_triangles(shape, points.rows()) : triangles, answers)
      .solve(options.parallel);
  return answers;
}

}  // namespace shapegauge
