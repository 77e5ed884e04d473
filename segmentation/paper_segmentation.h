// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/segmentation/patches.h"
#include "shapegauge/segmentation/surface_graph.h"

namespace shapegauge {

struct OffsetSdfOutcomes;

/// Cache version of paper_segmentation(); see docs/manual/cache.md.
inline constexpr int paper_segmentation_version = 5;

/// Options of the paper's pipeline. The paper gives the number of patches, 50, and leaves the rest open.
struct PaperSegmentationOptions {
  PatchOptions patches{};
  int clusters = 5;       ///< of patches, at least 1
  double smoothness = 1;  ///< weight of cuts relative to clusters; at least 0
};

/// Segments a surface as in the paper (Section "Shape segmentation"). The steps are: over-segmentation into patches,
/// feature vectors of patches from the distribution of fields such as the SDF (patch_features()), soft clustering by a
/// Gaussian mixture, a graph cut, and connected components of each cluster. `fields` are sampled at the graph's nodes.
/// Labels are numbered as by connected_parts(). Parts of less than a tenth of the mean area of patches join their
/// neighbours.
///
/// The graph cut is an alpha-expansion over patches. A patch in a cluster costs minus the logarithm of its probability.
/// Two adjacent patches in different clusters cost `smoothness` times the sum over their common border of length times
/// -log(|turn| / pi), divided by the mean border length between patches. Convex turns count a tenth, as in the edge
/// weights of Shapira et al. 2008. Throws InputError for options out of range, and as patch_features() does.
std::vector<std::int32_t> paper_segmentation(const SurfaceGraph& graph, std::span<const ScalarField> fields,
                                             const PaperSegmentationOptions& options);

/// Segments a shape by its SDF: one label per triangle or point. `offset` is that of the offset surface,
/// as a fraction of the diagonal; without it, uses the conventional SDF, for meshes only. `outcomes`, if any, receives
/// those of the offset SDF. Throws InputError also as sound_mesh(), offset_sdf() and cone_sdf() do.
std::vector<std::int32_t> paper_segmentation(const Shape& shape, std::optional<double> offset,
                                             const PaperSegmentationOptions& options = {},
                                             OffsetSdfOutcomes* outcomes = nullptr);

}  // namespace shapegauge
