#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace shapegauge {

/// To be raised with every change of a segmentation error's value: what a cache holds of earlier versions is then
/// computed anew.
inline constexpr int segmentation_errors_version = 1;

/// How far two segmentations of the same surface are apart (Chen, Golovinskiy, Funkhouser: "A benchmark for 3D mesh
/// segmentation", ACM Transactions on Graphics 28(3), 2009, section 4). 0 where they are the same; all but the cut
/// discrepancy are fractions from 0 to 1.
struct SegmentationErrors {
  double rand_index = 0;
  double hamming = 0;
  double missing_rate = 0;
  double false_alarm_rate = 0;
  double global_consistency = 0;
  double local_consistency = 0;
  double cut_discrepancy = 0;  ///< NaN where it is not defined, or was not asked for
};

/// One of the errors, as listings and reports call it.
struct SegmentationErrorEntry {
  std::string_view name;
  std::string_view definition;
  double SegmentationErrors::*value;
};

/// All of the errors, in the order of reports.
const std::array<SegmentationErrorEntry, 7>& segmentation_error_entries();

/// The errors of a segmentation against one that is taken for the truth, but for the cut discrepancy (NaN). labels[i]
/// and truth[i] are the segments of element i (a triangle); any numbers will do. An element counts as much as its
/// weight (its area), or all count alike where there are no weights. With P the segment of an element in one
/// segmentation, T in the other, |.| weights:
/// - rand_index: of all pairs of two elements, each counted by the product of their weights, the share that are
///   together in one segmentation and apart in the other (Rand 1971; one minus his index);
/// - missing_rate: the sum over the truth's segments of |T| less its largest overlap with any segment P, as a share of
///   the whole; false_alarm_rate: the same with the two exchanged; hamming: their mean (Huang and Dom 1995);
/// - global_consistency: the lesser of the means over elements of |P \ T| / |P| and of |T \ P| / |T|;
///   local_consistency: the mean of the lesser one (Martin et al. 2001). Both are 0 where one segmentation refines the
///   other.
///
/// The time grows with n log n, not with pairs. Where there are fewer than two elements of positive weight the Rand
/// error is 0. Throws ArgumentError: no elements, numbers of labels, truth or weights that differ, a weight
/// that is negative or not finite, or no positive one.
SegmentationErrors segmentation_errors(std::span<const std::int32_t> labels, std::span<const std::int32_t> truth,
                                       std::span<const double> weights = {});

/// An edge of a mesh, and the two triangles on its sides.
struct MeshEdge {
  std::array<std::int32_t, 2> vertices{};
  std::array<std::int32_t, 2> triangles{};  ///< the second is -1 at a boundary, which is not a cut
  double length = 0;
};

/// How far the cuts between segments are from each other: the mean distance of the first segmentation's cuts from the
/// second's plus that of the second's from the first's, divided by `radius`, the mean distance of the surface's points
/// from their centroid (Chen et al. 2009, section 4.1, after Huang and Dom 1995). A cut is an edge between triangles of
/// different segments; its vertices stand for half of its length each. Distances are the shortest ways along edges.
///
/// 0 where neither segmentation has cuts; NaN, not defined, where one of them has none, or no way leads from a cut to
/// the other's. Throws ArgumentError: numbers of labels that differ, an edge with a vertex or a triangle out of
/// range or a length that is negative or not finite, a radius that is not positive.
double cut_discrepancy(std::span<const std::int32_t> labels, std::span<const std::int32_t> truth,
                       const std::vector<MeshEdge>& edges, std::int32_t vertices, double radius);

}  // namespace shapegauge
