// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/core/render/image.h"
#include "shapegauge/segmentation/surface_graph.h"

namespace shapegauge {

/// Renumbers labels as 0, 1, ... in order of first appearance; equal labels stay equal.
std::vector<std::int32_t> renumber_labels(std::span<const std::int32_t> labels);

/// Computes the connected components of each label: two nodes have the same component number if a path of nodes with
/// their label connects them. Components are numbered from 0 on in the order of their first nodes. Throws ArgumentError
/// unless there is one label per node.
std::vector<std::int32_t> connected_parts(const SurfaceGraph& graph, std::span<const std::int32_t> labels);

/// Merges each label whose area is less than `min_share` of the whole area into the adjacent label with the longest
/// common border, by increasing area (ties: the lowest label). Labels without adjacent ones stay. Returns one label
/// per node, not renumbered. Labels must be at least 0. Throws as connected_parts() does.
std::vector<std::int32_t> without_slivers(const SurfaceGraph& graph, std::span<const std::int32_t> labels,
                                          double min_share);

/// Assigns a colour to each node by its label, such that adjacent labels differ as far as a dozen colours permit.
/// Labels are coloured greedily, largest first, preferring unused colours and then colours that no neighbour has.
/// Throws as connected_parts() does.
std::vector<Colour> label_colours(const SurfaceGraph& graph, std::span<const std::int32_t> labels);

/// Returns the colours that label_colours() assigns, indexed by label.
std::vector<Colour> colour_of_each_label(const SurfaceGraph& graph, std::span<const std::int32_t> labels);

}  // namespace shapegauge
