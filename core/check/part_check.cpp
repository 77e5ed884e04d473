#include "shapegauge/core/check/part_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/check/thin_cells.h"
#include "shapegauge/core/preparation/cavities.h"
#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/spatial/triangle_bvh.h"

namespace shapegauge {

namespace {

/// Returns the cells as a mesh.
Shape mesh_of(std::span<const ThinCell> cells) {
  Shape mesh;
  const auto count = static_cast<Eigen::Index>(cells.size());
  mesh.vertices.resize(3 * count, 3);
  mesh.triangles.resize(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) {
      mesh.vertices.row(3 * i + k) =
          cells[static_cast<std::size_t>(i)].cell.corners[static_cast<std::size_t>(k)].transpose();
      mesh.triangles(i, k) = static_cast<std::int32_t>(3 * i + k);
    }
  }
  return mesh;
}

/// Joins cells at sides that only one cell has: of neighbours of another size, and at T-junctions. A side is joined to
/// the cells at its middle. Distances are in the unit frame of the part.
void join_across_sizes(const Shape& cells, const UnitFrame& frame, std::span<const HalfEdge> sides,
                       DisjointSets& sets) {
  constexpr double touching = 1e-6;
  if (sides.empty()) return;
  Shape scaled = cells;
  scaled.vertices = ((cells.vertices.rowwise() - frame.centre.transpose()) / frame.diagonal).eval();
  const TriangleBVH tree(scaled);
  for (const HalfEdge& side : sides) {
    const Eigen::Vector3d middle = (scaled.vertices.row(side.low) + scaled.vertices.row(side.high)).transpose() / 2;
    const Cone half_space{middle - 2 * touching * Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ(), 0};
    Ball ball{.centre = middle, .radius = touching};
    tree.search(half_space, ball, [&](std::span<const std::int32_t> found, const Ball&) {
      for (const std::int32_t cell : found) {
        if ((closest_point(tree.triangle(cell), middle) - middle).norm() <= touching) sets.join(side.triangle, cell);
      }
    });
  }
}

/// Returns the cells of each connected region.
std::vector<std::vector<std::int32_t>> connected(std::span<const ThinCell> cells, const UnitFrame& frame) {
  const Shape mesh = mesh_of(cells);
  const std::vector<std::int32_t> merged = welded_vertices(mesh.vertices);
  const std::vector<HalfEdge> sides = half_edges(mesh.triangles, merged);
  DisjointSets sets;
  sets.grow_to(cells.size());
  std::vector<HalfEdge> unmatched;
  for_each_edge(std::span(sides), [&](std::span<const HalfEdge> uses) {
    if (uses.size() == 1) unmatched.push_back(uses[0]);
    for (const HalfEdge& use : uses) sets.join(uses[0].triangle, use.triangle);
  });
  join_across_sizes(mesh, frame, unmatched, sets);
  std::vector<std::vector<std::int32_t>> members(cells.size());
  for (std::int32_t i = 0; i < std::ssize(cells); ++i) members[static_cast<std::size_t>(sets.find(i))].push_back(i);
  std::erase_if(members, [](const auto& some) { return some.empty(); });
  return members;
}

double least_of(const ThinCell& cell) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::optional<double>& diameter : cell.diameters) least = std::min(least, diameter.value_or(least));
  return least;
}

/// Returns the median of the diameters of cells by area.
double median_of(std::span<const ThinCell> cells, std::span<const std::int32_t> members) {
  std::vector<std::pair<double, double>> diameters;  // with their areas
  double total = 0;
  for (const std::int32_t i : members) {
    const ThinCell& cell = cells[static_cast<std::size_t>(i)];
    const auto below = std::ranges::count_if(cell.diameters, &std::optional<double>::has_value);
    for (const std::optional<double>& diameter : cell.diameters) {
      if (diameter) diameters.emplace_back(*diameter, cell.area / static_cast<double>(below));
    }
    total += cell.area;
  }
  std::ranges::sort(diameters);
  double sum = 0;
  for (const auto& [diameter, area] : diameters) {
    sum += area;
    if (2 * sum >= total) return diameter;
  }
  return diameters.back().first;
}

