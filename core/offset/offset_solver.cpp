#include "shapegauge/core/offset/offset_solver.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <tbb/enumerable_thread_specific.h>
#include <utility>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/core/offset/grid_layout.h"
#include "shapegauge/core/offset/mean_normals.h"
#include "shapegauge/core/offset/nearest_offset_point.h"
#include "shapegauge/core/offset/offset_depth.h"
#include "shapegauge/core/offset/offset_exit.h"
#include "shapegauge/core/offset/offset_sites.h"
#include "shapegauge/core/offset/on_surface.h"
#include "shapegauge/core/offset/point_search.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

namespace {

/// Exterior cells up to this distance from O(r), in cells, have a site. Every point of the offset surface is within a
/// cell of a site.
constexpr double site_band = 0.9;
/// Sides of a sample: along its normal and against it.
constexpr std::array<double, 2> sides{1, -1};
/// Samples of a block: a range of order_.
struct Group {
  std::size_t begin, end;
};

/// Consecutive groups, whose iterations share the lanes of vectors: a range of groups_.
struct Batch {
  std::size_t begin, end;
};
/// Minimum number of samples of a batch, if there are as many.
constexpr std::size_t batch_size = 256;

constexpr double infinity = std::numeric_limits<double>::infinity();
const Eigen::Vector3d no_point = Eigen::Vector3d::Constant(infinity);

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
    tbb::enumerable_thread_specific<Scratch> scratches([this] { return Scratch(*this); });
    for_each_index(parallel, std::size_t{0}, batches_.size(), [&](std::size_t b) {
      check_interruption();
      solve_batch(batches_[b], scratches.local());
    });
  }

 private:
  struct Sample {
    Eigen::Index index;
    Eigen::Vector3d p, normal;
    std::int32_t triangle;  ///< that probably contains it
    std::size_t group;      ///< index of its group
    bool is_direct = false;
    Eigen::Vector3d q = no_point;    ///< if direct
    std::array<double, 2> depths{};  ///< by side: of p raised by r along the normal
  };

  static constexpr std::size_t max_starts = 9;
  /// Sites from which iterations begin, by ascending distance.
  struct Starts {
    std::array<NearbySites::Site, max_starts> list{};
    std::size_t count = 0;
  };

  /// Sample whose q is found by iteration, from p raised on either side: the nearer side first, whatever the
  /// orientation of the normal.
  struct Search {
    Sample sample;
    std::array<Eigen::Vector3d, 2> places;
    std::array<double, 2> distances{};  ///< by side: to the nearest site
    std::array<Starts, 2> starts{};     ///< by side
    std::size_t side = 0;               ///< the current one
    bool is_last_side = false;
    bool needs_sites = true;
    bool is_extended = false;    ///< starts of the current side include those beyond gain()
    std::size_t next_start = 0;  ///< of the current side
    int repeats = 0;             ///< of the current iteration
    double best = infinity;      ///< distance of q from its place
    Eigen::Vector3d q = no_point;
    Eigen::Vector3d known = no_point;  ///< q if found from the current side
  };

  /// Searches of a group.
  struct SearchGroup {
    std::size_t begin, end;
    Eigen::AlignedBox3d places;  ///< bounding box of the places of all searches
  };

  /// Scratch data of a batch. The buffers are reused by later ones.
  struct Scratch {
    explicit Scratch(const Solver& solver)
        : sites(solver.exterior_, solver.sites_), closest(solver.grid_, solver.exterior_.surface()) {}
    NearbySites sites;
    ClosestTriangles closest;
    Eigen::AlignedBox3d places;  ///< of the group whose sites have been collected
    double reach = 0;            ///< sites within this distance of the places have been collected
    std::vector<Sample> samples;
    std::vector<OffsetDepthTask> depths;
    std::vector<std::size_t> tested;  ///< samples of the depths
    std::vector<Search> searches;
    std::vector<SearchGroup> groups;
    std::vector<OffsetPointTask> tasks;
    std::vector<std::size_t> running;  ///< searches with new starts; then by task
    std::vector<NearbySites::Site> starts;
    std::vector<OffsetExitTask> rays;
    std::vector<Eigen::Index> ray_samples;
    std::vector<std::uint32_t> nearby;  ///< indices of points
  };

  void sort();
  void solve_batch(const Batch& batch, Scratch& scratch) const;
  void collect_samples(const Batch& batch, Scratch& scratch) const;
  void find_direct(Scratch& scratch) const;
  void add_searches(Scratch& scratch) const;
  void set_q(Eigen::Index index, const Eigen::Vector3d& p, const Eigen::Vector3d& q, Scratch& scratch) const;
  void find_values(Scratch& scratch) const;
  [[nodiscard]] std::array<Eigen::Vector3d, 2> raised_sample(const Sample& sample) const;
  [[nodiscard]] std::int32_t covering_triangle(const Sample& sample, const Eigen::Vector3d& x,
                                               ClosestTriangles& triangles) const;
  bool find_starts(Scratch& scratch) const;
  void find_starts(Search& search, Scratch& scratch) const;
  static void set_starts(Search& search, std::size_t side, double margin, double apart, std::size_t max_count,
                         Scratch& scratch);
  void iterate(Scratch& scratch) const;
  [[nodiscard]] Eigen::Vector3d nearest_site(const Search& search) const;
  bool begin_iteration(Search& search, OffsetPointTask& task) const;
  [[nodiscard]] const NearbySites::Site* next_start(Search& search) const;
  bool is_continued(Search& search, OffsetPointTask& task, ClosestTriangles& triangles) const;
  std::array<double, 2> measure(const std::array<Eigen::Vector3d, 2>& places, Scratch& scratch) const;

  /// Maximum decrease of the distance, in cells, from a site to its refined point, with few exceptions. With fine cells
  /// it is up to 0.133 r.
  [[nodiscard]] double gain() const { return std::max(0.4, 0.133 * grid_.r); }
  /// Margin, in cells, for further sites if the iterations from the first ones fail.
  [[nodiscard]] double extended_margin() const { return 3 * gain(); }
  /// Minimum distance of the sites, in cells, from which iterations begin.
  static constexpr double apart = 2;

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
  std::vector<Batch> batches_;
};

