// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/check/part_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
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

/// Returns cells as a mesh without common vertices. `cell_of` returns the Cell of an element.
template <typename Element, typename CellOf>
Shape mesh_of(const std::vector<Element>& elements, const CellOf& cell_of) {
  Shape mesh;
  const auto count = static_cast<Eigen::Index>(elements.size());
  mesh.vertices.resize(3 * count, 3);
  mesh.triangles.resize(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Cell& cell = cell_of(elements[static_cast<std::size_t>(i)]);
    for (int k = 0; k < 3; ++k) {
      mesh.vertices.row(3 * i + k) = cell.corners[static_cast<std::size_t>(k)].transpose();
      mesh.triangles(i, k) = static_cast<std::int32_t>(3 * i + k);
    }
  }
  return mesh;
}

/// Joins the vertices of a mesh at equal positions.
Shape welded(const Shape& mesh) {
  const std::vector<std::int32_t> merged = welded_vertices(mesh.vertices);
  std::vector<std::int32_t> index(merged.size());
  std::vector<std::int32_t> distinct;
  for (std::size_t v = 0; v < merged.size(); ++v) {
    const bool first = merged[v] == static_cast<std::int32_t>(v);
    index[v] = first ? static_cast<std::int32_t>(distinct.size()) : index[static_cast<std::size_t>(merged[v])];
    if (first) distinct.push_back(merged[v]);
  }
  Shape result{.vertices = mesh.vertices(distinct, Eigen::all), .triangles = mesh.triangles};
  for (std::int32_t& corner : result.triangles.reshaped()) corner = index[static_cast<std::size_t>(corner)];
  return result;
}

/// Pairs of cells that share a side.
using Links = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// Adds the links at sides that only one cell has: of neighbours of another size, and at T-junctions. A side is linked
/// to the cells at its middle. Distances are in the unit frame of the part.
void link_across_sizes(const Shape& cells, const UnitFrame& frame, std::span<const HalfEdge> sides, Links& links) {
  constexpr double touching = 1e-6;
  if (sides.empty()) return;
  Shape scaled = cells;
  scaled.vertices = ((cells.vertices.rowwise() - frame.centre.transpose()) / frame.diagonal).eval();
  const TriangleBVH tree(scaled);
  for (const HalfEdge& side : sides) {
    const Eigen::Vector3d middle = (scaled.vertices.row(side.low) + scaled.vertices.row(side.high)).transpose() / 2;
    const Cone half_space{middle - 2 * touching * Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ(), 0};
    Ball ball{.centre = middle, .radius = touching};
    tree.search(half_space, ball, [&](std::int32_t cell, const Ball&) {
      if (cell < 0) return;
      const bool touches = (closest_point(tree.triangle(cell), middle) - middle).norm() <= touching;
      if (touches) links.emplace_back(side.triangle, cell);
    });
  }
}

Links links_between(const std::vector<ThinCell>& cells, const UnitFrame& frame) {
  const Shape mesh = mesh_of(cells, [](const ThinCell& cell) -> const Cell& { return cell.cell; });
  const std::vector<HalfEdge> sides = half_edges(mesh.triangles, welded_vertices(mesh.vertices));
  Links links;
  std::vector<HalfEdge> unmatched;
  for_each_edge(std::span(sides), [&](std::span<const HalfEdge> uses) {
    if (uses.size() == 1) unmatched.push_back(uses[0]);
    for (const HalfEdge& use : uses.subspan(1)) links.emplace_back(uses[0].triangle, use.triangle);
  });
  link_across_sizes(mesh, frame, unmatched, links);
  return links;
}

ThinCell& at(std::vector<ThinCell>& cells, std::int32_t i) { return cells[static_cast<std::size_t>(i)]; }
const ThinCell& at(std::span<const ThinCell> cells, std::int32_t i) { return cells[static_cast<std::size_t>(i)]; }

/// Returns the cells of each region: connected, and either edges or walls.
std::vector<std::vector<std::int32_t>> connected(std::span<const ThinCell> cells, const Links& links) {
  DisjointSets sets;
  sets.grow_to(cells.size());
  for (const auto& [i, j] : links) {
    if (at(cells, i).is_edge == at(cells, j).is_edge) sets.join(i, j);
  }
  std::vector<std::vector<std::int32_t>> members(cells.size());
  for (std::int32_t i = 0; i < std::ssize(cells); ++i) members[static_cast<std::size_t>(sets.find(i))].push_back(i);
  std::erase_if(members, [](const auto& some) { return some.empty(); });
  return members;
}

