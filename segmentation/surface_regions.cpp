// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/segmentation/surface_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/spatial/ray_caster.h"

namespace shapegauge {

namespace {

// All lengths are in units (ThickSurface::unit).
constexpr double turn_cost = 0.01;  ///< of a link in a concavity, a radian
constexpr double max_turn = 1;      ///< radians
constexpr double thickness_cost = 0.01;
constexpr double near_distance = 0.1;
constexpr double wide_distance = 0.25;
constexpr double outside_distance = 0.01;  ///< of what looks at others from outside
constexpr double min_slope = 0.1;          ///< sine of a ray's angle with the surface that it leaves for the outside
constexpr double max_border_turn = 1.5;
constexpr double fold = 0.1;  ///< turn of a border that counts as folded

/// Starting depths of lines of sight below the surface, as fractions of the thickness.
constexpr std::array<double, 2> depths = {0.1, 0.5};
constexpr std::array<PairSum, 2> seen_sums = {PairSum::seen_shallow, PairSum::seen_deep};

/// Nodes that represent their patch.
struct PatchSample {
  std::int32_t node;
  std::int32_t patch;
  double area;  ///< area represented by the node
};

/// Selects nodes of each patch at equal steps of cumulative area, in the order of the nodes.
std::vector<PatchSample> sampled(const ThickSurface& surface, std::span<const std::int32_t> patch,
                                 const Regions& regions, int samples) {
  std::vector<std::int32_t> nodes;
  for (std::size_t i = 0; i < patch.size(); ++i) {
    if (patch[i] >= 0) nodes.push_back(static_cast<std::int32_t>(i));
  }
  const auto by_patch = bucket_sort(nodes, static_cast<std::size_t>(regions.initial_size()),
                                    [&](std::int32_t node) { return patch[static_cast<std::size_t>(node)]; });
  std::vector<PatchSample> result;
  const double whole = surface.unit * surface.unit;
  for (std::int32_t p = 0; p < regions.initial_size(); ++p) {
    const double area = regions.of(p).area;
    const auto count = std::max(1L, std::lround(area * samples));
    const double step = area / static_cast<double>(count);
    double passed = 0;
    long added = 0;
    for (std::size_t i = by_patch.first[static_cast<std::size_t>(p)];
         i < by_patch.first[static_cast<std::size_t>(p) + 1]; ++i) {
      passed += surface.graph.samples.weights[by_patch.values[i]] / whole;
      for (; added < count && passed >= (static_cast<double>(added) + 0.5) * step; ++added) {
        result.push_back({by_patch.values[i], p, step});
      }
    }
  }
  return result;
}

void add_nodes(Regions& regions, const ThickSurface& surface, std::span<const std::int32_t> patch) {
  const Samples& samples = surface.graph.samples;
  const double whole = samples.weights.sum();
  const Eigen::RowVector3d centre = samples.weights.transpose() * samples.points / whole;
  const double bin_width = -std::log(min_histogram_thickness) / thickness_bins;
  for (std::int32_t i = 0; i < surface.graph.size(); ++i) {
    if (patch[static_cast<std::size_t>(i)] < 0) continue;
    const double area = samples.weights[i] / whole;
    const double thickness = surface.log_thickness[i];
    const Eigen::Vector3d position = (samples.points.row(i) - centre).transpose() / surface.unit;
    const Eigen::Vector3d normal = samples.normals.row(i).transpose();
    RegionSum sum;
    sum.nodes = 1;
    sum.area = area;
    sum.thickness = area * thickness;
    sum.squared_thickness = area * thickness * thickness;
    sum.position = area * position;
    sum.squared_position = area * position * position.transpose();
    sum.squared_normal = area * normal * normal.transpose();
    const double bin = (thickness - std::log(min_histogram_thickness)) / bin_width;
    sum.histogram[static_cast<Eigen::Index>(std::clamp(bin, 0.0, thickness_bins - 1.0))] = area;
    regions.add(patch[static_cast<std::size_t>(i)], sum);
  }
}

void add_borders(Regions& regions, const ThickSurface& surface, std::span<const std::int32_t> patch) {
  for (std::int32_t i = 0; i < surface.graph.size(); ++i) {
    for (const SurfaceLink& link : surface.graph.links_of(i)) {
      const std::int32_t a = patch[static_cast<std::size_t>(i)];
      const std::int32_t b = patch[static_cast<std::size_t>(link.to)];
      if (a < 0 || a >= b) continue;
      regions.make_neighbours(a, b);
      const double length = link.length / surface.unit;
      const double turn = surface.normal_angle(i, link);
      regions.add(a, b, PairSum::border, length);
      regions.add(a, b, turn > 0 ? PairSum::concave : PairSum::convex,
                  length * std::min(std::abs(turn), max_border_turn));
      if (turn > fold) regions.add(a, b, PairSum::folded, length);
      regions.add(a, b, PairSum::thickness, length * (surface.log_thickness[i] + surface.log_thickness[link.to]) / 2);
    }
  }
}

void add_opposites(Regions& regions, const ThickSurface& surface, std::span<const std::int32_t> patch,
                   const RayCaster& caster) {
  const Samples& samples = surface.graph.samples;
  const int per_node = surface.barrier_triangles_per_node;
  std::vector<std::int32_t> opposite(patch.size(), -1);
  parallel_for(std::int32_t{0}, surface.graph.size(), [&](std::int32_t i) {
    const Eigen::Vector3d normal = samples.normals.row(i);
    if (normal.isZero(0)) return;
    // Starts just below the surface, which avoids the overlapping splats of a cloud.
    const double depth = depths[0] * std::exp(surface.log_thickness[i]) * surface.unit;
    const RayHit hit = caster.first_hit(samples.points.row(i).transpose() - depth * normal, -normal);
    if (hit) opposite[static_cast<std::size_t>(i)] = hit.triangle / per_node;
  });
  const double whole = samples.weights.sum();
  for (std::size_t i = 0; i < opposite.size(); ++i) {
    const std::int32_t other = opposite[i] < 0 ? -1 : patch[static_cast<std::size_t>(opposite[i])];
    if (patch[i] < 0 || other < 0) continue;
    regions.add(patch[i], other, PairSum::opposite, samples.weights[static_cast<Eigen::Index>(i)] / whole / 2);
  }
}

/// Returns, for every pair of points, row by row above the diagonal, whether the straight line between them is free;
/// false if `condition(i, j)` is false.
template <typename Condition>
std::vector<std::vector<char>> free_lines(const RayCaster& caster, const Points& positions, Condition condition) {
  const auto count = static_cast<std::size_t>(positions.rows());
  std::vector<std::vector<char>> free(count);
  parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    const auto from = static_cast<Eigen::Index>(i);
    const Eigen::Vector3d origin = positions.row(from);
    std::vector<Eigen::Vector3d> directions;
    std::vector<std::pair<std::size_t, double>> targets;
    free[i].assign(count - i, 0);
    for (Eigen::Index to = from + 1; to < positions.rows(); ++to) {
      if (!condition(from, to)) continue;
      const Eigen::Vector3d way = positions.row(to).transpose() - origin;
      const double length = way.norm();
      if (!(length > 0)) continue;
      directions.emplace_back(way / length);
      targets.emplace_back(static_cast<std::size_t>(to), length);
    }
    std::vector<RayHit> hits(directions.size());
    caster.first_hits(origin, directions, {}, hits);
    for (std::size_t k = 0; k < hits.size(); ++k) {
      free[i][targets[k].first - i] = !hits[k] || hits[k].distance >= targets[k].second ? 1 : 0;
    }
  });
  return free;
}

