#include "shapegauge/core/spatial/nearest_exterior.h"

#include <cmath>
#include <limits>
#include <queue>
#include <vector>

#include "shapegauge/core/spatial/half_spaces.h"
#include "shapegauge/core/spatial/offset_tolerance.h"

namespace shapegauge {

namespace {

/// All lengths are fractions of r.
constexpr double search_tolerance = 8e-3;
constexpr double smallest_patch = 3e-3;
constexpr double descent_tolerance = 1e-4;
constexpr double smallest_improvement = 1e-3;
/// Beyond this distance the octree is asked for a start: descents from far away end in poor minima.
constexpr double far = 2;
constexpr int most_descent_steps = 16;
constexpr std::size_t most_contacts = 7;
constexpr int most_pull_steps = 200;
constexpr int most_improvements = 64;

/// A triangle that keeps the point at its distance, and the half-space that it leaves free.
struct Contact {
  std::int32_t triangle;
  HalfSpace free;
};

/// The search for one point p.
class Search {
 public:
  Search(const OffsetExterior& exterior, const Eigen::Vector3d& p, SearchMemory& memory)
      : exterior_(exterior), tree_(exterior.tree()), r_(exterior.r()), p_(p), memory_(memory) {}

  ExteriorPoint run(const Eigen::Vector3d& normal) {
    if (!normal.isZero()) {
      descend({contact_at(-1, p_, p_ + normal)});
      if (!std::isfinite(best_distance_)) descend({contact_at(-1, p_, p_ - normal)});
    }
    if (best_distance_ > far * r_) descend_from(nearest_known_exterior());
    for (int i = 0; i < most_improvements; ++i) {
      // No exterior point is closer to the surface, hence to p, than r.
      const double radius = best_distance_ - search_tolerance * r_;
      if (radius <= r_) break;
      const auto closer = exterior_point_on_sphere(exterior_, p_, radius, smallest_patch * r_, memory_);
      decided_ &= closer.decided;
      if (!closer.exterior_point) break;
      descend_from(*closer.exterior_point);
    }
    return {best_, decided_};
  }

 private:
  [[nodiscard]] Contact contact_at(std::int32_t triangle, const Eigen::Vector3d& surface_point,
                                   const Eigen::Vector3d& x) const {
    const Eigen::Vector3d normal = (x - surface_point).normalized();
    return {triangle, {normal, normal.dot(surface_point) + r_ * (1 + offset_slack)}};
  }

  [[nodiscard]] SurfaceHit closest(const Eigen::Vector3d& x, std::int32_t hint) const {
    return *tree_.closest(x, std::numeric_limits<double>::infinity(), hint);
  }

  /// A point that touches the offset surface, and the triangle that it touches.
  struct Touching {
    Eigen::Vector3d point;
    SurfaceHit hit;
  };

  /// Moves an exterior point towards p, through free space, until it touches the offset surface.
  [[nodiscard]] Touching pulled_to_surface(Eigen::Vector3d x, SurfaceHit hit) const {
    const Eigen::Vector3d direction = (p_ - x).normalized();
    for (int step = 0; step < most_pull_steps && hit.distance > r_ * (1 + 2 * offset_slack); ++step) {
      x += (hit.distance - r_ * (1 + offset_slack)) * direction;
      hit = closest(x, hit.triangle);
    }
    return {x, hit};
  }

  void keep(const Eigen::Vector3d& candidate) {
    best_ = candidate;
    best_distance_ = (candidate - p_).norm();
  }

  void descend_from(const Eigen::Vector3d& start) {
    const Touching touching = pulled_to_surface(start, closest(start, -1));
    if ((touching.point - p_).norm() >= best_distance_) return;
    keep(touching.point);
    descend({contact_at(touching.hit.triangle, touching.hit.point, touching.point)});
  }

  /// Projects p onto the half-spaces that the contacts leave free; a triangle that blocks the result becomes a contact
  /// too; a free result is an improvement, and the contacts that hold it are laid anew there.
  void descend(std::vector<Contact> contacts) {
    std::vector<HalfSpace> free;
    for (int step = 0; step < most_descent_steps && contacts.size() <= most_contacts; ++step) {
      free.clear();
      for (const Contact& contact : contacts) free.push_back(contact.free);
      const auto x = closest_point_in(free, p_);
      if (!x || (*x - p_).norm() >= best_distance_ - smallest_improvement * r_) return;
      const SurfaceHit hit = closest(*x, contacts.back().triangle);
      if (!(hit.distance > 0)) return;
      if (hit.distance < r_) {
        contacts.push_back(contact_at(hit.triangle, hit.point, *x));
        continue;
      }
      const auto is_exterior = exterior_.contains(*x);
      decided_ &= is_exterior.has_value();
      if (is_exterior != true) return;
      const Touching touching = pulled_to_surface(*x, hit);
      keep(touching.point);
      contacts = renewed(contacts, *x, touching);
    }
  }

  /// The half-spaces lie inside of what the triangles really leave free: lays those that x lies on anew at the point
  /// that it was pulled to.
  [[nodiscard]] std::vector<Contact> renewed(const std::vector<Contact>& contacts, const Eigen::Vector3d& x,
                                             const Touching& touching) const {
    std::vector<Contact> result;
    for (const Contact& contact : contacts) {
      const bool reached = contact.free.normal.dot(x) <= contact.free.bound + descent_tolerance * r_;
      if (contact.triangle < 0 || contact.triangle == touching.hit.triangle || !reached) continue;
      const Eigen::Vector3d surface_point = closest_point(tree_.triangle(contact.triangle), touching.point);
      result.push_back(contact_at(contact.triangle, surface_point, touching.point));
    }
    result.push_back(contact_at(touching.hit.triangle, touching.hit.point, touching.point));
    return result;
  }

  /// An exterior point from the octree, about the nearest that it knows of.
  [[nodiscard]] Eigen::Vector3d nearest_known_exterior() const {
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

  const OffsetExterior& exterior_;
  const SurfaceTree& tree_;
  double r_;
  Eigen::Vector3d p_;
  SearchMemory& memory_;
  Eigen::Vector3d best_ = Eigen::Vector3d::Zero();
  bool decided_ = true;
  double best_distance_ = std::numeric_limits<double>::infinity();
};

}  // namespace

ExteriorPoint nearest_exterior_point(const OffsetExterior& exterior, const Eigen::Vector3d& p,
                                     const Eigen::Vector3d& normal, SearchMemory& memory) {
  return Search(exterior, p, memory).run(normal);
}

}  // namespace shapegauge
