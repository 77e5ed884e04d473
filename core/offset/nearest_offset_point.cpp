#include "shapegauge/core/offset/nearest_offset_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "shapegauge/core/offset/block_distances.h"

namespace shapegauge {

namespace {

/// Triangle with the half-space outside the tangent plane of a ball of radius r about one of its points: normal . x >=
/// height.
struct Contact {
  std::int32_t triangle;
  Eigen::Vector3d normal;
  double height;
  Eigen::Vector3d point;  ///< centre of the ball, on the triangle
};

struct Contacts {
  static constexpr std::size_t capacity = 5;
  std::array<Contact, capacity> list;
  std::size_t count = 0;

  void add(const Contact& make_contact) {
    if (count < capacity) list[count++] = make_contact;
  }
};

/// Projection of a point onto half-spaces, with the active contacts and their multipliers.
struct Projected {
  Eigen::Vector3d x;
  std::size_t count = 0;
  std::array<std::size_t, 3> contacts{};
  std::array<double, 3> multipliers{};
};

/// Projects p onto the intersection of half-spaces. By the Karush-Kuhn-Tucker conditions the projection is p + the sum
/// of multiplier_i normal_i, with multipliers >= 0 for one, two or three active half-spaces, whose planes contain it,
/// and 0 for the others.
class Projection {
 public:
  Projection(const Eigen::Vector3d& p, const Contacts& contacts) : p_(p), contacts_(contacts) {
    for (std::size_t i = 0; i < contacts.count; ++i) {
      violations_[i] = contacts.list[i].height - contacts.list[i].normal.dot(p);
      for (std::size_t j = 0; j <= i; ++j) {
        gram_[i][j] = gram_[j][i] = contacts.list[i].normal.dot(contacts.list[j].normal);
      }
    }
  }

  /// Returns nothing if the intersection is empty.
  [[nodiscard]] std::optional<Projected> find() const {
    const std::size_t n = contacts_.count;
    const auto worst =
        static_cast<std::size_t>(std::max_element(violations_.begin(), violations_.begin() + n) - violations_.begin());
    if (violations_[worst] <= tolerance) return Projected{.x = p_};
    // A single active plane can only be the one farthest from p.
    if (const auto x = if_feasible<1>({worst}, {violations_[worst]})) return x;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (const auto x = on_two_planes(i, j)) return x;
      }
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) {
          if (const auto x = on_three_planes(i, j, k)) return x;
        }
      }
    }
    return std::nullopt;
  }

 private:
  static constexpr double tolerance = 1e-6;
  static constexpr double least_determinant = 1e-6;

  /// Returns the point of the multipliers if it is feasible: none is negative, and it lies in all half-spaces.
  template <std::size_t count>
  std::optional<Projected> if_feasible(const std::array<std::size_t, count>& which,
                                       const std::array<double, count>& multiplier) const {
    if (*std::min_element(multiplier.begin(), multiplier.end()) < 0) return std::nullopt;
    for (std::size_t i = 0; i < contacts_.count; ++i) {
      double violation = violations_[i];
      for (std::size_t k = 0; k < count; ++k) violation -= multiplier[k] * gram_[i][which[k]];
      if (violation > tolerance) return std::nullopt;
    }
    Projected projected{.x = p_, .count = count};
    for (std::size_t k = 0; k < count; ++k) {
      projected.x += multiplier[k] * contacts_.list[which[k]].normal;
      projected.contacts[k] = which[k];
      projected.multipliers[k] = multiplier[k];
    }
    return projected;
  }

  [[nodiscard]] std::optional<Projected> on_two_planes(std::size_t i, std::size_t j) const {
    const double determinant = 1 - gram_[i][j] * gram_[i][j];
    if (determinant < least_determinant) return std::nullopt;
    return if_feasible<2>({i, j}, {(violations_[i] - gram_[i][j] * violations_[j]) / determinant,
                                   (violations_[j] - gram_[i][j] * violations_[i]) / determinant});
  }

  /// Solves by Cramer's rule.
  [[nodiscard]] std::optional<Projected> on_three_planes(std::size_t i, std::size_t j, std::size_t k) const {
    const double a = gram_[i][j];
    const double b = gram_[i][k];
    const double c = gram_[j][k];
    const double determinant = 1 + 2 * a * b * c - a * a - b * b - c * c;
    if (determinant < least_determinant) return std::nullopt;
    const double mi = violations_[i];
    const double mj = violations_[j];
    const double mk = violations_[k];
    return if_feasible<3>({i, j, k}, {((1 - c * c) * mi + (b * c - a) * mj + (a * c - b) * mk) / determinant,
                                      ((b * c - a) * mi + (1 - b * b) * mj + (a * b - c) * mk) / determinant,
                                      ((a * c - b) * mi + (a * b - c) * mj + (1 - a * a) * mk) / determinant});
  }

  const Eigen::Vector3d& p_;
  const Contacts& contacts_;
  std::array<double, Contacts::capacity> violations_{};
  std::array<std::array<double, Contacts::capacity>, Contacts::capacity> gram_;
};

