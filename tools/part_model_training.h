// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/segmentation/part_model.h"
#include "shapegauge/segmentation/regions.h"

namespace shapegauge {

/// Training example of a PartModel: a pair of adjacent regions of a surface that merging compares, with a label from
/// human segmentations.
struct PartExample {
  RegionFeatures features;  ///< features of the pair of regions (features_of())
  double together = 0;      ///< label: fraction of pairs of nodes, one per region, that people put into one part
  double weight = 0;        ///< weight of the example in the cross entropy that training minimises
};

/// Computes a matrix (regions x regions) of the number of pairs of nodes, one in each region, that are in the same
/// segment, averaged over all human segmentations. `segmentations[k][i]` is the segment of node i in segmentation k,
/// `patch[i]` the region of the node. Symmetric; the diagonal counts each pair of nodes of a region twice. Throws
/// ArgumentError for a segmentation with another number of nodes.
Eigen::MatrixXd pairs_together(std::span<const std::int32_t> patch, std::int32_t regions,
                               const std::vector<std::vector<std::int32_t>>& segmentations);

/// Merges the regions of a surface and returns each compared pair as a training example. `together` is the result of
/// pairs_together(). The affinity that guides merging is the label (PartExample::together) or, if `model` is not null,
/// the probability by the model; merging ends when all affinities are below 0.3. The weight of an example is the square
/// root of its number of pairs of nodes; the weights of a surface sum to 1.
std::vector<PartExample> part_examples(Regions regions, const Eigen::MatrixXd& together, const PartModel* model);

/// Options of train_part_model(): size of the model and parameters of the optimiser.
struct TrainingOptions {
  int hidden_units = 8;    ///< number of hidden units of each neural network
  int networks = 3;        ///< number of networks with different initialisations; the model averages their log odds
  int epochs = 4;          ///< number of passes over the training examples
  double decay = 3e-4;     ///< weight decay: factor of half the sum of squared network weights in the loss
  double rate = 0.01;      ///< initial learning rate of Adam, decaying to 0 as a cosine
  std::uint64_t seed = 1;  ///< seed of initialisation and of the order of examples
};

/// Trains a part model on the examples: minimises the weighted cross entropy by Adam (Kingma and Ba 2015) in batches of
/// 256. Deterministic. Throws ArgumentError without examples and for hidden_units, networks, epochs or a rate that are
/// not positive.
PartModel train_part_model(const std::vector<PartExample>& examples, const TrainingOptions& options);

}  // namespace shapegauge
