#include "tests/oracle/nearest_exterior.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "tests/oracle/offset_tolerance.h"

namespace shapegauge {

namespace {

/// All lengths are fractions of r.
constexpr double search_tolerance = 8e-3;
constexpr double descent_tolerance = 1e-4;
constexpr double smallest_improvement = 3e-4;
/// Beyond this distance the octree is asked for a start: descents from far away end in poor minima.
constexpr double far = 2;
constexpr int most_descent_steps = 16;
constexpr int most_settling_steps = 4;
constexpr int most_pull_steps = 200;
/// Edge of the cubes that branch and bound begins with, and of the smallest ones.
constexpr double first_cube = 1;
constexpr double smallest_cube = 1.0 / 128;
/// The cubes around one point serve for others within this distance.
constexpr double shared_distance = 0.7;
/// A half-space must cut off at least this much, in parts of what it might miss, or the cube is divided instead.
constexpr double smallest_cut = 1;
const double root_of_three = std::sqrt(3.0);

/// Distance from p to the intersection of two half-spaces; negative, to the nearer plane, inside of it.
double distance_to_both(const HalfSpace& first, const HalfSpace& second, const Eigen::Vector3d& p) {
  const double to_first = first.bound - first.normal.dot(p);
  const double to_second = second.bound - second.normal.dot(p);
  const double cosine = first.normal.dot(second.normal);
  const double squared_sine = 1 - cosine * cosine;
  const double first_factor = to_first - cosine * to_second;
  const double second_factor = to_second - cosine * to_first;
  if (first_factor <= 0 || second_factor <= 0 || squared_sine <= 1e-4) return std::max(to_first, to_second);
  return std::sqrt((to_first * first_factor + to_second * second_factor) / squared_sine);
}

bool is_farther(const NearbyCube& a, const NearbyCube& b) { return a.lower_bound > b.lower_bound; }

}  // namespace

NearestExteriorSearch::NearestExteriorSearch(const OffsetExterior& exterior)
    : exterior_(exterior), tree_(exterior.tree()), r_(exterior.r()) {}

ExteriorPoint NearestExteriorSearch::find(const Eigen::Vector3d& p, const Eigen::Vector3d& normal) {
  p_ = p;
  best_distance_ = std::numeric_limits<double>::infinity();
  decided_ = true;
  if (!contacts_.empty()) descend(laid_anew(contacts_, best_));
  if (!std::isfinite(best_distance_) && !normal.isZero()) {
    descend({contact_at(-1, p, p + normal)});
    if (!std::isfinite(best_distance_)) descend({contact_at(-1, p, p - normal)});
  }
  if (best_distance_ > far * r_) descend_from(nearest_known_exterior());
  prove();
  return {best_, decided_};
}

std::span<const HalfSpace> NearestExteriorSearch::with_faces(const Cube& cube,
                                                             std::span<HalfSpace, most_bounds + 6> room) {
  std::copy_n(cube.half_spaces.begin(), cube.bounds, room.begin());
  std::size_t count = cube.bounds;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(k);
    room[count++] = {axis, cube.cell.centre[k] - cube.cell.half};
    room[count++] = {-axis, -cube.cell.centre[k] - cube.cell.half};
  }
  return room.first(count);
}

/// Exterior points that are not nearer than this are of no interest. None is closer to the surface, hence to p, than r.
double NearestExteriorSearch::limit() const {
  const double limit = best_distance_ - search_tolerance * r_;
  return limit > r_ ? limit : 0;
}

NearestExteriorSearch::Contact NearestExteriorSearch::contact_at(std::int32_t triangle,
                                                                 const Eigen::Vector3d& surface_point,
                                                                 const Eigen::Vector3d& x) const {
  const Eigen::Vector3d normal = (x - surface_point).normalized();
  return {triangle, {normal, normal.dot(surface_point) + r_ * (1 + offset_slack)}};
}

ClosestHit NearestExteriorSearch::closest(const Eigen::Vector3d& x, std::int32_t hint) const {
  return *tree_.closest(x, std::numeric_limits<double>::infinity(), hint);
}

void NearestExteriorSearch::keep(const Eigen::Vector3d& candidate, std::vector<Contact> contacts) {
  best_ = candidate;
  best_distance_ = (candidate - p_).norm();
  contacts_ = std::move(contacts);
}

