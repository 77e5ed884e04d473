#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/core/render/image.h"
#include "shapegauge/core/shape/distinct_triangles.h"
#include "shapegauge/segmentation/surface_graph.h"

namespace shapegauge {

/// Renumbers labels 0, 1, ... in order of first appearance.
std::vector<std::int32_t> renumbered(std::span<const std::int32_t> labels);

/// Extends labels of the distinct triangles to all triangles of their mesh: duplicates have the label of their first.
/// Returns labels of a cloud unchanged.
std::vector<std::int32_t> with_duplicates(const DistinctTriangles& mesh, std::vector<std::int32_t> labels);

/// Computes the connected components of each label: nodes have the same number if a path within their label connects
/// them. Components are numbered from 0 on in the order of their first nodes. Throws ArgumentError unless there is one
/// label a node.
std::vector<std::int32_t> connected_parts(const SurfaceGraph& graph, std::span<const std::int32_t> labels);

/// Assigns a colour to each node by its label, such that adjacent labels differ as far as a dozen colours permit.
/// Labels are coloured greedily, largest first, preferring unused colours and then colours that no neighbour has.
/// Throws as connected_parts() does.
std::vector<Colour> label_colours(const SurfaceGraph& graph, std::span<const std::int32_t> labels);

}  // namespace shapegauge
