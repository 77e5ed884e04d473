// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/segmentation/part_model.h"
#include "shapegauge/segmentation/regions.h"

namespace shapegauge {

/// Pair of regions met while merging, with its label from human segmentations.
struct PartExample {
  RegionFeatures features;
  double together = 0;  ///< share of pairs of nodes, one in each, that people put into one part
  double weight = 0;    ///< training weight
};

/// Computes, for each pair of regions, the number of pairs of nodes, one in each, that are in the same segment,
/// averaged over all human segmentations. `segmentations[k][i]` is the segment of node i, `patch[i]` its region.
/// Symmetric; on the diagonal, pairs of a region's own nodes are counted once for each order.
Eigen::MatrixXd pairs_together(std::span<const std::int32_t> patch, std::int32_t regions,
                               const std::vector<std::vector<std::int32_t>>& segmentations);

/// Collects the pairs of regions that merging compares, with their labels. Merges by the labels or, if given, by the
/// model, until no pair has an affinity of 0.3. The weight of an example is the square root of its number of pairs of
/// nodes; a surface's weights sum to 1.
std::vector<PartExample> part_examples(Regions regions, const Eigen::MatrixXd& together, const PartModel* model);

/// Options of training.
struct TrainingOptions {
  int hidden_units = 8;  ///< hidden units of each network
  int networks = 3;      ///< networks with different initialisations; the model is their mean (of log odds)
  int epochs = 4;        ///< passes over the examples
  double decay = 3e-4;   ///< weight of half of the sum of squared weights
  double rate = 0.01;    ///< initial learning rate, decaying to 0 as a cosine
  std::uint64_t seed = 1;
};

/// Trains the model of least cross entropy on the examples with Adam (Kingma and Ba 2015) in batches of 256.
/// Deterministic. Throws ArgumentError without examples and for options that are not positive.
PartModel train_part_model(const std::vector<PartExample>& examples, const TrainingOptions& options);

}  // namespace shapegauge