/// Returns the contact of the ball about x - v.
Contact make_contact(std::int32_t triangle, const Eigen::Vector3d& x, const Eigen::Vector3d& v, double r) {
  const double distance = v.norm();
  const Eigen::Vector3d normal = v / distance;
  return {triangle, normal, normal.dot(x) - distance + r, x - v};
}

/// Returns true if the known triangles around x are at least this far away.
bool is_free(const ExteriorGrid& exterior, const CellsAround& around, const Eigen::Vector3d& x, double least) {
  TriangleTable::Vectors vectors;
  if (!vectors_around(exterior, around, x, vectors)) return around.touches_exterior;
  return *std::min_element(vectors.squared.begin(), vectors.squared.end()) >= static_cast<float>(least * least);
}

/// Returns true if the segment from x to a nearby exterior point is free. A convex obstacle that touches both ends may
/// bulge into it: E(r) extends into narrow valleys between balls that contain no cell centre, and balls are convex.
bool is_connected_to(const ExteriorGrid& exterior, const Eigen::Vector3d& x, const Eigen::Vector3d& to) {
  constexpr double max_length = 5;
  constexpr double spacing = 0.7;
  const double length = (to - x).norm();
  if (length > max_length) return false;
  const int steps = static_cast<int>(std::ceil(length / spacing));
  const double r = exterior.grid().r;
  for (int i = 1; i < steps; ++i) {
    const Eigen::Vector3d between = x + static_cast<double>(i) / steps * (to - x);
    const CellsAround around = cells_around(exterior, between);
    if (!is_free(exterior, around, between, r - length * length / (4 * r))) return false;
    if (around.touches_exterior) return true;
  }
  return true;
}

/// Triangles, with the vectors from their closest points to a query point.
struct Surroundings {
  std::array<std::int32_t, 2 * TriangleTable::batch_size> triangles;
  std::size_t count = 0;
  std::array<TriangleTable::Vectors, 2> vectors;

  /// Adds a triangle unless it is known. Branchless, because the outcome is hard to predict.
  void add(std::int32_t triangle) {
    bool is_known = false;
    for (std::size_t i = 0; i < count; ++i) is_known |= triangles[i] == triangle;
    triangles[count] = triangle;
    count += is_known ? 0 : 1;
  }
  void update(const Eigen::Vector3d& x, const TriangleTable& table) {
    constexpr std::size_t eight = TriangleTable::batch_size;
    std::fill(triangles.begin() + count, triangles.begin() + (count > eight ? 2 * eight : eight), triangles[0]);
    table.vectors_to(x, triangles.data(), vectors[0]);
    if (count > eight) table.vectors_to(x, triangles.data() + eight, vectors[1]);
  }
  [[nodiscard]] Eigen::Vector3d vector(std::size_t i) const {
    return vectors[i / TriangleTable::batch_size].vector(i % TriangleTable::batch_size);
  }
  [[nodiscard]] float squared(std::size_t i) const {
    return vectors[i / TriangleTable::batch_size].squared[i % TriangleTable::batch_size];
  }
};

