// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// Options of a bag of features and its codebook.
struct BagOfFeaturesOptions {
  int words = 80;       ///< number of words (cluster centres) in the codebook; 80 as in Chen et al. 2018
  bool soft = false;    ///< assign each sample to all words with Gaussian weights, not only to the nearest word
  double softness = 1;  ///< standard deviation of the Gaussian, in mean distances of a word to the nearest other word
  bool standardise = false;      ///< divide each field's values by their standard deviation over the data set
  int samples_per_shape = 1000;  ///< number of samples per shape for learning the codebook
  int iterations = 50;           ///< maximum number of k-means iterations
  int seed = 1;                  ///< seed of k-means
};

/// Codebook of a bag of features: words (cluster centres) in the space of the fields' values.
struct Codebook {
  Eigen::RowVectorXf scales;  ///< divisor of each field's values; 1 unless standardised
  Eigen::MatrixXf words;      ///< scaled field values of the words: words x fields
};

/// Fields of one shape, all at the same samples.
using ShapeFields = std::span<const ScalarField>;

/// Learns a codebook by k-means (Lloyd's algorithm with k-means++ seeding; Arthur and Vassilvitskii 2007) from a fixed
/// number of samples of each shape, stratified by weight. Samples with a value that is not finite are ignored. The same
/// bytes for any number of threads. Returns fewer words if there are fewer distinct samples. Throws InputError for
/// options out of range, and ArgumentError for fields that differ in number or length and if no sample is valid.
Codebook codebook(std::span<const ShapeFields> shapes, const BagOfFeaturesOptions& options = {});

/// Computes the share of a shape's sample weight that is assigned to each word, normalised to sum 1 (Sivic and
/// Zisserman 2003; soft assignment: van Gemert et al. 2008). Compared by L1. Throws as codebook() does.
Eigen::VectorXf bag_of_features(ShapeFields fields, const Codebook& codebook, const BagOfFeaturesOptions& options = {});

/// Returns the entry "bag_of_features" of the registry descriptors().
Descriptor bag_of_features_descriptor();

}  // namespace shapegauge
