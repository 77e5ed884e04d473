// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/segmentation/segment_shape.h"

#include <algorithm>

#include "shapegauge/segmentation/paper_segmentation.h"

namespace shapegauge {

std::optional<SegmentationAlgorithm> algorithm_with(std::string_view parameter) {
  constexpr std::array<std::string_view, 2> of_paper{"field", "offset"};
  constexpr std::array<std::string_view, 2> of_both{"method", "parts"};
  if (std::ranges::find(of_both, parameter) != of_both.end()) return std::nullopt;
  return std::ranges::find(of_paper, parameter) != of_paper.end() ? SegmentationAlgorithm::paper
                                                                  : SegmentationAlgorithm::best;
}

std::vector<std::int32_t> segment_shape(const Shape& shape, const SegmentationOptions& options,
                                        OffsetSdfOutcomes* outcomes) {
  if (options.method == SegmentationAlgorithm::best) return part_segmentation(shape, options.best);
  PaperSegmentationOptions paper;
  if (options.best.parts > 0) paper.clusters = options.best.parts;
  return paper_segmentation(shape, options.field == SegmentedSdf::offset ? std::optional(options.offset) : std::nullopt,
                            paper, outcomes);
}

}  // namespace shapegauge
