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

/// A triangle, and the half-space that the ball of radius r about a point of it leaves free: normal . x >= height.
struct Contact {
  std::int32_t triangle;
  Eigen::Vector3d normal;
  double height;
  Eigen::Vector3d place;  ///< the point of the triangle
};

struct Contacts {
  static constexpr std::size_t most = 5;
  std::array<Contact, most> list;
  std::size_t count = 0;

  void add(const Contact& contact) {
    if (count < most) list[count++] = contact;
  }
};

/// A projection, the contacts on whose planes it lies, and how hard each pushes.
struct Projected {
  Eigen::Vector3d x;
  std::size_t count = 0;
  std::array<std::size_t, 3> contacts{};
  std::array<double, 3> pushes{};
};

/// The point of the half-spaces nearest to p. By the conditions of Karush, Kuhn and Tucker it is p + the sum of push_i
/// normal_i, with a push >= 0 for one, two or three of them, on the planes of which it lies, and 0 for the others.
class Projection {
 public:
  Projection(const Eigen::Vector3d& p, const Contacts& contacts) : p_(p), contacts_(contacts) {
    for (std::size_t i = 0; i < contacts.count; ++i) {
      missing_[i] = contacts.list[i].height - contacts.list[i].normal.dot(p);
      for (std::size_t j = 0; j <= i; ++j) {
        gram_[i][j] = gram_[j][i] = contacts.list[i].normal.dot(contacts.list[j].normal);
      }
    }
  }

  /// Nothing where they have no point in common.
  [[nodiscard]] std::optional<Projected> find() const {
    const std::size_t n = contacts_.count;
    const auto worst =
        static_cast<std::size_t>(std::max_element(missing_.begin(), missing_.begin() + n) - missing_.begin());
    if (missing_[worst] <= tolerance) return Projected{.x = p_};
    // Alone only the plane farthest from p can do: seen from it, all others are nearer.
    if (const auto x = held_by<1>({worst}, {missing_[worst]})) return x;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (const auto x = held_by_two(i, j)) return x;
      }
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) {
          if (const auto x = held_by_three(i, j, k)) return x;
        }
      }
    }
    return std::nullopt;
  }

 private:
  static constexpr double tolerance = 1e-6;
  static constexpr double least_determinant = 1e-6;

  /// Where the pushes lead, if none is negative and the other half-spaces hold it.
  template <std::size_t count>
  std::optional<Projected> held_by(const std::array<std::size_t, count>& which,
                                   const std::array<double, count>& push) const {
    if (*std::min_element(push.begin(), push.end()) < 0) return std::nullopt;
    for (std::size_t i = 0; i < contacts_.count; ++i) {
      double missing = missing_[i];
      for (std::size_t k = 0; k < count; ++k) missing -= push[k] * gram_[i][which[k]];
      if (missing > tolerance) return std::nullopt;
    }
    Projected projected{.x = p_, .count = count};
    for (std::size_t k = 0; k < count; ++k) {
      projected.x += push[k] * contacts_.list[which[k]].normal;
      projected.contacts[k] = which[k];
      projected.pushes[k] = push[k];
    }
    return projected;
  }

  [[nodiscard]] std::optional<Projected> held_by_two(std::size_t i, std::size_t j) const {
    const double determinant = 1 - gram_[i][j] * gram_[i][j];
    if (determinant < least_determinant) return std::nullopt;
    return held_by<2>({i, j}, {(missing_[i] - gram_[i][j] * missing_[j]) / determinant,
                               (missing_[j] - gram_[i][j] * missing_[i]) / determinant});
  }

  /// By Cramer's rule.
  [[nodiscard]] std::optional<Projected> held_by_three(std::size_t i, std::size_t j, std::size_t k) const {
    const double a = gram_[i][j];
    const double b = gram_[i][k];
    const double c = gram_[j][k];
    const double determinant = 1 + 2 * a * b * c - a * a - b * b - c * c;
    if (determinant < least_determinant) return std::nullopt;
    const double mi = missing_[i];
    const double mj = missing_[j];
    const double mk = missing_[k];
    return held_by<3>({i, j, k}, {((1 - c * c) * mi + (b * c - a) * mj + (a * c - b) * mk) / determinant,
                                  ((b * c - a) * mi + (1 - b * b) * mj + (a * b - c) * mk) / determinant,
                                  ((a * c - b) * mi + (a * b - c) * mj + (1 - a * a) * mk) / determinant});
  }

  const Eigen::Vector3d& p_;
  const Contacts& contacts_;
  std::array<double, Contacts::most> missing_{};
  std::array<std::array<double, Contacts::most>, Contacts::most> gram_;
};

/// The half-space that the ball about x - v leaves free.
Contact contact(std::int32_t triangle, const Eigen::Vector3d& x, const Eigen::Vector3d& v, double r) {
  const double distance = v.norm();
  const Eigen::Vector3d normal = v / distance;
  return {triangle, normal, normal.dot(x) - distance + r, x - v};
}

