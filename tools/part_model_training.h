#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/segmentation/part_model.h"
#include "shapegauge/segmentation/regions.h"

namespace shapegauge {

/// Two regions met while merging, and what people say of them.
struct PartExample {
  RegionFeatures features;
  double together = 0;  ///< the share of pairs of nodes, one in each, that people put into one part
  double weight = 0;    ///< in training
};

/// What people say of the first regions of a surface: over all of their segmentations, the mean number of pairs of
/// nodes, one in each of two regions, that are in the same segment. `segmentations[k][i]` is the segment of node i,
/// `patch[i]` its region. Symmetric; on the diagonal pairs of a region's own nodes are counted once for each order.
Eigen::MatrixXd pairs_together(std::span<const std::int32_t> patch, std::int32_t regions,
                               const std::vector<std::vector<std::int32_t>>& segmentations);

/// The pairs of regions that merging compares, with what people say of them: merging by what people say or, where there
/// is a model, by the model, until no pair has an affinity of 0.3. The weight of an example is the root of its number
/// of pairs of nodes; a surface's weights sum to 1.
std::vector<PartExample> part_examples(Regions regions, const Eigen::MatrixXd& together, const PartModel* model);

/// How a model is trained.
struct TrainingOptions {
  int hidden_units = 8;  ///< of each network
  int networks = 3;      ///< trained from different starts; the model is their mean (of log odds)
  int epochs = 4;        ///< passes over the examples
  double decay = 3e-4;   ///< weight of half of the sum of squared weights
  double rate = 0.01;    ///< of learning at the start; it falls to 0 as a cosine
  std::uint64_t seed = 1;
};

/// The model of least cross entropy with the examples: by Adam (Kingma and Ba 2015) in batches of 256. The same input
/// gives the same model. Throws ArgumentError for no examples and options that are not positive.
PartModel train_part_model(const std::vector<PartExample>& examples, const TrainingOptions& options);

}  // namespace shapegauge
