#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/segmentation/gaussian_mixture.h"
#include "shapegauge/segmentation/patches.h"
#include "shapegauge/segmentation/surface_graph.h"

namespace shapegauge {

/// To be raised with every change of paper_segmentation() that changes a label: what a cache holds of earlier versions
/// is then computed anew.
inline constexpr int paper_segmentation_version = 4;

/// How the paper's pipeline is run. The paper gives the number of patches, 50, and leaves the rest open.
struct PaperSegmentationOptions {
  PatchOptions patches{};
  int levels = 16;                          ///< of each field's distribution on a patch, at least 1
  MixtureOptions mixture{.components = 5};  ///< clusters of patches
  double smoothness = 1;                    ///< of cuts against clusters; at least 0
};

/// Cuts a surface as the paper does (Section "Shape segmentation"): over-segmentation into patches, a feature vector of
/// each from the distribution of fields on it (the SDF), a Gaussian mixture for the probability of each patch in each
/// cluster, graph cuts, and the connected parts of each cluster. `fields` are sampled at the graph's nodes; results are
/// numbered as those of connected_parts().
///
/// The graph cut is an alpha-expansion over patches: a patch in a cluster costs minus the logarithm of its probability;
/// two neighbouring patches in different clusters cost, times `smoothness`, the sum over their common border of length
/// times -log(|turn| / pi) where it is concave, a tenth of that turn where it is convex, divided by the mean length of
/// borders between patches: as Shapira et al. 2008 weigh edges. Throws InputError for options out of range, and as
/// patch_features().
std::vector<std::int32_t> paper_segmentation(const SurfaceGraph& graph, std::span<const ScalarField> fields,
                                             const PaperSegmentationOptions& options);

/// The same of a shape and its SDF, a label for each triangle, or for each point of a cloud. `offset`: of the offset
/// surface, a fraction of the diagonal; none: the conventional SDF, which takes meshes only. Doubled triangles have the
/// label of their first. Throws InputError also as offset_sdf() and cone_sdf().
std::vector<std::int32_t> paper_segmentation(const Shape& shape, std::optional<double> offset,
                                             const PaperSegmentationOptions& options = {});

}  // namespace shapegauge