double min_of(const ThinCell& cell) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::optional<double>& diameter : cell.diameters) least = std::min(least, diameter.value_or(least));
  return least;
}

/// Turns edges whose diameter does not fall to 0 into walls, and walls next to edges into edges if their area is
/// smaller than the square of the limit.
void settle_edges(std::vector<ThinCell>& cells, const Links& links, double limit) {
  if (std::ranges::none_of(cells, &ThinCell::is_edge)) return;
  for (const std::vector<std::int32_t>& members : connected(cells, links)) {
    const auto is_sharp = [&](std::int32_t i) { return min_of(at(cells, i)) <= CellSampler::border_size * limit; };
    if (!at(cells, members[0]).is_edge || std::ranges::any_of(members, is_sharp)) continue;
    for (const std::int32_t i : members) at(cells, i).is_edge = false;
  }
  std::vector<bool> at_border(cells.size());
  for (const auto& [i, j] : links) {
    if (at(cells, i).is_edge == at(cells, j).is_edge) continue;
    for (const std::int32_t cell : {i, j}) at_border[static_cast<std::size_t>(cell)] = true;
  }
  for (const std::vector<std::int32_t>& members : connected(cells, links)) {
    double area = 0;
    for (const std::int32_t i : members) area += at(cells, i).area;
    const auto is_at_border = [&](std::int32_t i) -> bool { return at_border[static_cast<std::size_t>(i)]; };
    if (area >= limit * limit || std::ranges::none_of(members, is_at_border)) continue;
    for (const std::int32_t i : members) at(cells, i).is_edge = true;
  }
}

/// Diameters with the areas that they represent.
using WeightedDiameters = std::vector<std::pair<double, double>>;

/// Adds the diameters in a triangle, interpolated between those at its corners, in steps of 1 % or of `levels`
/// divisions into four.
void add_diameters(const std::array<double, 3>& corners, double area, int levels, WeightedDiameters& diameters) {
  const auto [a, b, c] = corners;
  if (levels == 0 || std::max({a, b, c}) < 1.01 * std::min({a, b, c})) {
    diameters.emplace_back((a + b + c) / 3, area);
    return;
  }
  const std::array<double, 3> middles{(b + c) / 2, (c + a) / 2, (a + b) / 2};
  add_diameters(middles, area / 4, levels - 1, diameters);
  add_diameters({a, middles[1], middles[2]}, area / 4, levels - 1, diameters);
  add_diameters({b, middles[2], middles[0]}, area / 4, levels - 1, diameters);
  add_diameters({c, middles[0], middles[1]}, area / 4, levels - 1, diameters);
}

/// Returns the median of the diameters of cells by area. Corners beyond the border of a region have the least of the
/// cell's diameters.
double median_of(std::span<const ThinCell> cells, std::span<const std::int32_t> members) {
  WeightedDiameters diameters;
  double total = 0;
  for (const std::int32_t i : members) {
    const ThinCell& cell = at(cells, i);
    const double least = min_of(cell);
    const auto& [a, b, c] = cell.diameters;
    add_diameters({a.value_or(least), b.value_or(least), c.value_or(least)}, cell.area, 3, diameters);
    total += cell.area;
  }
  std::ranges::sort(diameters);
  double sum = 0;
  double median = 0;
  for (const auto& [diameter, area] : diameters) {
    if (2 * sum >= total) break;
    median = diameter;
    sum += area;
  }
  return median;
}

ThinRegion region_of(std::span<const ThinCell> cells, const std::vector<std::int32_t>& members) {
  ThinRegion region{.is_edge = at(cells, members[0]).is_edge, .faces = {}};
  for (const std::int32_t i : members) {
    const ThinCell& cell = at(cells, i);
    region.area += cell.area;
    region.faces.push_back(cell.cell.face);
  }
  std::ranges::sort(region.faces);
  region.faces.erase(std::unique(region.faces.begin(), region.faces.end()), region.faces.end());
  region.median = median_of(cells, members);
  return region;
}

/// Adds the smallest ball of a region.
void measure_smallest(const CellSampler& sampler, std::span<const ThinCell> cells,
                      const std::vector<std::int32_t>& members, ThinRegion& region) {
  const auto value = [&](std::int32_t i) { return min_of(at(cells, i)); };
  const SampledBall smallest = sampler.smallest_ball_in(at(cells, *std::ranges::min_element(members, {}, value)));
  region.minimum = smallest.ball.diameter;
  region.position = smallest.position;
  region.opposite = smallest.ball.contact;
}

