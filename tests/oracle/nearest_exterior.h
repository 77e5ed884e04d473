#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "tests/oracle/exterior_frontier.h"
#include "tests/oracle/half_spaces.h"
#include "tests/oracle/offset_exterior.h"

namespace shapegauge {

/// Finds the point of the outer offset surface that is closest to a point p of the surface
/// (docs/reference/definitions.md#offset-sdf), to within 0.008 r, for one point after another.
///
/// A descent gives a local minimum: p is projected onto the half-spaces that the nearest triangles leave free, again
/// and again. Branch and bound then proves or improves it. Space is covered with cubes, first those of the octree; of a
/// cube it is known in which half-spaces all of its exterior points lie, from triangles within r of it. A cube whose
/// cut with its half-spaces is nearer to p than the minimum gets another half-space from the triangle that covers its
/// point nearest to p, or is divided; where nothing covers that point, the next descent starts there. Cubes and
/// half-spaces are kept for the points that follow: pass neighbouring points one after the other.
///
/// A passage whose half-width exceeds r by less than 0.001 r may go unseen. What is found may depend on the points
/// before it within the tolerance. Keeps a reference to the exterior.
class NearestExteriorSearch {
 public:
  explicit NearestExteriorSearch(const OffsetExterior& exterior);

  /// The normal, of length 1 or zero, says where to look first.
  ExteriorPoint find(const Eigen::Vector3d& p, const Eigen::Vector3d& normal);

 private:
  static constexpr std::size_t most_contacts = 7;
  static constexpr std::size_t most_bounds = 5;

  /// A triangle that keeps a point at its distance, and the half-space that it leaves free.
  struct Contact {
    std::int32_t triangle;
    HalfSpace free;
  };

  /// A cube of the octree, or of its division here, with half-spaces that all of its exterior points lie in.
  struct Cube {
    ExteriorCell cell;        ///< its node is that of the octree's leaf for a part of one
    bool is_covered = false;  ///< one triangle's ball of radius r holds all of it
    bool is_outside = false;  ///< its free points are known not to be inside of a closed surface, as far as can be
    std::size_t bounds = 0;
    std::array<HalfSpace, most_bounds> half_spaces;
    std::array<std::int32_t, most_bounds> triangles;  ///< that the half-spaces are from
  };

  /// A cube's half-spaces and those of its faces, put into the given room.
  static std::span<const HalfSpace> with_faces(const Cube& cube, std::span<HalfSpace, most_bounds + 6> room);
  [[nodiscard]] double limit() const;
  [[nodiscard]] Contact contact_at(std::int32_t triangle, const Eigen::Vector3d& surface_point,
                                   const Eigen::Vector3d& x) const;
  [[nodiscard]] ClosestHit closest(const Eigen::Vector3d& x, std::int32_t hint) const;
  void keep(const Eigen::Vector3d& candidate, std::vector<Contact> contacts);
  void descend_from(const Eigen::Vector3d& start);
  void descend(std::vector<Contact> contacts);
  [[nodiscard]] std::vector<Contact> laid_anew(const std::vector<Contact>& contacts, const Eigen::Vector3d& x) const;
  [[nodiscard]] std::optional<Eigen::Vector3d> settle(std::vector<Contact>& contacts) const;
  [[nodiscard]] Eigen::Vector3d nearest_known_exterior() const;

  void cover_surroundings();
  void gather(const ExteriorCell& cell, double reach);
  void add(const Cube& cube);
  void show_bounds(std::int32_t index, const Eigen::Vector3d& x);
  void prove();
  void look_into(std::int32_t index);
  [[nodiscard]] std::optional<Eigen::Vector3d> nearest_in(const Cube& cube) const;
  bool add_bound(Cube& cube, std::int32_t triangle) const;
  [[nodiscard]] bool is_inside(Cube& cube) const;
  bool cuts_off(Cube& cube, std::int32_t triangle, const Eigen::Vector3d& x) const;
  void divide(std::int32_t index);
  bool push_out(const Eigen::Vector3d& x, const ClosestHit& hit);

  const OffsetExterior& exterior_;
  const SurfaceTree& tree_;
  double r_;

  // Of the point in question.
  Eigen::Vector3d p_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d best_ = Eigen::Vector3d::Zero();
  double best_distance_ = std::numeric_limits<double>::infinity();
  bool decided_ = true;
  std::vector<NearbyCube> waiting_;  ///< a heap, the nearest first

  // Kept from point to point.
  std::vector<Contact> contacts_;  ///< that hold the last point found
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  double covered_ = -1;  ///< all exterior points within this distance of the centre are in the cubes
  std::vector<Cube> cubes_;
  ExteriorFrontier frontier_;
};

}  // namespace shapegauge