/// Sorts the samples by block. Those outside the grid are missing.
void Solver::sort() {
  constexpr unsigned index_bits = 40;
  static_assert(max_grid_blocks <= std::size_t{1} << (64 - index_bits));
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
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const bool is_full = !batches_.empty() && groups_[g].begin - groups_[batches_.back().begin].begin >= batch_size;
    if (batches_.empty() || is_full) batches_.push_back({g, g});
    batches_.back().end = g + 1;
  }
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
std::int32_t Solver::covering_triangle(const Sample& sample, const Eigen::Vector3d& x,
                                       ClosestTriangles& triangles) const {
  if ((x - sample.p).norm() < (1 - surface_slack) * grid_.r) return sample.triangle;
  if (cells_around(exterior_, x).touches_exterior) return -1;
  const std::int32_t closest = triangles.closest_within(grid_.r, x);
  if (closest < 0) return -1;
  const double least = (1 - surface_slack) * grid_.r;
  return exterior_.surface().triangles.squared_distance(x, closest) < least * least ? closest : -1;
}

/// Sets the starts of one side of a search: sites whose distance exceeds the smallest by less than the margin.
void Solver::set_starts(Search& search, std::size_t side, double margin, double min_apart, std::size_t max_count,
                        Scratch& scratch) {
  scratch.sites.start_sites(side, margin, min_apart, max_count, scratch.starts);
  search.starts[side].count = scratch.starts.size();
  std::copy(scratch.starts.begin(), scratch.starts.end(), search.starts[side].list.begin());
}

/// Finds the first starts of a search, or further ones if these have failed.
void Solver::find_starts(Search& search, Scratch& scratch) const {
  search.needs_sites = false;
  search.next_start = 0;
  search.distances = measure(search.places, scratch);
  const auto& distances = search.distances;
  if (search.is_extended) {
    return set_starts(search, search.side, extended_margin(), apart / 2, max_starts, scratch);
  }
  search.side = distances[0] <= distances[1] ? 0 : 1;
  search.is_last_side = search.places[0] == search.places[1];
  for (const std::size_t side : {search.side, 1 - search.side}) {
    const bool is_used =
        side == search.side || (!search.is_last_side && distances[side] - gain() <= distances[1 - side]);
    if (is_used) set_starts(search, side, gain(), apart, max_starts / 3, scratch);
  }
}

/// Finds the starts of all searches that need them. Returns false if none does.
bool Solver::find_starts(Scratch& scratch) const {
  scratch.running.clear();
  for (const SearchGroup& group : scratch.groups) {
    scratch.places = group.places;
    scratch.reach = 0;
    for (std::size_t i = group.begin; i < group.end; ++i) {
      Search& search = scratch.searches[i];
      if (!search.needs_sites) continue;
      find_starts(search, scratch);
      scratch.running.push_back(i);
    }
  }
  return !scratch.running.empty();
}

/// Returns the next site from which a search begins on the current side; null if there is none.
const NearbySites::Site* Solver::next_start(Search& search) const {
  const Starts& starts = search.starts[search.side];
  while (search.next_start < starts.count) {
    const NearbySites::Site& start = starts.list[search.next_start++];
    const bool is_known = search.best < infinity && (sites_.place(start.site) - search.q).norm() < apart;
    if (!is_known && static_cast<double>(start.distance) - gain() <= search.best) return &start;
  }
  return nullptr;
}

