// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/segmentation/part_segmentation.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <functional>
#include <numeric>
#include <span>

#include "shapegauge/core/base/error.h"
#include "shapegauge/segmentation/patches.h"
#include "shapegauge/segmentation/region_merging.h"
#include "shapegauge/segmentation/segment_labels.h"
#include "shapegauge/segmentation/segmentation_proxy.h"
#include "shapegauge/segmentation/sound_mesh.h"
#include "shapegauge/segmentation/surface_regions.h"

namespace shapegauge {

namespace {

constexpr int patches_per_part = 3;
constexpr Eigen::Index triangles_per_part = 20;

/// Maximum number of regions, unless more patches were requested: memory for pairs grows quadratically.
constexpr std::int32_t max_regions = 600;

void check(const PartSegmentationOptions& options, std::int32_t nodes) {
  check_options("segmentation into parts", part_segmentation_table, options);
  if (options.parts > nodes) {
    throw InputError(
        fmt::format("a shape of {} triangles or points cannot be segmented into {} parts", nodes, options.parts));
  }
  if (options.samples < 1)
    throw InputError(fmt::format("the number of samples must be at least 1, not {}", options.samples));
}

PatchOptions patch_options_of(const PartSegmentationOptions& options) {
  return {.count = std::max(options.patches, patches_per_part * options.parts), .seed = options.seed};
}

/// Merges parts smaller than a fraction of the mean area of patches into their neighbours.
std::vector<std::int32_t> without_small(const SurfaceGraph& graph, std::span<const std::int32_t> labels,
                                        const PartSegmentationOptions& options) {
  return renumber_labels(without_slivers(graph, labels, min_patch_fraction / patch_options_of(options).count));
}

/// Numbers the patches by decreasing area, or -1 beyond a maximum. Only components increase the number of patches;
/// these have no neighbours to merge with.
std::vector<std::int32_t> largest_patches(const SurfaceGraph& graph, std::span<const std::int32_t> patch,
                                          std::int32_t max_count) {
  std::vector<double> areas(static_cast<std::size_t>(*std::ranges::max_element(patch) + 1), 0);
  for (std::size_t i = 0; i < patch.size(); ++i) {
    areas[static_cast<std::size_t>(patch[i])] += graph.samples.weights[static_cast<Eigen::Index>(i)];
  }
  std::vector<std::int32_t> order(areas.size());
  std::iota(order.begin(), order.end(), 0);
  if (std::ssize(order) > max_count) {
    std::ranges::stable_sort(order, std::greater<>{},
                             [&](std::int32_t p) { return areas[static_cast<std::size_t>(p)]; });
  }
  std::vector<std::int32_t> numbers(order.size(), -1);
  for (std::int32_t k = 0; k < max_count && k < std::ssize(order); ++k) {
    numbers[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])] = k;
  }
  std::vector<std::int32_t> result;
  for (const std::int32_t p : patch) result.push_back(numbers[static_cast<std::size_t>(p)]);
  return result;
}

}  // namespace

std::vector<std::int32_t> part_segmentation(const ThickSurface& surface, const PartSegmentationOptions& options,
                                            const PartModel& model) {
  check(options, surface.graph.size());
  const PatchOptions patch_options = patch_options_of(options);
  const std::vector<std::int32_t> patch =
      without_small(surface.graph, patches(surface.graph, patch_options, patch_costs(surface)), options);
  const std::int32_t max_patches = std::max(max_regions, patch_options.count);
  const std::vector<std::int32_t> initial = largest_patches(surface.graph, patch, max_patches);
  Regions regions = surface_regions(surface, initial, options.samples);
  const auto probability = [&](const Regions& now, std::int32_t a, std::int32_t b) {
    return model.probability(features_of(now, a, b));
  };
  merge_regions(regions, probability, {.min_affinity = options.min_probability, .parts = options.parts});
  std::vector<std::int32_t> labels;
  for (std::size_t i = 0; i < patch.size(); ++i) {
    labels.push_back(initial[i] >= 0 ? regions.region_of(initial[i]) : max_patches + patch[i]);
  }
  return renumber_labels(smooth_boundaries(surface, renumber_labels(labels), options.smoothing));
}

std::vector<std::int32_t> part_segmentation(const Shape& original, const PartSegmentationOptions& options,
                                            const PartModel& model) {
  const SoundMesh mesh = sound_mesh(original);
  const Shape& shape = mesh.shape;
  // Many parts of few triangles consist of single triangles.
  if (triangles_per_part * options.parts > shape.triangles.rows()) {
    return mesh.extended(part_segmentation(thick_surface(shape), options, model));
  }
  const SegmentationProxy cut = segmentation_proxy(orient_outward(shape));
  const std::vector<std::int32_t> labels =
      renumber_labels(cut.transfer(part_segmentation(thick_surface(cut.shape), options, model)));
  return mesh.extended(options.parts > 0 ? labels : without_small(surface_graph(shape), labels, options));
}

}  // namespace shapegauge
