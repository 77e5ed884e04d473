#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <queue>
#include <unordered_map>
#include <vector>

#include "shapegauge/core/spatial/half_spaces.h"
#include "shapegauge/core/spatial/offset_exterior.h"

namespace shapegauge {

/// A point of the outer offset surface.
struct ExteriorPoint {
  Eigen::Vector3d point;
  bool decided = true;  ///< false where its belonging to the exterior could not be decided and was assumed
};

/// Search for the point of the outer offset surface that is closest to a point inside of the offset solid.
///
/// Branch and bound over the octree's cubes, divided further as needed, nearest first: a cube is dropped when the
/// surface is proven to be within r of all of it, or when it cannot hold a point that is closer than the best so far by
/// 0.005 r. Candidates come from descent: the point is projected onto the half-spaces that the nearest triangles leave
/// free, again and again, which ends in a local minimum. A passage whose half-width exceeds r by less than 0.005 r may go
/// unseen.
///
/// What is found out about cubes is kept for later searches; it does not depend on their order. One object a thread.
class NearestExterior {
 public:
  explicit NearestExterior(const OffsetExterior& exterior) : exterior_(exterior) {}

  /// The search for a point p of the surface; the normal, of length 1 or zero, says where to look first.
  ExteriorPoint find(const Eigen::Vector3d& p, const Eigen::Vector3d& normal);

 private:
  /// What is known of a cube below the octree's leaves.
  struct FineCell {
    std::int32_t first_child = -1;
    std::int32_t triangle = -1;
    enum class Kind : std::uint8_t { unknown, dropped, exterior, mixed } kind = Kind::unknown;
    bool centre_is_exterior = false;
    bool decided = true;
  };

  /// A cube that waits to be looked into, and how close to p it comes.
  struct Waiting {
    double bound;
    ExteriorCell cell;
    bool fine;
    bool operator>(const Waiting& other) const { return bound > other.bound; }
  };

  /// A triangle that keeps the point at its distance, and the half-space that it leaves free.
  struct Contact {
    std::int32_t triangle;
    HalfSpace free;
  };

  [[nodiscard]] bool may_improve(double bound) const;
  void wait_for(const ExteriorCell& cell, bool fine);
  void look_into(const ExteriorCell& cell);
  void look_into_fine(const ExteriorCell& cell);
  FineCell evaluated(const ExteriorCell& cell);
  std::int32_t fine_root(std::int32_t leaf);
  void try_point(const Eigen::Vector3d& x, bool decided);
  void descend(std::vector<Contact> contacts);
  [[nodiscard]] Contact contact_at(std::int32_t triangle, const Eigen::Vector3d& surface_point,
                                   const Eigen::Vector3d& x) const;

  const OffsetExterior& exterior_;
  std::vector<FineCell> fine_cells_;
  std::unordered_map<std::int32_t, std::int32_t> fine_roots_;

  // The search under way.
  Eigen::Vector3d p_ = Eigen::Vector3d::Zero();
  ExteriorPoint best_{};
  double best_distance_ = 0;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting_;
};

}  // namespace shapegauge