/// Returns the contacts for the next step: the previous ones that are kept, recomputed at x, and up to two new ones
/// that cover x: the closest, and the closest in another direction. The previous ones come first in `around`.
Contacts contacts_for(const Surroundings& around, const Contacts& before,
                      const std::array<bool, Contacts::capacity>& kept, const Eigen::Vector3d& x, double r,
                      double covering) {
  constexpr double same_direction = 0.985;
  Contacts contacts;
  for (std::size_t i = 0; i < before.count; ++i) {
    if (kept[i]) contacts.add(make_contact(around.triangles[i], x, around.vector(i), r));
  }
  const std::size_t old = contacts.count;
  while (contacts.count < Contacts::capacity && contacts.count < old + 2) {
    std::size_t closest = around.count;
    auto least = static_cast<float>(covering * covering);
    for (std::size_t i = before.count; i < around.count; ++i) {
      if (around.squared(i) >= least) continue;
      if (contacts.count > old && around.vector(i).dot(contacts.list[old].normal) >
                                      same_direction * std::sqrt(static_cast<double>(around.squared(i)))) {
        continue;
      }
      least = around.squared(i);
      closest = i;
    }
    if (closest == around.count) break;
    contacts.add(make_contact(around.triangles[closest], x, around.vector(closest), r));
  }
  return contacts;
}

/// Returns the curvature correction of a step. Balls about edges and corners curve away from their half-spaces:
/// tangentially to the active contacts, where the curvature is 1 / r, the step is too short by the factor 1 -
/// multiplier / r (docs/methods/offset_sdf.md#the-steps-to-q).
Eigen::Vector3d curvature_correction(const TriangleTable& table, const Eigen::Vector3d& step, const Projected& to,
                                     const Contacts& contacts, double r) {
  constexpr double max_bend = 0.85;
  const auto growth = [&](double bend) { return 1 / (1 - std::min(bend, max_bend)) - 1; };
  const auto contact = [&](std::size_t k) { return contacts.list[to.contacts[k]]; };
  const auto place = [&](std::size_t k) { return table.feature_at(contact(k).point, contact(k).triangle); };
  using Part = TriangleTable::Part;
  if (to.count == 1) {
    const auto [part, edge] = place(0);
    if (part == Part::face) return Eigen::Vector3d::Zero();
    const Eigen::Vector3d tangential = step - contact(0).normal.dot(step) * contact(0).normal;
    return growth(to.multipliers[0] / r) * (tangential - edge.dot(tangential) * edge);
  }
  if (to.count == 2) {
    const Eigen::Vector3d along = contact(0).normal.cross(contact(1).normal).normalized();
    double bend = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto [part, edge] = place(k);
      if (part != Part::face) bend += to.multipliers[k] / r * (1 - std::pow(edge.dot(along), 2));
    }
    return growth(bend) * along.dot(step) * along;
  }
  return Eigen::Vector3d::Zero();
}

/// Returns the step to the projection with its curvature correction, shortened if the whole exceeds max_length.
Eigen::Vector3d step_to(const Projected& to, const Eigen::Vector3d& x, const TriangleTable& table,
                        const Contacts& contacts, double r, double max_length) {
  const Eigen::Vector3d step = to.x - x;
  const double available = max_length - step.norm();
  if (available <= 0) return step;
  const Eigen::Vector3d more = curvature_correction(table, step, to, contacts, r);
  const double length = more.norm();
  return length > available ? (step + available / length * more).eval() : (step + more).eval();
}

/// Iteration from a site to the nearest point of the offset surface (docs/methods/offset_sdf.md#the-steps-to-q).
class OffsetPointSearch {
 public:
  OffsetPointSearch(const ExteriorGrid& exterior, const Eigen::Vector3d& p, const Eigen::Vector3d& site,
                    std::int32_t triangle)
      : exterior_(exterior), table_(exterior.surface().triangles), r_(exterior.grid().r), p_(p), site_(site), x_(site) {
    around_.add(triangle);
    around_.update(site, table_);
    contacts_.add(make_contact(triangle, site, around_.vector(0), r_));
  }

