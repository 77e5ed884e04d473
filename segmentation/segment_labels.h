#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/core/render/image.h"
#include "shapegauge/core/shape/distinct_triangles.h"
#include "shapegauge/segmentation/surface_graph.h"

namespace shapegauge {

/// The labels' numbers replaced by 0, 1, ... in the order in which they first occur.
std::vector<std::int32_t> renumbered(std::span<const std::int32_t> labels);

/// Extends labels of the distinct triangles to all triangles of their mesh: doubles have the label of their first.
/// Labels of a cloud stay as they are.
std::vector<std::int32_t> with_doubles(const DistinctTriangles& mesh, std::vector<std::int32_t> labels);

/// The connected parts of each label: nodes have the same number where links lead from one to the other within their
/// label. Numbers go from 0 on, in the order of the parts' first nodes. Throws ArgumentError where there is not
/// one label a node.
std::vector<std::int32_t> connected_parts(const SurfaceGraph& graph, std::span<const std::int32_t> labels);

/// A colour for each node by its label, such that neighbouring labels differ as far as a dozen colours can: labels are
/// coloured one after the other, the largest first, each in a colour that no neighbour has, as far as possible in one
/// of its own. Throws as connected_parts().
std::vector<Colour> label_colours(const SurfaceGraph& graph, std::span<const std::int32_t> labels);

}  // namespace shapegauge