/// Moves an exterior point towards p, through free space, until it touches the offset surface; descends from there.
void NearestExteriorSearch::descend_from(const Eigen::Vector3d& start) {
  const Eigen::Vector3d direction = (p_ - start).normalized();
  Eigen::Vector3d x = start;
  ClosestHit hit = closest(x, -1);
  for (int step = 0; step < most_pull_steps && hit.distance > r_ * (1 + 2 * offset_slack); ++step) {
    x += (hit.distance - r_ * (1 + offset_slack)) * direction;
    hit = closest(x, hit.triangle);
  }
  if ((x - p_).norm() >= best_distance_) return;
  keep(x, {contact_at(hit.triangle, hit.point, x)});
  descend(contacts_);
}

/// The contacts' half-spaces lie inside of what their triangles really leave free: lays those that x lies on anew
/// there.
std::vector<NearestExteriorSearch::Contact> NearestExteriorSearch::laid_anew(const std::vector<Contact>& contacts,
                                                                             const Eigen::Vector3d& x) const {
  std::vector<Contact> result;
  for (const Contact& contact : contacts) {
    const bool reached = contact.free.normal.dot(x) <= contact.free.bound + descent_tolerance * r_;
    if (contact.triangle < 0 || !reached) continue;
    result.push_back(contact_at(contact.triangle, closest_point(tree_.triangle(contact.triangle), x), x));
  }
  return result;
}

/// The point nearest to p that the contacts' triangles leave free, a local minimum: projects p onto their half-spaces
/// and lays these anew where the result touches.
std::optional<Eigen::Vector3d> NearestExteriorSearch::settle(std::vector<Contact>& contacts) const {
  std::array<HalfSpace, most_contacts> free;
  std::optional<Eigen::Vector3d> before;
  for (int step = 0;; ++step) {
    for (std::size_t i = 0; i < contacts.size(); ++i) free[i] = contacts[i].free;
    auto x = closest_point_in(std::span(free).first(contacts.size()), p_);
    if (!x || step == most_settling_steps || (before && (*x - *before).norm() < 1e-3 * r_)) return x;
    for (Contact& contact : contacts) {
      const bool reached = contact.free.normal.dot(*x) <= contact.free.bound + descent_tolerance * r_;
      if (contact.triangle < 0 || !reached) continue;
      contact = contact_at(contact.triangle, closest_point(tree_.triangle(contact.triangle), *x), *x);
    }
    before = x;
  }
}

/// A triangle that covers the contacts' nearest free point becomes a contact too; a free one is an improvement.
void NearestExteriorSearch::descend(std::vector<Contact> contacts) {
  for (int step = 0; step < most_descent_steps && !contacts.empty() && contacts.size() <= most_contacts; ++step) {
    const auto x = settle(contacts);
    if (!x || (*x - p_).norm() >= best_distance_ - smallest_improvement * r_) return;
    const ClosestHit hit = closest(*x, contacts.back().triangle);
    if (!(hit.distance > 0)) return;
    if (hit.distance < r_) {
      std::erase_if(contacts, [&](const Contact& contact) {
        return contact.free.normal.dot(*x) > contact.free.bound + descent_tolerance * r_;
      });
      contacts.push_back(contact_at(hit.triangle, hit.point, *x));
      continue;
    }
    const auto is_exterior = exterior_.contains(*x);
    decided_ &= is_exterior.has_value();
    if (is_exterior != true) return;
    if (hit.distance > r_ * (1 + 5 * offset_slack)) return descend_from(*x);
    contacts = laid_anew(contacts, *x);
    keep(*x, contacts);
  }
}

/// An exterior point from the octree, about the nearest that it knows of.
Eigen::Vector3d NearestExteriorSearch::nearest_known_exterior() const {
  const auto distance = [&](const ExteriorCell& cell) {
    return ((p_ - cell.centre).cwiseAbs().array() - cell.half).cwiseMax(0).matrix().norm();
  };
  const auto farther = [&](const ExteriorCell& a, const ExteriorCell& b) { return distance(a) > distance(b); };
  std::priority_queue<ExteriorCell, std::vector<ExteriorCell>, decltype(farther)> waiting(farther);
  waiting.push(exterior_.root());
  while (true) {  // ends: the octree's border is exterior
    const ExteriorCell cell = waiting.top();
    waiting.pop();
    const ExteriorNode& node = exterior_.nodes()[static_cast<std::size_t>(cell.node)];
    if (node.centre_space == FreeSpace::exterior) return cell.centre;
    for (int i = 0; i < 8 && node.kind == CellKind::divided; ++i) {
      const std::int32_t child = node.first_child + i;
      if (!exterior_.nodes()[static_cast<std::size_t>(child)].may_hold_exterior) continue;
      waiting.push(OffsetExterior::octant(cell, i, child));
    }
  }
}

