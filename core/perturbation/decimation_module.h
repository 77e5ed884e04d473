#pragma once

// QuadricT.hh does not include what it needs.
// clang-format off
#include <OpenMesh/Core/Utils/vector_traits.hh>
#include <OpenMesh/Core/Geometry/QuadricT.hh>
// clang-format on
#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <string>
#include <vector>

#include "shapegauge/core/perturbation/decimation_mesh.h"

namespace shapegauge {

/// Says how good a collapse is: the quadric error (Garland and Heckbert 1997) of the faces' planes, weighted by area,
/// and of planes that stand on open edges, which OpenMesh's own module lets erode; illegal where a face would turn over
/// or become a sliver.
class DecimationModule : public OpenMesh::Decimater::ModBaseT<DecimationMesh> {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<DecimationModule>;

  explicit DecimationModule(DecimationMesh& mesh) : ModBaseT(mesh, false) {}

  [[nodiscard]] const std::string& name() const override;
  void initialize() override;
  float collapse_priority(const CollapseInfo& collapse) override;
  void postprocess_collapse(const CollapseInfo& collapse) override;

 private:
  [[nodiscard]] bool keeps_faces(const CollapseInfo& collapse);

  std::vector<OpenMesh::Geometry::Quadricd> quadrics_;  ///< by vertex
};

}  // namespace shapegauge