/// Whether the triangles around x are that far away.
bool is_free(const ExteriorGrid& exterior, const CellsAround& around, const Eigen::Vector3d& x, double least) {
  TriangleTable::Vectors vectors;
  if (!vectors_around(exterior, around, x, vectors)) return around.touches_exterior;
  return *std::min_element(vectors.squared.begin(), vectors.squared.end()) >= static_cast<float>(least * least);
}

/// Whether the straight way from x to a point of the exterior near it is free, up to what a convex obstacle that both
/// ends touch may bulge into it. E(r) reaches into valleys between balls where no cell's centre fits; these are convex.
bool leads_to(const ExteriorGrid& exterior, const Eigen::Vector3d& x, const Eigen::Vector3d& to) {
  constexpr double farthest = 5;
  constexpr double spacing = 0.7;
  const double length = (to - x).norm();
  if (length > farthest) return false;
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

/// Triangles, and the vectors from their closest points to a point.
struct Surroundings {
  std::array<std::int32_t, 2 * TriangleTable::at_once> triangles;
  std::size_t count = 0;
  std::array<TriangleTable::Vectors, 2> vectors;

  /// No branch depends on whether it is known: that is hard to foresee.
  void add(std::int32_t triangle) {
    bool is_known = false;
    for (std::size_t i = 0; i < count; ++i) is_known |= triangles[i] == triangle;
    triangles[count] = triangle;
    count += is_known ? 0 : 1;
  }
  void look_from(const Eigen::Vector3d& x, const TriangleTable& table) {
    constexpr std::size_t eight = TriangleTable::at_once;
    std::fill(triangles.begin() + count, triangles.begin() + (count > eight ? 2 * eight : eight), triangles[0]);
    table.vectors_to(x, triangles.data(), vectors[0]);
    if (count > eight) table.vectors_to(x, triangles.data() + eight, vectors[1]);
  }
  [[nodiscard]] Eigen::Vector3d vector(std::size_t i) const {
    return vectors[i / TriangleTable::at_once].vector(i % TriangleTable::at_once);
  }
  [[nodiscard]] float squared(std::size_t i) const {
    return vectors[i / TriangleTable::at_once].squared[i % TriangleTable::at_once];
  }
};

/// The contacts for the next step: of the given ones, which come first among those around x, those that are kept, laid
/// anew, and up to two that cover x and were not among them, the closest and the closest of another direction.
Contacts contacts_for(const Surroundings& around, const Contacts& before, const std::array<bool, Contacts::most>& kept,
                      const Eigen::Vector3d& x, double r, double covering) {
  constexpr double same_direction = 0.985;
  Contacts contacts;
  for (std::size_t i = 0; i < before.count; ++i) {
    if (kept[i]) contacts.add(contact(around.triangles[i], x, around.vector(i), r));
  }
  const std::size_t old = contacts.count;
  while (contacts.count < Contacts::most && contacts.count < old + 2) {
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
    contacts.add(contact(around.triangles[closest], x, around.vector(closest), r));
  }
  return contacts;
}

/// What a step to the projection lacks, because the balls about edges and corners bend away from the half-spaces that
/// touch them: tangentially to the contacts that hold it, where the curvature is 1 / r, it is short by the factor
/// 1 - push / r (docs/methods/offset_sdf.md#the-steps-to-q).
Eigen::Vector3d lacking(const TriangleTable& table, const Eigen::Vector3d& step, const Projected& to,
                        const Contacts& contacts, double r) {
  constexpr double most_bent = 0.85;
  const auto growth = [&](double bent) { return 1 / (1 - std::min(bent, most_bent)) - 1; };
  const auto held_by = [&](std::size_t k) { return contacts.list[to.contacts[k]]; };
  const auto place = [&](std::size_t k) { return table.place_of(held_by(k).place, held_by(k).triangle); };
  using Part = TriangleTable::Part;
  if (to.count == 1) {
    const auto [part, edge] = place(0);
    if (part == Part::face) return Eigen::Vector3d::Zero();
    const Eigen::Vector3d tangential = step - held_by(0).normal.dot(step) * held_by(0).normal;
    return growth(to.pushes[0] / r) * (tangential - edge.dot(tangential) * edge);
  }
  if (to.count == 2) {
    const Eigen::Vector3d along = held_by(0).normal.cross(held_by(1).normal).normalized();
    double bent = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto [part, edge] = place(k);
      if (part != Part::face) bent += to.pushes[k] / r * (1 - std::pow(edge.dot(along), 2));
    }
    return growth(bent) * along.dot(step) * along;
  }
  return Eigen::Vector3d::Zero();
}

/// The step to the projection, and what it lacks as far as it does not get longer than so.
Eigen::Vector3d step_to(const Projected& to, const Eigen::Vector3d& x, const TriangleTable& table,
                        const Contacts& contacts, double r, double longest) {
  const Eigen::Vector3d step = to.x - x;
  const double room = longest - step.norm();
  if (room <= 0) return step;
  const Eigen::Vector3d more = lacking(table, step, to, contacts, r);
  const double length = more.norm();
  return length > room ? (step + room / length * more).eval() : (step + more).eval();
}

