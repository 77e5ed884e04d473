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

/// Cache version of paper_segmentation(); increment when results change (docs/manual/cache.md).
inline constexpr int paper_segmentation_version = 5;

/// Options of paper_segmentation(). Chen et al. 2018 specify the number of patches, 50, and leave the rest open.
struct PaperSegmentationOptions {
  PatchOptions patches{};  ///< options of the over-segmentation
  int clusters = 5;        ///< number of clusters of patches, at least 1
  double smoothness = 1;   ///< weight of the border costs relative to the cluster costs, at least 0
};

/// Segments a surface as Chen et al. 2018 (Section "Shape segmentation") do: returns one label per node of the graph.
/// The steps are: over-segmentation into patches, feature vectors of patches from the distribution of fields such as
/// the SDF (patch_features()), soft clustering by a Gaussian mixture, a graph cut, and connected components of each
/// cluster. `fields` are sampled at the graph's nodes. Labels are numbered as by connected_parts(). Parts of less than
/// a tenth of the mean area of patches join their neighbours.
///
/// The graph cut is an alpha-expansion over patches. A patch in a cluster costs minus the logarithm of its probability.
/// Two adjacent patches in different clusters cost `smoothness` times the sum over their common border of length times
/// -log(|turn| / pi), divided by the mean border length between patches. The turn is the angle between the normals
/// across the border (SurfaceLink::concavity). Convex turns count a tenth, as in the edge weights of Shapira et al.
/// 2008. Throws InputError for options out of range, and as patch_features() does.
std::vector<std::int32_t> paper_segmentation(const SurfaceGraph& graph, std::span<const ScalarField> fields,
                                             const PaperSegmentationOptions& options);

/// Segments a shape by its SDF: returns one label per triangle or point. `offset` is the distance of the offset surface
/// from the shape, as a fraction of the bounding box's diagonal; without it, uses the conventional SDF, for meshes
/// only. `outcomes`, if not null, receives the sample counts of the offset SDF. Throws InputError also as sound_mesh(),
/// offset_sdf() and cone_sdf() do.
std::vector<std::int32_t> paper_segmentation(const Shape& shape, std::optional<double> offset,
                                             const PaperSegmentationOptions& options = {},
                                             OffsetSdfOutcomes* outcomes = nullptr);

}  // namespace shapegauge
