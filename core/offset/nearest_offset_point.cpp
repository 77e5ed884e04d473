#include "shapegauge/core/offset/nearest_offset_point.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace shapegauge {

namespace {

constexpr std::size_t most_contacts = 5;

/// A triangle, and the half-space that the ball of radius r about a point of it leaves free: normal . x >= height.
struct Contact {
  std::int32_t triangle;
  Eigen::Vector3d normal;
  double height;
};

struct Contacts {
  std::array<Contact, most_contacts> list;
  std::size_t count = 0;
};

/// Whether x lies in all half-spaces.
bool satisfies(const Contacts& contacts, const Eigen::Vector3d& x, double tolerance) {
  for (std::size_t i = 0; i < contacts.count; ++i) {
    if (contacts.list[i].normal.dot(x) < contacts.list[i].height - tolerance) return false;
  }
  return true;
}

/// The point nearest to p that lies on the planes of up to three contacts, where it is held by all of them.
template <int N>
std::optional<Eigen::Vector3d> held_by(const Eigen::Vector3d& p, const std::array<const Contact*, N>& contacts) {
  Eigen::Matrix<double, 3, N> normals;
  Eigen::Matrix<double, N, 1> missing;
  for (int i = 0; i < N; ++i) {
    normals.col(i) = contacts[static_cast<std::size_t>(i)]->normal;
    missing[i] = contacts[static_cast<std::size_t>(i)]->height - normals.col(i).dot(p);
  }
  const Eigen::Matrix<double, N, N> gram = normals.transpose() * normals;
  if (std::abs(gram.determinant()) < 1e-9) return std::nullopt;
  const Eigen::Matrix<double, N, 1> push = gram.inverse() * missing;
  if (push.minCoeff() < 0) return std::nullopt;
  return p + normals * push;
}

/// The point of all half-spaces nearest to p: by the conditions of Karush, Kuhn and Tucker it is the one that one, two
/// or three of them hold and that lies in the others.
std::optional<Eigen::Vector3d> project(const Eigen::Vector3d& p, const Contacts& contacts) {
  constexpr double tolerance = 1e-7;
  const auto& list = contacts.list;
  const std::size_t n = contacts.count;
  if (satisfies(contacts, p, tolerance)) return p;
  for (std::size_t i = 0; i < n; ++i) {
    const auto x = held_by<1>(p, {&list[i]});
    if (x && satisfies(contacts, *x, tolerance)) return x;
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto x = held_by<2>(p, {&list[i], &list[j]});
      if (x && satisfies(contacts, *x, tolerance)) return x;
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const auto x = held_by<3>(p, {&list[i], &list[j], &list[k]});
        if (x && satisfies(contacts, *x, tolerance)) return x;
      }
    }
  }
  return std::nullopt;
}

/// The half-space that the ball about x - v leaves free.
Contact contact(std::int32_t triangle, const Eigen::Vector3d& x, const Eigen::Vector3d& v, double r) {
  const double distance = v.norm();
  const Eigen::Vector3d normal = v / distance;
  return {triangle, normal, normal.dot(x) - distance + r};
}

/// Whether the triangles around x are that far away.
bool is_free(const ExteriorGrid& exterior, const CellsAround& around, const Eigen::Vector3d& x, double least) {
  TriangleTable::Vectors vectors;
  if (!vectors_around(exterior, around, x, vectors)) return around.touches_exterior;
  return *std::min_element(vectors.squared.begin(), vectors.squared.end()) >= static_cast<float>(least * least);
}

}  // namespace

bool is_exterior(const ExteriorGrid& exterior, const Eigen::Vector3d& x, double slack) {
  const CellsAround around = cells_around(exterior, x);
  return around.touches_exterior && is_free(exterior, around, x, exterior.grid().r * (1 - slack));
}

namespace {

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

}  // namespace

std::optional<Eigen::Vector3d> nearest_offset_point(const ExteriorGrid& exterior, const Eigen::Vector3d& p,
                                                    const Eigen::Vector3d& site, std::int32_t triangle) {
  constexpr int most_steps = 8;
  constexpr double most_moved = 0.4;  // at once, in parts of r: no wall is so thin
  constexpr double settled = 1e-2;    // of a step's length, in parts of r
  constexpr double tolerance = 1e-3;  // of the distance, in parts of r
  const double r = exterior.grid().r;
  const TriangleTable& table = exterior.surface().triangles;
  // First the contacts' triangles, then those around.
  std::array<std::int32_t, 2 * TriangleTable::at_once> triangles;
  triangles.fill(triangle);
  std::array<TriangleTable::Vectors, 2> vectors;
  const auto vector = [&](std::size_t i) {
    return vectors[i / TriangleTable::at_once].vector(i % TriangleTable::at_once);
  };
  const auto squared_at = [&](std::size_t i) {
    return vectors[i / TriangleTable::at_once].squared[i % TriangleTable::at_once];
  };
  Contacts contacts;
  table.vectors_to(site, triangles.data(), vectors[0]);
  contacts.list[contacts.count++] = contact(triangle, site, vector(0), r);
  Eigen::Vector3d x = site;
  std::optional<Eigen::Vector3d> found;
  for (int step = 0; step < most_steps; ++step) {
    const auto next = project(p, contacts);
    if (!next) return found;
    const double moved = (*next - x).norm();
    const bool is_limited = moved > most_moved * r;
    x = is_limited ? (x + most_moved * r / moved * (*next - x)).eval() : *next;
    const CellsAround around = cells_around(exterior, x);
    std::size_t count = contacts.count;
    for (std::size_t i = 0; i < static_cast<std::size_t>(around.count); ++i) {
      const std::int32_t other = around.triangles[i];
      if (std::find(triangles.begin(), triangles.begin() + count, other) == triangles.begin() + count) {
        triangles[count++] = other;
      }
    }
    table.vectors_to(x, triangles.data(), vectors[0]);
    if (count > TriangleTable::at_once) table.vectors_to(x, triangles.data() + TriangleTable::at_once, vectors[1]);
    std::size_t closest = 0;
    for (std::size_t i = 1; i < count; ++i) {
      if (squared_at(i) < squared_at(closest)) closest = i;
    }
    const double squared = static_cast<double>(squared_at(closest));
    if (!(squared > 0)) return found;
    const bool covered = squared < r * r * (1 - tolerance) * (1 - tolerance);
    if (!covered && !is_limited && (around.touches_exterior || leads_to(exterior, x, site))) {
      found = x;
      if (moved < settled * r) return found;
    }
    // Those that do not hold x are let go.
    const bool is_new = covered && closest >= contacts.count;
    const Contact added = contact(triangles[closest], x, vector(closest), r);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < contacts.count; ++i) {
      if (!is_limited && contacts.list[i].normal.dot(x) > contacts.list[i].height + 1e-6) continue;
      contacts.list[kept] = contact(triangles[i], x, vector(i), r);
      triangles[kept++] = triangles[i];
    }
    contacts.count = kept;
    if (is_new && contacts.count < most_contacts) {
      triangles[contacts.count] = added.triangle;
      contacts.list[contacts.count++] = added;
    }
  }
  return found;
}

}  // namespace shapegauge