class Sights {
 public:
  Sights(Regions& regions, const ThickSurface& surface, const RayCaster& caster, std::vector<PatchSample> samples)
      : regions_(regions),
        surface_(surface),
        caster_(caster),
        samples_(std::move(samples)),
        points_(std::ssize(samples_), 3),
        normals_(std::ssize(samples_), 3) {
    for (Eigen::Index i = 0; i < points_.rows(); ++i) {
      points_.row(i) = surface.graph.samples.points.row(sample(i).node);
      normals_.row(i) = surface.graph.samples.normals.row(sample(i).node);
    }
  }

  void add_inside() {
    for (std::size_t d = 0; d < depths.size(); ++d) {
      Points positions = points_;
      for (Eigen::Index i = 0; i < positions.rows(); ++i) {
        const double thickness = std::exp(surface_.log_thickness[sample(i).node]) * surface_.unit;
        positions.row(i) -= depths[d] * thickness * normals_.row(i);
      }
      add_free(positions, seen_sums[d], [](Eigen::Index, Eigen::Index) { return true; });
    }
  }

  void add_outside() {
    const Points positions = points_ + outside_distance * surface_.unit * normals_;
    add_free(positions, PairSum::seen_outside, [&](Eigen::Index i, Eigen::Index j) {
      const Eigen::RowVector3d way = positions.row(j) - positions.row(i);
      const double least = min_slope * way.norm();
      return normals_.row(i).dot(way) >= least && normals_.row(j).dot(way) <= -least;
    });
  }