  /// Runs the iteration; see nearest_offset_point().
  std::optional<Eigen::Vector3d> find(const std::optional<Eigen::Vector3d>& known) {
    constexpr int max_steps = 12;
    constexpr double settled = 0.01;  // of a step's length, in units of r
    constexpr double near_known = 0.3;
    constexpr double tolerance = 2e-4;  // of the distance
    const double covering = r_ * (1 - tolerance);
    std::optional<Eigen::Vector3d> found;
    for (int step = 0; step < max_steps; ++step) {
      if (!advance()) return found;
      const CellsAround cells = cells_around(exterior_, x_);
      update_surroundings(cells);
      const float squared = nearest_squared();
      if (!(squared > 0)) return found;
      const bool covered = static_cast<double>(squared) < covering * covering;
      if (!covered && !is_truncated_) {
        // x is free but enclosed, and no further step can leave the enclosure.
        if (!cells.touches_exterior && !is_connected_to(exterior_, x_, site_)) return found;
        found = x_;
        if (step_length_ < settled * r_) return found;
        if (known && (x_ - *known).norm() < near_known * r_) return std::nullopt;
      }
      contacts_ = contacts_for(around_, contacts_, kept_, x_, r_, covering);
      if (contacts_.count == 0) return found;
    }
    return found;
  }

 private:
  /// Moves x towards the projection of p onto the contacts' half-spaces. Returns false if their intersection is empty.
  bool advance() {
    constexpr double max_step = 0.4;  // in units of r: walls are thicker
    const auto projected = Projection(p_, contacts_).find();
    if (!projected) return false;
    const Eigen::Vector3d step = step_to(*projected, x_, table_, contacts_, r_, trust_radius_ * r_);
    const double length = step.norm();
    is_truncated_ = length > max_step * r_;
    x_ += (is_truncated_ ? max_step * r_ / length : 1.0) * step;
    kept_ = {};
    for (std::size_t i = 0; i < contacts_.count; ++i) {
      kept_[i] = is_truncated_ || contacts_.list[i].normal.dot(x_) <= contacts_.list[i].height + 1e-6;
    }
    if (step.dot(last_step_) < 0 && length > 0.5 * step_length_) trust_radius_ /= 2;  // oscillation
    last_step_ = step;
    step_length_ = length;
    return true;
  }

  /// Collects the triangles of the contacts, those around x and, close to convergence, those nearest to the contacts.
  void update_surroundings(const CellsAround& cells) {
    constexpr double nearly_settled = 0.05;
    around_.count = 0;
    for (std::size_t i = 0; i < contacts_.count; ++i) around_.triangles[around_.count++] = contacts_.list[i].triangle;
    for (std::size_t i = 0; i < static_cast<std::size_t>(cells.count); ++i) around_.add(cells.triangles[i]);
    // On fine meshes the closest triangle is seldom one of the cells' but close to a contact.
    for (std::size_t i = 0; i < contacts_.count && step_length_ < nearly_settled * r_; ++i) {
      if (!kept_[i]) continue;
      const Eigen::Vector3d place = x_ - r_ * contacts_.list[i].normal;
      const std::int32_t nearest =
          closest_triangle_near(exterior_.grid(), exterior_.surface(), place, closest_reach, x_);
      if (nearest >= 0 && around_.count < around_.triangles.size()) around_.add(nearest);
    }
    around_.update(x_, table_);
  }

  [[nodiscard]] float nearest_squared() const {
    float squared = around_.squared(0);
    for (std::size_t i = 1; i < around_.count; ++i) squared = std::min(squared, around_.squared(i));
    return squared;
  }

  const ExteriorGrid& exterior_;
  const TriangleTable& table_;
  double r_;
  const Eigen::Vector3d& p_;
  const Eigen::Vector3d& site_;
  Eigen::Vector3d x_;
  Contacts contacts_;
  Surroundings around_;
  std::array<bool, Contacts::capacity> kept_{};                   ///< by contact: retained after the last step
  bool is_truncated_ = false;                                     ///< the last step was shortened
  double trust_radius_ = 0.1;                                     ///< maximum correction of a step, in units of r
  Eigen::Vector3d last_step_ = Eigen::Vector3d::Zero();           ///< the last step, before it was shortened
  double step_length_ = std::numeric_limits<double>::infinity();  ///< its length
};

}  // namespace

std::optional<Eigen::Vector3d> nearest_offset_point(const ExteriorGrid& exterior, const Eigen::Vector3d& p,
                                                    const Eigen::Vector3d& site, std::int32_t triangle,
                                                    const std::optional<Eigen::Vector3d>& known) {
  return OffsetPointSearch(exterior, p, site, triangle).find(known);
}

}  // namespace shapegauge
