#pragma once

#include <vector>

#include "shapegauge/core/shape/disjoint_sets.h"
#include "shapegauge/core/spatial/offset_exterior.h"

namespace shapegauge {

/// Finds the connected parts of the free space of a classified octree and sets each leaf's `centre_space` and `space`.
///
/// Two neighbouring cubes are joined where the way between their centres is proven free. The part that reaches the
/// root's border is the exterior. Any other part that holds a free cube is enclosed. A part without one is too small to
/// be sure that it is not joined to another: on a closed surface, the crossings of a ray decide between enclosed and
/// exterior (a slit that leads outside); otherwise it stays undecided, unless only solid leaves and enclosed ones
/// surround it.
///
/// Run again when leaves have been divided, it looks only at ways to and from the new ones.
class ExteriorFlood {
 public:
  void run(const OffsetExterior& exterior, std::vector<ExteriorNode>& nodes);

 private:
  DisjointSets parts_;  ///< of the nodes' centres
};

}  // namespace shapegauge
