#pragma once

#include <vector>

#include "shapegauge/core/shape/connectivity.h"
#include "tests/oracle/leaf_graph.h"
#include "tests/oracle/offset_exterior.h"

namespace shapegauge {

/// Finds the connected parts of the free space of a classified octree, and what each leaf belongs to.
///
/// Two neighbouring cubes are joined where the way between their centres is proven free. The part that reaches the
/// root's border is the exterior. Any other part that holds a free cube is enclosed. A part without one is too small to
/// be sure that it is not joined to another: on a closed surface, the crossings of a ray decide between enclosed and
/// exterior (a slit that leads outside); otherwise it stays undecided, unless only solid leaves and enclosed ones
/// surround it.
class ExteriorFlood {
 public:
  /// Floods the nodes of an exterior. After leaves have been divided, only examines connections to and from the new
  /// ones.
  void run(const OffsetExterior& exterior, std::vector<ExteriorNode>& nodes);

  /// The mixed leaves of the smallest size near free space that the crossings of a ray find outside of a closed surface
  /// though the flood did not get there: smaller cubes might show a way, or that there is none.
  [[nodiscard]] std::vector<ExteriorCell> possible_passages(const OffsetExterior& exterior) const;

 private:
  /// Finds the parts and what they belong to.
  void join(const OffsetExterior& exterior);
  /// Sets the leaves' spaces.
  void label(const OffsetExterior& exterior, std::vector<ExteriorNode>& nodes);
  LeafGraph graph_;
  DisjointSets parts_;               ///< of the nodes' centres
  std::vector<FreeSpace> spaces_;    ///< of the part whose least leaf it is
  std::vector<bool> leads_nowhere_;  ///< the leaves' centres are outside of a closed surface, but were not reached
};

}  // namespace shapegauge
