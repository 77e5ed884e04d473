// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/words.h"

namespace shapegauge {

/// Errors between two segmentations of the same surface, defined at segmentation_errors() and cut_discrepancy() (Chen,
/// Golovinskiy, Funkhouser: "A benchmark for 3D mesh segmentation", ACM Transactions on Graphics 28(3), 2009, section
/// 4). 0 for equal segmentations; all but the cut discrepancy are fractions from 0 to 1.
struct SegmentationErrors {
  double rand_index = 0;  ///< 1 - Rand index: share of pairs of triangles that share a segment in only one segmentation
  double hamming = 0;     ///< mean of missing_rate and false_alarm_rate
  double missing_rate = 0;      ///< share of the surface outside each true segment's largest overlap with a segment
  double false_alarm_rate = 0;  ///< missing_rate with the two segmentations exchanged
  /// Mean share of a triangle's segment outside its segment in the other segmentation; the smaller of both directions.
  double global_consistency = 0;
  /// Like global_consistency, but the mean over triangles of the smaller share of both directions.
  double local_consistency = 0;
  /// Mean distance of one segmentation's borders to the other's plus the reverse, in mean radii of the surface; NaN if
  /// undefined or not computed.
  double cut_discrepancy = 0;
};

/// Name, definition and member of SegmentationErrors of one segmentation error, for listings and reports.
struct SegmentationErrorEntry {
  std::string_view name;              ///< name of the error in tables and options
  std::string_view definition;        ///< definition of the error as a phrase
  double SegmentationErrors::*value;  ///< member with the value of the error
};

/// Returns the names and definitions of all segmentation errors, in the order of reports.
const std::array<SegmentationErrorEntry, 7>& segmentation_error_entries();

/// Computes the errors of a segmentation against a ground truth, except the cut discrepancy (NaN). labels[i] and
/// truth[i] are the segments of element i (a triangle), as arbitrary numbers. Elements count by their weights (areas),
/// or equally without weights. P and T are the segments of an element in the segmentation and in the truth; |.| are
/// weights.
/// - rand_index: share of pairs of elements, weighted by the product of their weights, that are together in one
///   segmentation and apart in the other (Rand 1971; one minus his index).
/// - missing_rate: sum over the truth's segments of |T| minus its largest overlap with any segment P, as a share of the
///   whole. false_alarm_rate: the same with the segmentations exchanged. hamming: their mean (Huang and Dom 1995).
/// - global_consistency: the smaller of the means over elements of |P \ T| / |P| and |T \ P| / |T|. local_consistency:
///   the mean of the smaller of the two (Martin et al. 2001). Both are 0 if one segmentation refines the other.
///
/// Takes O(n log n) time. With fewer than two elements of positive weight the Rand error is 0. Throws ArgumentError
/// without elements, for different numbers of labels, truth or weights, for a weight that is negative or not finite,
/// and without a positive weight.
SegmentationErrors segmentation_errors(std::span<const std::int32_t> labels, std::span<const std::int32_t> truth,
                                       std::span<const double> weights = {});

/// Weights of the triangles in segmentation errors: equal (faces), as in the tables of the benchmark of Chen et al.
/// 2009, or by area.
enum class TriangleWeights { faces, area };
template <>
inline constexpr std::array<std::string_view, 2> words_of<TriangleWeights>{"faces", "area"};

/// Edge of a mesh and its two adjacent triangles.
struct MeshEdge {
  std::array<std::int32_t, 2> vertices{};   ///< indices of the two end points
  std::array<std::int32_t, 2> triangles{};  ///< indices of triangles; the second is -1 at a boundary edge (not a cut)
  double length = 0;                        ///< length of the edge, finite and not negative
};

/// Computes the cut discrepancy: the mean distance of the first segmentation's cuts to the second's plus the mean
/// distance of the second's to the first's, divided by `radius`, the mean distance of the surface's points from their
/// centroid (Chen et al. 2009, section 4.1, after Huang and Dom 1995). A cut is an edge between triangles of different
/// segments; each of its vertices represents half of its length. Distances are shortest paths along edges. labels[i]
/// and truth[i] are the segments of triangle i; `vertices` is the number of vertices.
///
/// 0 if neither segmentation has cuts. NaN if only one has cuts, or if a cut has no path to any cut of the other
/// segmentation. Throws ArgumentError for different numbers of labels, an edge with a vertex or a triangle out of range
/// or a length that is negative or not finite, and a radius that is not positive.
double cut_discrepancy(std::span<const std::int32_t> labels, std::span<const std::int32_t> truth,
                       const std::vector<MeshEdge>& edges, std::int32_t vertices, double radius);

}  // namespace shapegauge
