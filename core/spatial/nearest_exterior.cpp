#include "shapegauge/core/spatial/nearest_exterior.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shapegauge/core/spatial/offset_tolerance.h"

namespace shapegauge {

namespace {

/// All lengths are fractions of r.
constexpr double search_tolerance = 5e-3;
constexpr double smallest_half = 3e-3;
constexpr double descent_tolerance = 1e-4;
constexpr int most_descent_steps = 16;
constexpr std::size_t most_contacts = 7;

double distance_to_cube(const Eigen::Vector3d& p, const ExteriorCell& cell) {
  return ((p - cell.centre).cwiseAbs().array() - cell.half).cwiseMax(0).matrix().norm();
}

Eigen::Vector3d closest_in_cube(const Eigen::Vector3d& p, const ExteriorCell& cell) {
  return p.cwiseMax((cell.centre.array() - cell.half).matrix()).cwiseMin((cell.centre.array() + cell.half).matrix());
}

/// Moves a point outside of the offset solid towards p, through free space, until it touches the offset surface.
Eigen::Vector3d pulled_to_surface(const OffsetExterior& exterior, Eigen::Vector3d x, const Eigen::Vector3d& p) {
  constexpr int most_steps = 200;
  const double r = exterior.r();
  const double length = (p - x).norm();
  const Eigen::Vector3d direction = (p - x) / length;
  std::int32_t hint = -1;
  for (int step = 0; step < most_steps; ++step) {
    const auto hit = exterior.tree().closest(x, std::numeric_limits<double>::infinity(), hint);
    const double clearance = hit->distance - r;
    if (clearance <= 2 * offset_slack * r) break;
    x += (clearance - offset_slack * r) * direction;
    hint = hit->triangle;
  }
  return x;
}

}  // namespace

bool NearestExterior::may_improve(double bound) const {
  return bound < best_distance_ - search_tolerance * exterior_.r();
}

void NearestExterior::wait_for(const ExteriorCell& cell, bool fine) {
  const double bound = distance_to_cube(p_, cell);
  if (may_improve(bound)) waiting_.push({bound, cell, fine});
}

NearestExterior::Contact NearestExterior::contact_at(std::int32_t triangle, const Eigen::Vector3d& surface_point,
                                                     const Eigen::Vector3d& x) const {
  const Eigen::Vector3d normal = (x - surface_point).normalized();
  return {triangle, {normal, normal.dot(surface_point) + exterior_.r() * (1 + offset_slack)}};
}

ExteriorPoint NearestExterior::find(const Eigen::Vector3d& p, const Eigen::Vector3d& normal) {
  p_ = p;
  best_distance_ = std::numeric_limits<double>::infinity();
  waiting_ = {};
  if (!normal.isZero()) {
    descend({contact_at(-1, p, p + normal)});
    descend({contact_at(-1, p, p - normal)});
  }
  wait_for(exterior_.root(), false);
  while (!waiting_.empty() && may_improve(waiting_.top().bound)) {
    const Waiting next = waiting_.top();
    waiting_.pop();
    if (next.fine) {
      look_into_fine(next.cell);
    } else {
      look_into(next.cell);
    }
  }
  return best_;
}

void NearestExterior::look_into(const ExteriorCell& cell) {
  const ExteriorNode& node = exterior_.nodes()[static_cast<std::size_t>(cell.node)];
  if (!node.may_hold_exterior) return;
  switch (node.kind) {
    case CellKind::divided:
      for (int i = 0; i < 8; ++i) wait_for(OffsetExterior::octant(cell, i, node.first_child + i), false);
      break;
    case CellKind::free:
      try_point(closest_in_cube(p_, cell), true);
      break;
    case CellKind::mixed:
      look_into_fine({cell.centre, cell.half, fine_root(cell.node)});
      break;
    case CellKind::solid:
      break;
  }
}

void NearestExterior::look_into_fine(const ExteriorCell& cell) {
  const FineCell known = evaluated(cell);
  if (known.kind == FineCell::Kind::dropped) return;
  if (known.kind == FineCell::Kind::exterior) {
    try_point(closest_in_cube(p_, cell), known.decided);
    return;
  }
  if (known.centre_is_exterior && (cell.centre - p_).norm() < best_distance_) try_point(cell.centre, known.decided);
  if (cell.half <= smallest_half * exterior_.r()) return;
  std::int32_t first_child = known.first_child;
  if (first_child < 0) {
    first_child = static_cast<std::int32_t>(fine_cells_.size());
    fine_cells_[static_cast<std::size_t>(cell.node)].first_child = first_child;
    fine_cells_.resize(fine_cells_.size() + 8, FineCell{.triangle = known.triangle});
  }
  for (int i = 0; i < 8; ++i) wait_for(OffsetExterior::octant(cell, i, first_child + i), true);
}

std::int32_t NearestExterior::fine_root(std::int32_t leaf) {
  const auto [entry, is_new] = fine_roots_.try_emplace(leaf, static_cast<std::int32_t>(fine_cells_.size()));
  if (is_new) {
    fine_cells_.push_back(FineCell{.triangle = exterior_.nodes()[static_cast<std::size_t>(leaf)].triangle});
  }
  return entry->second;
}

NearestExterior::FineCell NearestExterior::evaluated(const ExteriorCell& cell) {
  FineCell& known = fine_cells_[static_cast<std::size_t>(cell.node)];
  if (known.kind != FineCell::Kind::unknown) return known;
  const double r = exterior_.r();
  const double radius = std::sqrt(3.0) * cell.half;
  const SurfaceTree& tree = exterior_.tree();
  const std::int32_t hint = known.triangle;
  if (hint >= 0 && (closest_point(tree.triangle(hint), cell.centre) - cell.centre).norm() + radius < r) {
    known.kind = FineCell::Kind::dropped;
    return known;
  }
  const auto hit = tree.closest(cell.centre, r + radius, hint);
  if (hit) known.triangle = hit->triangle;
  if (hit && hit->distance < r) {
    known.kind = hit->distance + radius < r ? FineCell::Kind::dropped : FineCell::Kind::mixed;
    return known;
  }
  const auto is_exterior = exterior_.contains(cell.centre);
  known.decided = is_exterior.has_value();
  known.centre_is_exterior = is_exterior.value_or(true);
  known.kind = FineCell::Kind::mixed;
  if (!hit) known.kind = known.centre_is_exterior ? FineCell::Kind::exterior : FineCell::Kind::dropped;
  return known;
}

void NearestExterior::try_point(const Eigen::Vector3d& x, bool decided) {
  const Eigen::Vector3d touching = pulled_to_surface(exterior_, x, p_);
  const double distance = (touching - p_).norm();
  if (distance >= best_distance_) return;
  best_distance_ = distance;
  best_ = {touching, decided};
  const auto hit = exterior_.tree().closest(touching);
  descend({contact_at(hit->triangle, hit->point, touching)});
}

void NearestExterior::descend(std::vector<Contact> contacts) {
  const double r = exterior_.r();
  const SurfaceTree& tree = exterior_.tree();
  std::vector<HalfSpace> free;
  Eigen::Vector3d previous = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  for (int step = 0; step < most_descent_steps && contacts.size() <= most_contacts; ++step) {
    free.clear();
    for (const Contact& contact : contacts) free.push_back(contact.free);
    const auto x = closest_point_in(free, p_);
    if (!x || (*x - p_).norm() >= best_distance_) return;
    if (const auto hit = tree.closest(*x, r, contacts.back().triangle)) {
      if (!(hit->distance > 0)) return;
      contacts.push_back(contact_at(hit->triangle, hit->point, *x));
      continue;
    }
    const auto is_exterior = exterior_.contains(*x);
    if (is_exterior == false) return;
    const Eigen::Vector3d touching = pulled_to_surface(exterior_, *x, p_);
    best_ = {touching, is_exterior.has_value()};
    best_distance_ = (touching - p_).norm();
    if ((touching - previous).norm() < descent_tolerance * r) return;
    previous = touching;
    // The half-spaces lie inside of what the triangles really leave free: lay those that were reached anew.
    std::vector<Contact> reached;
    for (const Contact& contact : contacts) {
      if (contact.triangle < 0 || contact.free.normal.dot(*x) > contact.free.bound + descent_tolerance * r) continue;
      reached.push_back(contact_at(contact.triangle, closest_point(tree.triangle(contact.triangle), touching), touching));
    }
    const auto hit = tree.closest(touching);
    reached.push_back(contact_at(hit->triangle, hit->point, touching));
    contacts = std::move(reached);
  }
}

}  // namespace shapegauge