  /// Adds the tilts of surface normals towards each other, which need no rays.
  void add_tilts() {
    for (Eigen::Index i = 0; i < points_.rows(); ++i) {
      for (Eigen::Index j = i + 1; j < points_.rows(); ++j) {
        add(i, j, PairSum::pairs, 1);
        const Eigen::RowVector3d way = points_.row(j) - points_.row(i);
        const double length = way.norm();
        if (!(length > 0)) continue;
        const Eigen::RowVector3d turned =
            surface_.smooth_normals.row(sample(i).node) - surface_.smooth_normals.row(sample(j).node);
        const double tilt = turned.dot(way) / length;
        if (length < near_distance * surface_.unit) {
          add(i, j, PairSum::near_pairs, 1);
          add(i, j, PairSum::near_tilt, tilt);
        }
        if (length < wide_distance * surface_.unit) {
          add(i, j, PairSum::wide_pairs, 1);
          add(i, j, PairSum::wide_tilt, tilt);
        }
      }
    }
  }

 private:
  [[nodiscard]] const PatchSample& sample(Eigen::Index i) const { return samples_[static_cast<std::size_t>(i)]; }

  void add(Eigen::Index i, Eigen::Index j, PairSum what, double value) {
    regions_.add(sample(i).patch, sample(j).patch, what, sample(i).area * sample(j).area * value);
  }

  template <typename Condition>
  void add_free(const Points& positions, PairSum what, Condition condition) {
    const std::vector<std::vector<char>> free = free_lines(caster_, positions, condition);
    for (std::size_t i = 0; i < free.size(); ++i) {
      for (std::size_t k = 1; k < free[i].size(); ++k) {
        if (free[i][k] != 0) add(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i + k), what, 1);
      }
    }
  }

  Regions& regions_;
  const ThickSurface& surface_;
  const RayCaster& caster_;
  std::vector<PatchSample> samples_;
  Points points_;
  Points normals_;
};

/// Returns false for a surface that is narrower than rays resolve, which are of single precision: every ray then meets
/// all triangles.
bool is_resolved(const ThickSurface& surface) {
  constexpr double min_share = 1e-7;
  const double diagonal = bounding_box_diagonal(surface.barrier);
  return surface.unit * surface.unit > min_share * diagonal * diagonal;
}

}  // namespace

std::vector<double> patch_costs(const ThickSurface& surface) {
  std::vector<double> costs;
  costs.reserve(surface.graph.links.size());
  for (std::int32_t i = 0; i < surface.graph.size(); ++i) {
    for (const SurfaceLink& link : surface.graph.links_of(i)) {
      const double turn = std::clamp(surface.normal_angle(i, link), 0.0, max_turn);
      const double change = std::abs(surface.log_thickness[i] - surface.log_thickness[link.to]);
      costs.push_back(link.distance + surface.unit * (turn_cost * turn + thickness_cost * change));
    }
  }
  return costs;
}

Regions surface_regions(const ThickSurface& surface, std::span<const std::int32_t> patch, int samples) {
  Regions regions(patch.empty() ? 0 : *std::ranges::max_element(patch) + 1);
  add_nodes(regions, surface, patch);
  add_borders(regions, surface, patch);
  const RayCaster caster(surface.barrier, EdgeHandling::fast);
  if (!is_resolved(surface)) return regions;
  add_opposites(regions, surface, patch, caster);
  Sights sights(regions, surface, caster, sampled(surface, patch, regions, samples));
  sights.add_inside();
  sights.add_outside();
  sights.add_tilts();
  return regions;
}

}  // namespace shapegauge
