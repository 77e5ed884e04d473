#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "tests/oracle/offset_exterior.h"

namespace shapegauge {

/// Two leaves of an octree that share a face, or the smaller one's face, across an axis.
struct FacePair {
  std::int32_t low;
  std::int32_t high;
  int axis;
};

/// Where the leaves of an octree are, and which of them share a face.
class LeafGraph {
 public:
  LeafGraph() = default;
  explicit LeafGraph(const OffsetExterior& exterior);

  [[nodiscard]] const std::vector<FacePair>& pairs(int axis) const { return pairs_[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] const Eigen::Vector3d& centre(std::int32_t leaf) const {
    return centres_[static_cast<std::size_t>(leaf)];
  }
  /// Half of the leaf's edge.
  [[nodiscard]] double half(std::int32_t leaf) const { return halves_[static_cast<std::size_t>(leaf)]; }

 private:
  using Nodes = std::vector<ExteriorNode>;
  void visit(const Nodes& nodes, const ExteriorCell& cell);
  /// The pairs of leaves across the face that two cubes of the same size share.
  void pair(const Nodes& nodes, std::int32_t low, std::int32_t high, int axis);

  std::vector<Eigen::Vector3d> centres_;
  std::vector<double> halves_;
  std::array<std::vector<FacePair>, 3> pairs_;
};

}  // namespace shapegauge
