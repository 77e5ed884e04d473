#include "shapegauge/segmentation/part_segmentation.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/segmentation/patches.h"
#include "shapegauge/segmentation/region_merging.h"
#include "shapegauge/segmentation/segment_labels.h"
#include "shapegauge/segmentation/surface_regions.h"

namespace shapegauge {

namespace {

constexpr int patches_per_part = 3;

void check(const PartSegmentationOptions& options, std::int32_t nodes) {
  if (options.parts < 0 || options.parts > nodes) {
    throw InputError(
        fmt::format("a shape of {} triangles or points cannot be cut into {} parts", nodes, options.parts));
  }
  if (options.samples < 1) throw InputError(fmt::format("at least 1 sample is needed, not {}", options.samples));
  if (!(options.least_probability >= 0 && options.least_probability <= 1)) {
    throw InputError(fmt::format("the least probability must be from 0 to 1, not {}", options.least_probability));
  }
}

}  // namespace

std::vector<std::int32_t> part_segmentation(const ThickSurface& surface, const PartSegmentationOptions& options,
                                            const PartModel& model) {
  check(options, surface.graph.size());
  const PatchOptions patch_options{.count = std::max(options.patches, patches_per_part * options.parts),
                                   .seed = options.seed};
  std::vector<std::int32_t> labels = patches(surface.graph, patch_options, patch_costs(surface));
  Regions regions = surface_regions(surface, labels, options.samples);
  const auto probability = [&](const Regions& now, std::int32_t a, std::int32_t b) {
    return model.probability(features_of(now, a, b));
  };
  merge_regions(regions, probability, {.least_affinity = options.least_probability, .parts = options.parts});
  for (std::int32_t& label : labels) label = regions.region_of(label);
  return renumbered(smoothed_boundaries(surface, renumbered(labels), options.smoothing));
}

std::vector<std::int32_t> part_segmentation(const Shape& shape, const PartSegmentationOptions& options,
                                            const PartModel& model) {
  return part_segmentation(thick_surface(shape), options, model);
}

}  // namespace shapegauge