/// Branch and bound over the cubes around p.
void NearestExteriorSearch::prove() {
  if (!(limit() > 0)) return;
  cover_surroundings();
  waiting_.clear();
  frontier_.find_nearer(p_, limit(), 0, waiting_);
  std::ranges::make_heap(waiting_, is_farther);
  while (!waiting_.empty() && static_cast<double>(waiting_.front().lower_bound) < limit()) {
    std::ranges::pop_heap(waiting_, is_farther);
    const std::int32_t cube = waiting_.back().cube;
    waiting_.pop_back();
    look_into(cube);
  }
}

/// Keeps the cubes of the points before where they cover all that may be nearer to p than its best point.
void NearestExteriorSearch::cover_surroundings() {
  if ((p_ - centre_).norm() + limit() <= covered_) return;
  centre_ = p_;
  covered_ = limit() + 2 * shared_distance * r_;
  cubes_.clear();
  frontier_.restart(centre_);
  gather(exterior_.root(), covered_);
}

void NearestExteriorSearch::gather(const ExteriorCell& cell, double reach) {
  const ExteriorNode& node = exterior_.nodes()[static_cast<std::size_t>(cell.node)];
  const double squared = ((centre_ - cell.centre).cwiseAbs().array() - cell.half).cwiseMax(0).matrix().squaredNorm();
  if (!node.may_hold_exterior || squared > reach * reach) return;
  if (node.kind == CellKind::divided && 2 * cell.half > first_cube * r_) {
    for (int i = 0; i < 8; ++i) gather(OffsetExterior::octant(cell, i, node.first_child + i), reach);
    return;
  }
  Cube cube{.cell = cell, .half_spaces = {}, .triangles = {}};
  if (node.kind != CellKind::divided && node.triangle >= 0) add_bound(cube, node.triangle);
  add(cube);
}

void NearestExteriorSearch::add(const Cube& cube) {
  if (cube.is_covered) return;
  frontier_.add(cube.cell.centre, cube.cell.half);
  if (cube.bounds > 0) {
    frontier_.bound(frontier_.size() - 1, cube.half_spaces[0], cube.half_spaces[cube.bounds - 1]);
  }
  cubes_.push_back(cube);
}

/// Tells the frontier the two half-spaces of a cube whose intersection p is farthest from, among those whose planes x,
/// the point of all of them nearest to p, lies on.
void NearestExteriorSearch::show_bounds(std::int32_t index, const Eigen::Vector3d& x) {
  const Cube& cube = cubes_[static_cast<std::size_t>(index)];
  std::array<HalfSpace, most_bounds + 6> near;
  std::array<const HalfSpace*, 3> active{};
  std::size_t count = 0;
  for (const HalfSpace& half_space : with_faces(cube, near)) {
    if (half_space.normal.dot(x) > half_space.bound + 1e-6 * r_) continue;
    active[count++] = &half_space;
    if (count == active.size()) break;
  }
  std::array<std::size_t, 2> best = {0, 0};
  double best_distance = -1;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const double distance = distance_to_both(*active[i], *active[j], p_);
      if (!(distance > best_distance)) continue;
      best_distance = distance;
      best = {i, j};
    }
  }
  if (best_distance > 0) frontier_.bound(index, *active[best[0]], *active[best[1]]);
}

/// Settles whether the cube holds an exterior point nearer than the limit: keeps the point, or learns more of the cube
/// until it is farther.
void NearestExteriorSearch::look_into(std::int32_t index) {
  while (true) {
    Cube& cube = cubes_[static_cast<std::size_t>(index)];
    const auto x = nearest_in(cube);
    if (!x) return frontier_.remove(index);
    if ((*x - p_).norm() >= limit()) return show_bounds(index, *x);
    const ExteriorNode& node = exterior_.nodes()[static_cast<std::size_t>(cube.cell.node)];
    if (node.kind == CellKind::divided) return divide(index);
    if (is_inside(cube)) return frontier_.remove(index);
    const std::int32_t hint = cube.bounds > 0 ? cube.triangles[cube.bounds - 1] : -1;
    const ClosestHit hit = closest(*x, hint);
    const bool divisible = 2 * cube.cell.half > smallest_cube * r_;
    if (hit.distance >= r_) {
      const auto is_exterior = exterior_.contains(*x);
      decided_ &= is_exterior.has_value();
      if (is_exterior == true) return descend_from(*x);
      return divisible ? divide(index) : frontier_.remove(index);
    }
    if (cuts_off(cube, hit.triangle, *x)) continue;
    if (hit.distance > r_ * (1 - search_tolerance / 2) && push_out(*x, hit)) return;
    return divisible ? divide(index) : frontier_.remove(index);
  }
}

