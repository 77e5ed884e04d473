#include "shapegauge/experiments/results/diagnostics_json.h"

namespace shapegauge {

nlohmann::ordered_json diagnostics_json(const ShapeDiagnostics& diagnostics) {
  const bool bounded = diagnostics.boundary_length > 0;  // then the diagonal is as well
  return {{"closed", diagnostics.closed},
          {"vertices", diagnostics.vertices},
          {"unreferenced_vertices", diagnostics.unreferenced_vertices},
          {"coincident_vertices", diagnostics.coincident_vertices},
          {"diagonal", diagnostics.diagonal},
          {"triangles", diagnostics.triangles},
          {"area", diagnostics.area},
          {"degenerate_triangles", diagnostics.degenerate_triangles},
          {"duplicate_triangles", diagnostics.duplicate_triangles},
          {"components", diagnostics.components},
          {"edges", diagnostics.edges},
          {"boundary_edges", diagnostics.boundary_edges},
          {"boundary_length", diagnostics.boundary_length},
          {"boundary_fraction", bounded ? diagnostics.boundary_length / diagnostics.diagonal : 0},
          {"non_manifold_edges", diagnostics.non_manifold_edges},
          {"inconsistent_edges", diagnostics.inconsistent_edges}};
}

}  // namespace shapegauge