/// Sets the next iteration of a search. Returns false if there is none, or more sites are needed.
bool Solver::begin_iteration(Search& search, OffsetPointTask& task) const {
  while (true) {
    if (const NearbySites::Site* start = next_start(search)) {
      task = {.p = search.places[search.side],
              .start = sites_.place(start->site),
              .triangle = sites_.triangle(start->site),
              .known = search.known,
              .found = {}};
      search.repeats = 0;
      return true;
    }
    if (!(search.best < infinity) && !search.is_extended) {
      search.is_extended = search.needs_sites = true;
      return false;
    }
    const double nearest = search.distances[search.side];
    if (search.is_last_side) return false;
    search.is_last_side = true;
    search.side = 1 - search.side;
    if (search.distances[search.side] - gain() > std::min(search.best, nearest)) return false;
    search.next_start = 0;
    search.is_extended = false;
    search.known = no_point;
  }
}

/// Evaluates an iteration. Returns true if it is continued, with a triangle that covers its result.
bool Solver::is_continued(Search& search, OffsetPointTask& task, ClosestTriangles& triangles) const {
  constexpr int max_repeats = 3;
  constexpr double nearly_free = 0.8;  // of r
  if (!task.found) return false;
  Eigen::Vector3d x = *task.found;
  const Eigen::Vector3d& p = search.sample.p;
  const std::int32_t triangle = search.repeats < max_repeats ? covering_triangle(search.sample, x, triangles) : -1;
  if (triangle >= 0) {
    ++search.repeats;
    task.start = x;
    task.triangle = triangle;
    return true;
  }
  const double height = (x - p).norm();
  if (height < nearly_free * grid_.r) return false;
  if (height < grid_.r) x = p + grid_.r / height * (x - p);
  const double distance = (x - search.places[search.side]).norm();
  if (!(distance < search.best)) return false;
  search.best = distance;
  search.q = search.known = x;
  return false;
}

/// Iterates from the starts that have been found.
void Solver::iterate(Scratch& scratch) const {
  std::vector<OffsetPointTask>& tasks = scratch.tasks;
  std::vector<std::size_t>& running = scratch.running;
  tasks.resize(running.size());
  const auto keep = [&](const auto& goes_on) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < running.size(); ++i) {
      if (!goes_on(scratch.searches[running[i]], tasks[i])) continue;
      tasks[kept] = tasks[i];
      running[kept++] = running[i];
    }
    tasks.resize(kept);
    running.resize(kept);
  };
  keep([this](Search& search, OffsetPointTask& task) { return begin_iteration(search, task); });
  while (!tasks.empty()) {
    find_nearest_offset_points(exterior_, scratch.closest, tasks);
    keep([&](Search& search, OffsetPointTask& task) {
      return is_continued(search, task, scratch.closest) || begin_iteration(search, task);
    });
  }
}

/// Returns the site nearest to the sample raised on the nearer side.
Eigen::Vector3d Solver::nearest_site(const Search& search) const {
  const Starts& starts = search.starts[search.distances[0] <= search.distances[1] ? 0 : 1];
  if (starts.count == 0) return search.sample.p + grid_.r * Eigen::Vector3d::UnitZ();
  return sites_.place(starts.list.front().site);
}

/// Returns a sample raised on either side.
std::array<Eigen::Vector3d, 2> Solver::raised_sample(const Sample& sample) const {
  const Eigen::Vector3d& p = sample.p;
  if (sample.normal.isZero()) return {p, p};
  const Eigen::Vector3d mean = means_.at(p, sample.normal);
  return {raised(p, sample.normal, mean, sample.depths[0], grid_.r),
          raised(p, -sample.normal, -mean, sample.depths[1], grid_.r)};
}

/// Sets the results that follow from q, and adds the ray to q'.
void Solver::set_q(Eigen::Index index, const Eigen::Vector3d& p, const Eigen::Vector3d& q, Scratch& scratch) const {
  const double height = (q - p).norm();
  const Eigen::Vector3d outward = (q - p) / height;
  results_.directions.row(index) = outward.transpose();
  results_.heights[index] = height * grid_.cell;
  scratch.rays.push_back({.origin = p, .direction = -outward});
  scratch.ray_samples.push_back(index);
}