ThinRegion region_of(std::span<const ThinCell> cells, std::span<const std::int32_t> members) {
  ThinRegion region;
  for (const std::int32_t i : members) {
    const ThinCell& cell = cells[static_cast<std::size_t>(i)];
    region.area += cell.area;
    region.edge_share += cell.area * cell.edge_share;
    region.faces.push_back(cell.cell.face);
  }
  region.edge_share = region.area > 0 ? region.edge_share / region.area : 0;
  std::ranges::sort(region.faces);
  const auto repeated = std::ranges::unique(region.faces);
  region.faces.erase(repeated.begin(), repeated.end());
  region.median = median_of(cells, members);
  return region;
}

/// Adds the smallest ball of a region.
void measure_least(const CellSampler& sampler, std::span<const ThinCell> cells, std::span<const std::int32_t> members,
                   ThinRegion& region) {
  const auto value = [&](std::int32_t i) { return least_of(cells[static_cast<std::size_t>(i)]); };
  const MeasuredPoint least =
      sampler.least_near(cells[static_cast<std::size_t>(*std::ranges::min_element(members, {}, value))]);
  region.least = least.ball.diameter;
  region.position = least.position;
  region.opposite = least.ball.contact;
}

ThinRegions regions_below(const Shape& mesh, const TouchingBalls& balls, BallSide side, double limit,
                          const CheckOptions& options) {
  ThinRegions result{.limit = limit, .regions = {}};
  if (limit == 0) return result;
  const CellSampler sampler(mesh, balls, side, limit, options.ball.parallel);
  result.spacing = sampler.spacing();
  const std::vector<ThinCell> cells = sampler.thin_cells();
  for (const std::vector<std::int32_t>& members : connected(cells, unit_frame(mesh))) {
    ThinRegion region = region_of(cells, members);
    if (region.area < options.min_area) {
      ++result.small_regions;
      result.small_area += region.area;
      continue;
    }
    measure_least(sampler, cells, members, region);
    result.regions.push_back(std::move(region));
  }
  std::ranges::stable_sort(result.regions, std::greater{}, &ThinRegion::area);
  return result;
}

void check_input(const Shape& mesh, const CheckOptions& options) {
  require_usable(mesh);
  if (is_cloud(mesh)) throw InputError("walls and gaps are checked on meshes, and this shape has no faces");
  if (!(surface_area(mesh) > 0)) throw InputError("the mesh has no area");
  for (const auto& [name, value] : {std::pair<std::string_view, double>{"min_wall", options.min_wall},
                                    {"min_gap", options.min_gap},
                                    {"min_area", options.min_area}}) {
    if (!(value >= 0 && std::isfinite(value))) {
      throw ArgumentError(std::string("`") + std::string(name) + "` must be a finite number, 0 or more");
    }
  }
  if (options.min_wall == 0 && options.min_gap == 0) throw ArgumentError("`min_wall` or `min_gap` is required");
}

}  // namespace

bool ThinRegions::pass() const { return std::ranges::all_of(regions, &ThinRegion::is_edge); }

PartReport check_part(const Shape& mesh, const CheckOptions& options) {
  check_input(mesh, options);
  PartReport report;
  report.closed = is_closed_and_oriented(mesh);
  report.voids = closed_components(mesh).cavities;
  const bool inside_out = report.closed && signed_volume(mesh) < 0;
  const TouchingBalls balls(mesh, options.ball);
  const auto side = [&](BallSide of_outward) {
    const bool inside = (of_outward == BallSide::inside) != inside_out;
    return inside ? BallSide::inside : BallSide::outside;
  };
  report.walls = regions_below(mesh, balls, side(BallSide::inside), options.min_wall, options);
  report.gaps = regions_below(mesh, balls, side(BallSide::outside), options.min_gap, options);
  return report;
}

}  // namespace shapegauge