/// Returns CheckOptions::min_area with its lower bound for this limit.
double min_area_of_regions(const Shape& mesh, double limit, const CheckOptions& options) {
  const double resolution = limit * CellSampler::border_size;
  return std::max(options.min_area, std::min(resolution * resolution, surface_area(mesh) / 100));
}

ThinRegions regions_of(const CellSampler& sampler, std::vector<ThinCell>& cells, const UnitFrame& frame,
                       double min_area) {
  ThinRegions result{.limit = sampler.limit(), .regions = {}, .spacing = sampler.spacing()};
  const Links links = links_between(cells, frame);
  settle_edges(cells, links, sampler.limit());
  for (const std::vector<std::int32_t>& members : connected(cells, links)) {
    ThinRegion region = region_of(cells, members);
    if (region.area < min_area) {
      ++result.small_regions;
      result.small_area += region.area;
      continue;
    }
    measure_smallest(sampler, cells, members, region);
    result.regions.push_back(std::move(region));
  }
  std::ranges::stable_sort(result.regions, {},
                           [](const ThinRegion& region) { return std::pair(region.is_edge, -region.area); });
  return result;
}

/// Regions below one limit and the cells that they consist of.
struct CheckedSide {
  ThinRegions found;
  DividedCells cells;
};

/// Checks one side of the surface, divided into cells before.
CheckedSide check_side(const Shape& mesh, const TouchingBalls& balls, BallSide side, double limit,
                       const CheckOptions& options, std::vector<Cell> cells) {
  if (limit == 0) {
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i].origin = static_cast<std::int32_t>(i);
    return {.found = {.regions = {}}, .cells = {.thin = {}, .others = std::move(cells)}};
  }
  const CellSampler sampler(mesh, balls, side, limit, options.ball.parallel);
  CheckedSide result{.found = {.regions = {}}, .cells = sampler.divide(std::move(cells))};
  result.found = regions_of(sampler, result.cells.thin, unit_frame(mesh), min_area_of_regions(mesh, limit, options));
  return result;
}

/// Returns the surface as the check of gaps divided it.
CheckedSurface surface_of(const CheckedSide& walls, const CheckedSide& gaps) {
  const std::vector<Cell> cells = gaps.cells.all();
  CheckedSurface surface{.mesh = welded(mesh_of(cells, [](const Cell& cell) -> const Cell& { return cell; })),
                         .fractions = {}};
  surface.fractions.setConstant(std::ssize(cells), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    double fraction = std::numeric_limits<double>::infinity();
    const auto origin = static_cast<std::size_t>(cells[i].origin);
    if (origin < walls.cells.thin.size()) fraction = min_of(walls.cells.thin[origin]) / walls.found.limit;
    if (i < gaps.cells.thin.size()) fraction = std::min(fraction, min_of(gaps.cells.thin[i]) / gaps.found.limit);
    if (std::isfinite(fraction)) surface.fractions[static_cast<Eigen::Index>(i)] = fraction;
  }
  return surface;
}

void check_input(const Shape& mesh, const CheckOptions& options) {
  require_usable(mesh);
  if (is_cloud(mesh))
    throw InputError(
        "walls and gaps are checked on meshes, and this shape has no faces; reconstruct its surface first");
  if (!(surface_area(mesh) > 0)) throw InputError("the mesh has no area: all its triangles are degenerate");
  for (const auto& [name, value] : {std::pair<std::string_view, double>{"min_wall", options.min_wall},
                                    {"min_gap", options.min_gap},
                                    {"min_area", options.min_area}}) {
    if (!(value >= 0 && std::isfinite(value))) {
      throw ArgumentError(std::string("`") + std::string(name) + "` is " + std::to_string(value) +
                          "; it must be a finite number, 0 or more");
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
  CheckedSide walls = check_side(mesh, balls, side(BallSide::inside), options.min_wall, options, cells_of(mesh));
  CheckedSide gaps = check_side(mesh, balls, side(BallSide::outside), options.min_gap, options, walls.cells.all());
  if (options.keep_surface) report.surface = surface_of(walls, gaps);
  report.walls = std::move(walls.found);
  report.gaps = std::move(gaps.found);
  return report;
}

}  // namespace shapegauge
