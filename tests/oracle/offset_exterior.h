#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <vector>

#include "tests/oracle/surface_tree.h"

namespace shapegauge {

/// What is known of a cube of space: it lies in the offset solid, it lies outside of it, or neither.
enum class CellKind : std::uint8_t { divided, solid, free, mixed };

/// To which part of the free space a cell belongs, or for a mixed cell the free space in it and around it.
enum class FreeSpace : std::uint8_t { none, exterior, enclosed, both };

/// A cube of the octree.
struct ExteriorCell {
  Eigen::Vector3d centre;
  double half;        ///< half of the cube's edge
  std::int32_t node;  ///< index into OffsetExterior::nodes()
};

/// A point of the exterior or of the outer offset surface.
struct ExteriorPoint {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  bool decided = true;  ///< false where its belonging to the exterior could not be decided and was assumed
};

/// A node of the octree: a cube that is divided into eight, or a leaf.
struct ExteriorNode {
  std::int32_t first_child = -1;  ///< the children are eight nodes in a row
  std::int32_t triangle = -1;     ///< the triangle closest to the centre, where one was within reach
  float clearance = 0;            ///< distance from the centre to the surface, minus r, for a mixed leaf
  CellKind kind = CellKind::mixed;
  FreeSpace centre_space = FreeSpace::none;  ///< of the centre; all of a free leaf
  FreeSpace space = FreeSpace::none;         ///< of the leaf and, for a mixed or solid one, the leaves around it
  bool may_hold_exterior = false;            ///< some exterior point may lie in the cube
};

class ExteriorFlood;

/// The space around a shape, sorted into offset solid O(r), exterior E(r) and enclosed free space
/// (docs/reference/definitions.md#offset-sdf): an octree, refined where the boundary of O(r) runs, flooded from
/// outside.
///
/// The tree's smallest cubes measure r/2 or 1/256 of the diagonal, whichever is larger; on a closed surface, for small
/// r, up to 3r/4, but 3r/8 around free space outside of it that seems to lead nowhere. Free space narrower than such a
/// cube's diagonal may escape the flood. On a closed surface the crossings of a ray then decide; otherwise contains()
/// may have no answer. A cavity that is joined to the outside only through a passage so narrow counts as enclosed.
///
/// Expects a shape with a diagonal of about 1. Safe to query from many threads. Keeps a reference to the surface tree.
class OffsetExterior {
 public:
  OffsetExterior(const SurfaceTree& tree, const Eigen::AlignedBox3d& bounds, double r, bool closed);

  [[nodiscard]] double r() const { return r_; }
  /// Edge of the cubes at the boundary of the offset solid.
  [[nodiscard]] double resolution() const { return resolution_; }
  [[nodiscard]] const SurfaceTree& tree() const { return tree_; }
  [[nodiscard]] const std::vector<ExteriorNode>& nodes() const { return nodes_; }

  /// Whether the surface is closed, so that the crossings of a ray tell inside from outside.
  [[nodiscard]] bool is_closed() const { return closed_; }

  /// The cube that everything lies in; all beyond it is exterior.
  [[nodiscard]] ExteriorCell root() const { return {root_centre_, root_half_, 0}; }

  /// The i-th of the eight cubes that a cube divides into (bit k of i: the upper half along axis k).
  [[nodiscard]] static ExteriorCell octant(const ExteriorCell& cell, int i, std::int32_t node);

  /// The leaf around x, or nothing where x is beyond the root.
  [[nodiscard]] std::optional<ExteriorCell> leaf_at(const Eigen::Vector3d& x) const;

  /// Whether a point outside of the offset solid belongs to the exterior; nothing where that could not be decided.
  [[nodiscard]] std::optional<bool> contains(const Eigen::Vector3d& x) const;

  /// Whether x is outside of the surface as far as the crossings of a ray from x tell: even in number, and as many in
  /// as out where the triangles are oriented alike (the overlap of two parts is crossed evenly too). Nothing where the
  /// surface is not closed, or the rays that were tried run too close to edges.
  [[nodiscard]] std::optional<bool> is_outside_by_crossings(const Eigen::Vector3d& x) const;

 private:
  void classify(const ExteriorCell& cell, const SurfaceTree::Nearest& nearest);
  /// Divides the mixed leaves and replaces them by those of their children that are mixed. Returns false without
  /// dividing if there are none, or there would be too many.
  bool divide(std::vector<ExteriorCell>& mixed);
  /// The mixed leaves larger than the smallest of which it is not known what free space is in them.
  void find_unsettled(const ExteriorCell& cell, double smallest, std::vector<ExteriorCell>& found) const;
  /// Divides cubes larger than r/2 once more where free space outside of a closed surface seems to lead nowhere.
  void look_for_passages(ExteriorFlood& flood);
  /// Divides unsettled leaves further, and settles what remains by climbing.
  void settle_pockets(double smallest, ExteriorFlood& flood);
  /// Takes unsettled leaves for enclosed from whose centre no climb leads to the exterior. From the others it does, and
  /// contains() climbs from the point in question.
  void settle_by_climb();
  bool mark_exterior(std::int32_t node);
  /// What the centre of the leaf around x belongs to, where the ball of free space around x holds it.
  [[nodiscard]] std::optional<bool> label_seen_from(const Eigen::Vector3d& x, double clearance) const;
  /// Climbs away from the surface, through free space only, until the ball of free space around x settles it.
  [[nodiscard]] std::optional<bool> decide_by_climb(Eigen::Vector3d x) const;
  /// Moves x away from the surface, by the length or, where that would come nearer to another part of it, by less,
  /// along the ridge or the edge between up to four parts. False where there is no way up.
  bool step_up(Eigen::Vector3d& x, ClosestHit& hit, double length) const;

  const SurfaceTree& tree_;
  double r_;
  bool closed_;
  double resolution_ = 0;
  Eigen::Vector3d root_centre_;
  double root_half_;
  std::vector<ExteriorNode> nodes_;
};

}  // namespace shapegauge
