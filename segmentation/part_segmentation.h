// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/segmentation/boundary_smoothing.h"
#include "shapegauge/segmentation/part_model.h"
#include "shapegauge/segmentation/thick_surface.h"

namespace shapegauge {

/// Cache version of part_segmentation(); increment when results change (docs/manual/cache.md).
inline constexpr int part_segmentation_version = 6;

/// Options of part_segmentation().
struct PartSegmentationOptions {
  int parts = 0;                         ///< number of parts; 0 for automatic
  int patches = 300;                     ///< number of initial patches; at least three per requested part are used
  int samples = 1000;                    ///< number of surface samples between which visibility is tested, at least 1
  double min_probability = 0.25;         ///< regions are merged if they are one part with at least this probability
  BoundarySmoothingOptions smoothing{};  ///< options of the final smoothing of borders
  std::uint64_t seed = 1;                ///< seed of the random node at which the first patch starts
};

/// Names, bounds and help texts of the parameters in PartSegmentationOptions (option_parameters.h).
inline constexpr std::array part_segmentation_table = {
    option_of<&PartSegmentationOptions::parts>("parts", {.low = 0, .high = 1'000'000},
                                               "Number of parts; 0 for automatic."),
    option_of<&PartSegmentationOptions::patches>("patches", {.low = 1, .high = 100'000},
                                                 "Number of initial patches, which are merged into parts."),
    option_of<&PartSegmentationOptions::min_probability>(
        "min_probability", {.low = 0, .high = 1},
        "Minimum probability of merging two regions; lower gives fewer parts."),
    nested_option<&PartSegmentationOptions::smoothing, boundary_smoothing_table, 0>(),
};

/// Segments a shape into parts as people would: returns a part number for each triangle, or point of a cloud, from 0 on
/// in the order of the parts' first triangles.
///
/// A triangle with coincident corners gets the part of the closest other triangle; a duplicate triangle gets the part
/// of its first copy (sound_mesh()). Meshes of few triangles or with many cracks are replaced by their
/// segmentation_proxy(). The surface is divided into patches, which are merged into regions. Each step merges the two
/// regions most likely to belong to one part, according to `model`. Patches of less than a tenth of the mean area
/// join their neighbours first. The features (RegionFeatures) describe mutual visibility, thickness, the concavity
/// between regions and their form. Finally, borders are smoothed. Parts are connected except for pieces that smoothing
/// separates. Unconnected components are different parts, and there may therefore be more parts than requested. The
/// same input gives the same labels on any number of threads.
///
/// Throws InputError for options out of range, more parts than triangles or points, and as thick_surface() does.
std::vector<std::int32_t> part_segmentation(const Shape& shape, const PartSegmentationOptions& options,
                                            const PartModel& model = trained_part_model());

/// Segments a surface of known thickness: returns a part number per node of its graph, from 0 on. Throws InputError for
/// options out of range and for more parts than nodes.
std::vector<std::int32_t> part_segmentation(const ThickSurface& surface, const PartSegmentationOptions& options,
                                            const PartModel& model = trained_part_model());

}  // namespace shapegauge