/// Whether all free points of a cube are on the inner side of a closed surface: its centre is within r of them, so no
/// surface passes between. Asked once, and only where the octree does not say.
bool NearestExteriorSearch::is_inside(Cube& cube) const {
  const ExteriorNode& node = exterior_.nodes()[static_cast<std::size_t>(cube.cell.node)];
  if (cube.is_outside || node.space != FreeSpace::both || root_of_three * cube.cell.half >= r_) return false;
  cube.is_outside = true;
  return exterior_.is_outside_by_crossings(cube.cell.centre) == false;
}

/// Adds the triangle's half-space where it cuts off the point by enough to be worth it.
bool NearestExteriorSearch::cuts_off(Cube& cube, std::int32_t triangle, const Eigen::Vector3d& x) const {
  const std::size_t bounds = cube.bounds;
  if (bounds == most_bounds || !add_bound(cube, triangle)) return false;
  if (cube.is_covered) return true;
  const HalfSpace& added = cube.half_spaces[bounds];
  const double sagitta = 3 * cube.cell.half * cube.cell.half / (2 * r_);
  if (added.bound - added.normal.dot(x) > smallest_cut * sagitta) return true;
  cube.bounds = bounds;
  return false;
}

/// Whether a point that is barely covered has an exterior one beside it: the nearest that its triangle leaves free.
bool NearestExteriorSearch::push_out(const Eigen::Vector3d& x, const ClosestHit& hit) {
  const Eigen::Vector3d free = hit.point + r_ * (1 + offset_slack) / hit.distance * (x - hit.point);
  if (closest(free, hit.triangle).distance < r_ || exterior_.contains(free) != true) return false;
  descend_from(free);
  return true;
}

/// The point nearest to p in a cube and its half-spaces, or in these alone where that is far enough; nothing where they
/// have no point in common.
std::optional<Eigen::Vector3d> NearestExteriorSearch::nearest_in(const Cube& cube) const {
  if (cube.is_covered) return std::nullopt;
  auto x = closest_point_in(std::span(cube.half_spaces).first(cube.bounds), p_);
  if (!x || (*x - p_).norm() >= limit()) return x;
  std::array<HalfSpace, most_bounds + 6> half_spaces;
  return closest_point_in(with_faces(cube, half_spaces), p_);
}

/// Notes that the cube's exterior points are at least r away from a point of the triangle, in the direction of the
/// cube's centre, or that there are none. False where that says nothing.
bool NearestExteriorSearch::add_bound(Cube& cube, std::int32_t triangle) const {
  const Eigen::Vector3d point = closest_point(tree_.triangle(triangle), cube.cell.centre);
  const Eigen::Vector3d to_centre = cube.cell.centre - point;
  const double distance = to_centre.norm();
  const double radius = root_of_three * cube.cell.half;
  cube.is_covered |= (to_centre.cwiseAbs().array() + cube.cell.half).matrix().norm() < r_;
  if (cube.is_covered) return true;
  if (distance <= radius || radius >= r_) return false;
  const Eigen::Vector3d normal = to_centre / distance;
  const double height = std::sqrt(r_ * r_ - radius * radius);
  cube.triangles[cube.bounds] = triangle;
  cube.half_spaces[cube.bounds++] = {normal, normal.dot(point) + height};
  return true;
}

void NearestExteriorSearch::divide(std::int32_t index) {
  const Cube cube = cubes_[static_cast<std::size_t>(index)];
  frontier_.remove(index);
  const std::int32_t first = frontier_.size();
  const ExteriorNode& node = exterior_.nodes()[static_cast<std::size_t>(cube.cell.node)];
  for (int i = 0; i < 8; ++i) {
    const bool in_octree = node.kind == CellKind::divided;
    const std::int32_t child_index = in_octree ? node.first_child + i : cube.cell.node;
    Cube child{.cell = OffsetExterior::octant(cube.cell, i, child_index),
               .is_outside = cube.is_outside,
               .half_spaces = {},
               .triangles = {}};
    const ExteriorNode& child_node = exterior_.nodes()[static_cast<std::size_t>(child.cell.node)];
    if (!child_node.may_hold_exterior) continue;
    if (in_octree && child_node.kind != CellKind::divided && child_node.triangle >= 0) {
      add_bound(child, child_node.triangle);
    }
    for (std::size_t k = 0; k < cube.bounds; ++k) add_bound(child, cube.triangles[k]);
    add(child);
  }
  const std::size_t before = waiting_.size();
  frontier_.find_nearer(p_, limit(), first, waiting_);
  for (std::size_t k = before; k < waiting_.size(); ++k) {
    std::ranges::push_heap(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(k) + 1, is_farther);
  }
}

}  // namespace shapegauge