/// Computes the values from the rays.
void Solver::find_values(Scratch& scratch) const {
  find_offset_exits(exterior_, scratch.closest, scratch.rays);
  for (std::size_t i = 0; i < scratch.rays.size(); ++i) {
    const Eigen::Index index = scratch.ray_samples[i];
    // Both ends are at least r away from p, except for rounding in single precision.
    const double beyond = (scratch.rays[i].exit - 2 * grid_.r) * grid_.cell;
    const double value = results_.heights[index] + beyond;
    results_.values[index] = value < 0 ? 0 : value;  // not std::max, which makes 0 of NaN
  }
}

/// Collects the samples of a batch that lie on the surface.
void Solver::collect_samples(const Batch& batch, Scratch& scratch) const {
  scratch.samples.clear();
  for (std::size_t g = batch.begin; g < batch.end; ++g) {
    for (std::size_t k = groups_[g].begin; k < groups_[g].end; ++k) {
      const Eigen::Index index = order_[k];
      const Eigen::Vector3d p = grid_.to_cells(points_.row(index).transpose());
      const std::int32_t triangle = likely_[static_cast<std::size_t>(index)];
      if (!is_on_surface(exterior_, shape_, p, triangle, scratch.nearby)) continue;
      scratch.samples.push_back(
          {.index = index, .p = p, .normal = normals_.row(index).transpose(), .triangle = triangle, .group = g});
    }
  }
}

/// Finds the samples whose q is p + r n or, if that is covered, p - r n.
void Solver::find_direct(Scratch& scratch) const {
  for (std::size_t side = 0; side < sides.size(); ++side) {
    scratch.depths.clear();
    scratch.tested.clear();
    for (std::size_t i = 0; i < scratch.samples.size(); ++i) {
      const Sample& sample = scratch.samples[i];
      if (sample.is_direct || sample.normal.isZero()) continue;
      scratch.depths.push_back({.x = sample.p + sides[side] * grid_.r * sample.normal});
      scratch.tested.push_back(i);
    }
    find_offset_depths(exterior_, scratch.closest, scratch.depths);
    for (std::size_t i = 0; i < scratch.tested.size(); ++i) {
      const OffsetDepthTask& place = scratch.depths[i];
      Sample& sample = scratch.samples[scratch.tested[i]];
      sample.is_direct = place.is_exterior;
      sample.q = place.x;
      sample.depths[side] = place.depth;
    }
  }
}

/// Sets q of the direct samples, and adds the others to the searches.
void Solver::add_searches(Scratch& scratch) const {
  scratch.searches.clear();
  scratch.groups.clear();
  std::size_t group = groups_.size();
  for (const Sample& sample : scratch.samples) {
    if (sample.is_direct) {
      results_.outcomes[static_cast<std::size_t>(sample.index)] = OffsetOutcome::direct;
      set_q(sample.index, sample.p, sample.q, scratch);
      continue;
    }
    if (sample.group != group) scratch.groups.push_back({scratch.searches.size(), 0, {}});
    group = sample.group;
    scratch.searches.push_back({.sample = sample, .places = raised_sample(sample)});
    for (const Eigen::Vector3d& place : scratch.searches.back().places) scratch.groups.back().places.extend(place);
    scratch.groups.back().end = scratch.searches.size();
  }
}

/// Solves the direct samples first; sites are collected around the others only.
void Solver::solve_batch(const Batch& batch, Scratch& scratch) const {
  scratch.rays.clear();
  scratch.ray_samples.clear();
  collect_samples(batch, scratch);
  find_direct(scratch);
  add_searches(scratch);
  while (find_starts(scratch)) iterate(scratch);
  for (const Search& search : scratch.searches) {
    const bool is_found = search.best < infinity;
    results_.outcomes[static_cast<std::size_t>(search.sample.index)] =
        is_found ? OffsetOutcome::searched : OffsetOutcome::undecided;
    set_q(search.sample.index, search.sample.p, is_found ? search.q : nearest_site(search), scratch);
  }
  find_values(scratch);
}

}  // namespace

OffsetResults solve_on_grid(const Shape& shape, const Points& points, const Points& normals,
                            const OffsetSolverOptions& options, const std::vector<std::int32_t>& triangles) {
  const Stopwatch stopwatch;
  const Eigen::AlignedBox3d bounds = bounding_box(shape);
  const GridLayout layout = choose_grid_layout(shape, bounds, options.offset, options.cells_per_offset);
  const BlockGrid grid(bounds, layout.offset, layout.cell);
  const GridSurface surface(grid, shape, layout.spacing, options.parallel);
  const ExteriorGrid exterior(grid, surface, site_band, options.parallel);
  const OffsetSites sites(exterior, site_band, options.parallel);
  const MeanNormals means(grid, shape, surface, options.parallel);
  OffsetResults results;
  results.offset = layout.offset;
  results.build_seconds = stopwatch.seconds();
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