/// The steps from the site to the nearest point of the offset surface (docs/methods/offset_sdf.md#the-steps-to-q).
class OffsetPointSearch {
 public:
  OffsetPointSearch(const ExteriorGrid& exterior, const Eigen::Vector3d& p, const Eigen::Vector3d& site,
                    std::int32_t triangle)
      : exterior_(exterior), table_(exterior.surface().triangles), r_(exterior.grid().r), p_(p), site_(site), x_(site) {
    around_.add(triangle);
    around_.look_from(site, table_);
    contacts_.add(contact(triangle, site, around_.vector(0), r_));
  }

  /// As nearest_offset_point().
  std::optional<Eigen::Vector3d> find(const std::optional<Eigen::Vector3d>& known) {
    constexpr int most_steps = 12;
    constexpr double settled = 0.01;  // of a step's length, in parts of r
    constexpr double leads_to_known = 0.3;
    constexpr double tolerance = 2e-4;  // of the distance
    const double covering = r_ * (1 - tolerance);
    std::optional<Eigen::Vector3d> found;
    for (int step = 0; step < most_steps; ++step) {
      if (!move()) return found;
      const CellsAround cells = cells_around(exterior_, x_);
      look_around(cells);
      const float squared = nearest_squared();
      if (!(squared > 0)) return found;
      const bool covered = static_cast<double>(squared) < covering * covering;
      if (!covered && !is_limited_) {
        // Free, but enclosed: no step comes out of there again.
        if (!cells.touches_exterior && !leads_to(exterior_, x_, site_)) return found;
        found = x_;
        if (moved_ < settled * r_) return found;
        if (known && (x_ - *known).norm() < leads_to_known * r_) return std::nullopt;
      }
      contacts_ = contacts_for(around_, contacts_, kept_, x_, r_, covering);
      if (contacts_.count == 0) return found;
    }
    return found;
  }

 private:
  /// Makes a step to the projection of p on the contacts' half-spaces; false where these have no point in common.
  bool move() {
    constexpr double most_moved = 0.4;  // at once, in parts of r: no wall is so thin
    const auto projected = Projection(p_, contacts_).find();
    if (!projected) return false;
    const Eigen::Vector3d move = step_to(*projected, x_, table_, contacts_, r_, trusted_ * r_);
    const double moved = move.norm();
    is_limited_ = moved > most_moved * r_;
    x_ += (is_limited_ ? most_moved * r_ / moved : 1.0) * move;
    kept_ = {};
    for (std::size_t i = 0; i < contacts_.count; ++i) {
      kept_[i] = is_limited_ || contacts_.list[i].normal.dot(x_) <= contacts_.list[i].height + 1e-6;
    }
    if (move.dot(move_) < 0 && moved > 0.5 * moved_) trusted_ /= 2;  // to and fro
    move_ = move;
    moved_ = moved;
    return true;
  }

  /// The triangles of the contacts, those around x and, where x has nearly settled, those nearest to the contacts.
  void look_around(const CellsAround& cells) {
    constexpr double nearly_settled = 0.05;
    around_.count = 0;
    for (std::size_t i = 0; i < contacts_.count; ++i) around_.triangles[around_.count++] = contacts_.list[i].triangle;
    for (std::size_t i = 0; i < static_cast<std::size_t>(cells.count); ++i) around_.add(cells.triangles[i]);
    // Fine triangles: the closest is seldom among those of the cells, but near where the contacts are.
    for (std::size_t i = 0; i < contacts_.count && moved_ < nearly_settled * r_; ++i) {
      if (!kept_[i]) continue;
      const Eigen::Vector3d place = x_ - r_ * contacts_.list[i].normal;
      const std::int32_t nearest =
          closest_triangle_about(exterior_.grid(), exterior_.surface(), place, closest_reach, x_);
      if (nearest >= 0 && around_.count < around_.triangles.size()) around_.add(nearest);
    }
    around_.look_from(x_, table_);
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
  std::array<bool, Contacts::most> kept_{};                 ///< the contacts that the last step keeps
  bool is_limited_ = false;                                 ///< the last step was cut short
  double trusted_ = 0.1;                                    ///< longest correction of a step, in parts of r
  Eigen::Vector3d move_ = Eigen::Vector3d::Zero();          ///< the last step, before it was cut short
  double moved_ = std::numeric_limits<double>::infinity();  ///< its length
};

}  // namespace

std::optional<Eigen::Vector3d> nearest_offset_point(const ExteriorGrid& exterior, const Eigen::Vector3d& p,
                                                    const Eigen::Vector3d& site, std::int32_t triangle,
                                                    const std::optional<Eigen::Vector3d>& known) {
  return OffsetPointSearch(exterior, p, site, triangle).find(known);
}

}  // namespace shapegauge
