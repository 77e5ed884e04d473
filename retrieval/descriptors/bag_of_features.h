#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// To be raised with every change of codebook() or bag_of_features() that changes a value.
inline constexpr int bag_of_features_version = 1;

/// Settings of a bag of features and its codebook.
struct BagOfFeaturesOptions {
  int words = 80;                ///< of the codebook, as in the paper's concatenation
  bool soft = false;             ///< count a sample for all words by Gaussian weights, not for the nearest only
  double softness = 1;           ///< the Gaussian's width, in mean distances of a word from the nearest other
  bool standardise = false;      ///< divide each field by its standard deviation over the data set
  int samples_per_shape = 1000;  ///< from which the codebook is learnt
  int iterations = 50;           ///< of k-means at most
  int seed = 1;                  ///< of the random numbers that seed it
};

/// The words that the values of several fields are sorted by.
struct Codebook {
  Eigen::RowVectorXf scales;  ///< by field: what values are divided by
  Eigen::MatrixXf words;      ///< one a row
};

/// Fields of one shape, at the same samples.
using ShapeFields = std::span<const ScalarField>;

/// k-means (Lloyd's algorithm from a k-means++ seed; Arthur and Vassilvitskii 2007) over samples of all shapes, so many
/// of each, spread by weight. Samples with a value that is not finite do not count. The same bytes for any number of
/// threads. There are fewer words where there are fewer different samples. Throws InputError for options out of range,
/// and ArgumentError for fields that differ in number or length and where no sample counts.
Codebook codebook(std::span<const ShapeFields> shapes, const BagOfFeaturesOptions& options = {});

/// How much of a shape's weight belongs to each word, normalised to sum 1 (Sivic and Zisserman 2003; soft: van Gemert
/// et al. 2008). Compared by L1. Throws as codebook().
Eigen::VectorXf bag_of_features(ShapeFields fields, const Codebook& codebook, const BagOfFeaturesOptions& options = {});

Descriptor bag_of_features_descriptor();

}  // namespace shapegauge
