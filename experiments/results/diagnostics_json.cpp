#include "shapegauge/experiments/results/diagnostics_json.h"

namespace shapegauge {

nlohmann::ordered_json diagnostics_json(const ShapeDiagnostics& diagnostics) {
  // A length greater than 0 has a diagonal greater than 0 beside it.
  const auto fraction = [&](double length) { return length > 0 ? length / diagnostics.diagonal : 0; };
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
          {"boundary_fraction", fraction(diagnostics.boundary_length)},
          {"non_manifold_edges", diagnostics.non_manifold_edges},
          {"inconsistent_edges", diagnostics.inconsistent_edges},
          {"gap_size", diagnostics.gap_size},
          {"gap_fraction", fraction(diagnostics.gap_size)},
          {"point_spacing", diagnostics.point_spacing},
          {"noisy", diagnostics.noisy},
          {"noise_fraction", fraction(diagnostics.noise_deviation)}};
}

}  // namespace shapegauge
