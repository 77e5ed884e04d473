// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/segmentation/part_segmentation.h"

namespace shapegauge {

/// Segmentation algorithm: `best` is part_segmentation(), `paper` is paper_segmentation().
enum class SegmentationAlgorithm { best, paper };
template <>
inline constexpr std::array<std::string_view, 2> words_of<SegmentationAlgorithm>{"best", "paper"};

/// Shape diameter function that paper_segmentation() clusters: of the offset surface, or the conventional one by cones.
enum class SegmentedSdf { offset, cone };
template <>
inline constexpr std::array<std::string_view, 2> words_of<SegmentedSdf>{"offset_sdf", "cone_sdf"};

/// Options of segment_shape().
struct SegmentationOptions {
  SegmentationAlgorithm method = SegmentationAlgorithm::best;  ///< segmentation algorithm
  PartSegmentationOptions best{};  ///< options of part_segmentation(); paper_segmentation() uses only `parts`
  SegmentedSdf field = SegmentedSdf::offset;  ///< SDF that paper_segmentation() clusters
  double offset = OffsetSdfOptions{}.offset;  ///< offset distance for paper_segmentation(), in bounding-box diagonals
};

/// Names, bounds and help texts of the parameters in SegmentationOptions (option_parameters.h).
inline constexpr std::array segmentation_table = {
    option_of<&SegmentationOptions::method>(
        "method", "Algorithm. best: semantic parts, such as limbs; paper: clusters of patches of similar thickness."),
    with_description(
        "With method best: number of parts, or 0 for automatic; with paper: number of clusters, or 0 for 5.",
        nested_option<&SegmentationOptions::best, part_segmentation_table, 0>()),
    with_description("With method best: number of initial patches to merge into parts.",
                     nested_option<&SegmentationOptions::best, part_segmentation_table, 1>()),
    with_description(
        "With method best and parts 0: minimum predicted probability that two merged regions are one part; "
        "lower values give fewer parts.",
        nested_option<&SegmentationOptions::best, part_segmentation_table, 2>()),
    with_description("With method best: maximum shift of part borders by smoothing.",
                     nested_option<&SegmentationOptions::best, part_segmentation_table, 3>()),
    option_of<&SegmentationOptions::field>(
        "field",
        "With method paper: field to cluster, the shape diameter function of the offset surface or of ray cones."),
    with_unit(bounding_box_diagonals, option_of<&SegmentationOptions::offset>("offset", OffsetSdfOptions::offset_bounds,
                                                                              "With method paper: offset distance.")),
};

/// Returns the only algorithm that uses the named parameter of segmentation_table; nothing if both algorithms use it.
std::optional<SegmentationAlgorithm> algorithm_with(std::string_view parameter);

/// Segments a shape by the algorithm `options.method`: returns one label per triangle or point. `outcomes`, if not
/// null, receives the sample counts of the offset SDF if paper_segmentation() uses it. Throws InputError as the
/// algorithms do.
std::vector<std::int32_t> segment_shape(const Shape& shape, const SegmentationOptions& options,
                                        OffsetSdfOutcomes* outcomes = nullptr);

}  // namespace shapegauge
