#include "tests/oracle/offset_exterior.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "tests/oracle/exterior_flood.h"
#include "tests/oracle/half_spaces.h"

namespace shapegauge {

namespace {

/// The smallest cube, as a fraction of the diagonal, that the octree is refined to however small r is.
constexpr double finest_resolution = 1.0 / 256;
/// On a closed surface cubes are not refined beyond this where 3r/4 is larger: there would be many.
constexpr double closed_resolution = 1.0 / 128;
/// The smallest into which unsettled ones are divided further.
constexpr double finest_pocket = 1.0 / 1024;
/// Bounds memory (some 100 bytes a node while flooding) and time on shapes that fill their box.
constexpr std::size_t most_nodes = 3'000'000;
const double root_of_three = std::sqrt(3.0);

/// Edge of the smallest cubes. Free points nearer to each other than 2r are on the same side of a closed surface: with
/// cubes up to 0.76 r those of a cube and of all around it.
double smallest_cube(double r, double diagonal, bool closed) {
  const double wanted = closed ? std::clamp(closed_resolution * diagonal, r / 2, 3 * r / 4) : r / 2;
  return std::max(wanted, finest_resolution * diagonal);
}

}  // namespace

OffsetExterior::OffsetExterior(const SurfaceTree& tree, const Eigen::AlignedBox3d& bounds, double r, bool closed)
    : tree_(tree), r_(r), closed_(closed) {
  const double diagonal = bounds.diagonal().norm();
  const double smallest = smallest_cube(r, diagonal, closed);
  // A margin of two cubes of free space all around, so that the flood can start anywhere on the root's border.
  const double needed = bounds.sizes().maxCoeff() + 2 * r + 4 * smallest;
  double size = smallest;
  while (size < needed) size *= 2;
  root_centre_ = bounds.center();
  root_half_ = size / 2;
  nodes_.emplace_back();
  classify(root(), tree_.closest_to_each({{root_centre_}}, r_ + root_of_three * root_half_)[0]);
  std::vector<ExteriorCell> mixed{root()};
  resolution_ = 2 * root_half_;
  while (resolution_ > smallest * 1.5 && divide(mixed)) resolution_ /= 2;
  ExteriorFlood flood;
  flood.run(*this, nodes_);
  if (closed_) {
    look_for_passages(flood);
  } else {
    settle_pockets(std::max(r / 16, finest_pocket * diagonal), flood);
  }
  mark_exterior(0);
}

ExteriorCell OffsetExterior::octant(const ExteriorCell& cell, int i, std::int32_t node) {
  const double half = cell.half / 2;
  const Eigen::Vector3d direction((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
  return {cell.centre + half * direction, half, node};
}

void OffsetExterior::classify(const ExteriorCell& cell, const SurfaceTree::Nearest& nearest) {
  ExteriorNode& node = nodes_[static_cast<std::size_t>(cell.node)];
  if (nearest.triangle < 0) {
    node.kind = CellKind::free;
    return;
  }
  const auto distance = static_cast<double>(nearest.distance);
  node.triangle = nearest.triangle;
  node.clearance = static_cast<float>(distance - r_);
  if (distance + root_of_three * cell.half < r_) node.kind = CellKind::solid;
}

bool OffsetExterior::divide(std::vector<ExteriorCell>& mixed) {
  if (mixed.empty() || nodes_.size() + 8 * mixed.size() > most_nodes) return false;
  std::vector<ExteriorCell> smaller;
  for (const ExteriorCell& cell : mixed) {
    const auto first = static_cast<std::int32_t>(nodes_.size());
    const double distance = r_ + static_cast<double>(nodes_[static_cast<std::size_t>(cell.node)].clearance);
    nodes_[static_cast<std::size_t>(cell.node)].kind = CellKind::divided;
    nodes_[static_cast<std::size_t>(cell.node)].first_child = first;
    nodes_.resize(nodes_.size() + 8);
    std::array<Eigen::Vector3d, 8> centres;
    for (int i = 0; i < 8; ++i) centres[static_cast<std::size_t>(i)] = octant(cell, i, first + i).centre;
    const double radius = root_of_three * cell.half / 2;
    const auto nearest = tree_.closest_to_each(centres, std::min(r_, distance * (1 + 1e-6)) + radius);
    for (int i = 0; i < 8; ++i) {
      const ExteriorCell child = octant(cell, i, first + i);
      classify(child, nearest[static_cast<std::size_t>(i)]);
      if (nodes_[static_cast<std::size_t>(child.node)].kind == CellKind::mixed) smaller.push_back(child);
    }
  }
  mixed = std::move(smaller);
  return true;
}

void OffsetExterior::find_unsettled(const ExteriorCell& cell, double smallest, std::vector<ExteriorCell>& found) const {
  const ExteriorNode& node = nodes_[static_cast<std::size_t>(cell.node)];
  for (int i = 0; i < 8 && node.kind == CellKind::divided; ++i) {
    find_unsettled(octant(cell, i, node.first_child + i), smallest, found);
  }
  const bool unsettled = node.space == FreeSpace::none || node.space == FreeSpace::both;
  if (node.kind == CellKind::mixed && unsettled && 2 * cell.half > smallest) found.push_back(cell);
}

void OffsetExterior::look_for_passages(ExteriorFlood& flood) {
  if (resolution_ <= r_ / 2 * (1 + 1e-6)) return;
  std::vector<ExteriorCell> passages = flood.possible_passages(*this);
  if (divide(passages)) flood.run(*this, nodes_);
}

void OffsetExterior::settle_pockets(double smallest, ExteriorFlood& flood) {
  while (true) {
    std::vector<ExteriorCell> unsettled;
    find_unsettled(root(), smallest, unsettled);
    if (!divide(unsettled)) break;
    flood.run(*this, nodes_);
  }
  settle_by_climb();
}

void OffsetExterior::settle_by_climb() {
  std::vector<ExteriorCell> unsettled;
  find_unsettled(root(), 0, unsettled);
  std::erase_if(unsettled, [&](const ExteriorCell& cell) {
    return nodes_[static_cast<std::size_t>(cell.node)].space == FreeSpace::both;
  });
  std::vector<char> leads_out;
  for (const ExteriorCell& cell : unsettled) leads_out.push_back(decide_by_climb(cell.centre) == true ? 1 : 0);
  for (std::size_t i = 0; i < unsettled.size(); ++i) {
    ExteriorNode& node = nodes_[static_cast<std::size_t>(unsettled[i].node)];
    node.space = leads_out[i] != 0 ? FreeSpace::exterior : FreeSpace::enclosed;
    if (node.clearance > 0) node.centre_space = node.space;
  }
}

bool OffsetExterior::mark_exterior(std::int32_t index) {
  ExteriorNode& node = nodes_[static_cast<std::size_t>(index)];
  if (node.kind == CellKind::divided) {
    for (int i = 0; i < 8; ++i) node.may_hold_exterior |= mark_exterior(node.first_child + i);
  } else {
    node.may_hold_exterior = node.kind != CellKind::solid && node.space != FreeSpace::enclosed;
  }
  return node.may_hold_exterior;
}

std::optional<ExteriorCell> OffsetExterior::leaf_at(const Eigen::Vector3d& x) const {
  // The bits of the coordinates, in cubes of the 2^30th part of the root's edge, say which child to take at each level.
  constexpr int bits = 30;
  const Eigen::Array3d place = (x - root_centre_).array() / (2 * root_half_) + 0.5;
  if (!((place >= 0).all() && (place < 1).all())) return std::nullopt;
  const Eigen::Array3i coordinates = (place * (1 << bits)).cast<int>();
  std::int32_t node = 0;
  int level = 0;
  while (nodes_[static_cast<std::size_t>(node)].kind == CellKind::divided) {
    const int shift = bits - ++level;
    const int i =
        ((coordinates[0] >> shift) & 1) | ((coordinates[1] >> shift) & 1) << 1 | ((coordinates[2] >> shift) & 1) << 2;
    node = nodes_[static_cast<std::size_t>(node)].first_child + i;
  }
  const double edge = std::ldexp(2 * root_half_, -level);
  const Eigen::Array3d corner = (coordinates / (1 << (bits - level))).cast<double>() * edge;
  return ExteriorCell{root_centre_ + (corner + (edge / 2 - root_half_)).matrix(), edge / 2, node};
}

std::optional<bool> OffsetExterior::contains(const Eigen::Vector3d& x) const {
  const auto leaf = leaf_at(x);
  if (!leaf) return true;
  const FreeSpace space = nodes_[static_cast<std::size_t>(leaf->node)].space;
  if (space == FreeSpace::exterior) return true;
  if (space == FreeSpace::enclosed) return false;
  if (const auto decided = decide_by_climb(x)) return decided;
  return is_outside_by_crossings(x);
}

std::optional<bool> OffsetExterior::label_seen_from(const Eigen::Vector3d& x, double clearance) const {
  const auto leaf = leaf_at(x);
  if (!leaf) return true;
  const ExteriorNode& node = nodes_[static_cast<std::size_t>(leaf->node)];
  if (node.kind != CellKind::free && (x - leaf->centre).norm() >= clearance) return std::nullopt;
  if (node.centre_space == FreeSpace::exterior) return true;
  if (node.centre_space == FreeSpace::enclosed) return false;
  return std::nullopt;
}

std::optional<bool> OffsetExterior::decide_by_climb(Eigen::Vector3d x) const {
  constexpr int most_steps = 64;
  ClosestHit hit = *tree_.closest(x);
  for (int step = 0; step < most_steps; ++step) {
    const double clearance = hit.distance - r_;
    if (const auto label = label_seen_from(x, clearance)) return label;
    if (!step_up(x, hit, std::max(clearance, resolution_ / 8))) return std::nullopt;
  }
  return std::nullopt;
}

bool OffsetExterior::step_up(Eigen::Vector3d& x, ClosestHit& hit, double length) const {
  constexpr double least_slope = 0.01;  // of the ridge between two walls at 1 degree
  const double shortest = root_half_ / 65536;
  // A direction g climbs from a wall by n.g for the unit normal n: the shortest g with n.g >= 1 for all walls is the
  // steepest.
  std::array<HalfSpace, 4> walls;
  std::size_t count = 0;
  HalfSpace wall{(x - hit.point).normalized(), 1};
  Eigen::Vector3d direction = wall.normal;
  double slope = 1;
  walls[count++] = wall;
  while (length > shortest) {
    const Eigen::Vector3d next = x + length * direction;
    const ClosestHit there = *tree_.closest(next, std::numeric_limits<double>::infinity(), hit.triangle);
    if (there.distance > hit.distance + slope * length / 16) {
      x = next;
      hit = there;
      return true;
    }
    wall.normal = (next - there.point).normalized();
    const bool was_climbed_from = wall.normal.dot(direction) > slope / 2;  // but it is curved, or another part of it is
    if (!was_climbed_from && count < walls.size()) {
      walls[count++] = wall;
      const auto steepest = closest_point_in(std::span(walls).first(count), Eigen::Vector3d::Zero());
      if (steepest && steepest->norm() * least_slope < 1) {
        slope = 1 / steepest->norm();
        direction = slope * *steepest;
        continue;
      }
    }
    // What is met so far away says little of the surroundings of x.
    length /= 2;
    count = 1;
    direction = walls[0].normal;
    slope = 1;
  }
  return false;
}

std::optional<bool> OffsetExterior::is_outside_by_crossings(const Eigen::Vector3d& x) const {
  if (!closed_) return std::nullopt;
  // Any direction will do; the next is tried where one runs too close to an edge.
  static const std::array<Eigen::Vector3d, 4> directions = {
      Eigen::Vector3d(0.8437, 0.4231, 0.3302).normalized(), Eigen::Vector3d(-0.3371, 0.8119, 0.4766).normalized(),
      Eigen::Vector3d(0.2113, -0.4027, 0.8906).normalized(), Eigen::Vector3d(-0.5309, -0.6113, -0.5871).normalized()};
  for (const Eigen::Vector3d& direction : directions) {
    if (const auto crossings = tree_.ray_parity(x, direction))
      return crossings->count % 2 == 0 && crossings->balance == 0;
  }
  return std::nullopt;
}

}  // namespace shapegauge
