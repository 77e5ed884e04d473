// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/descriptors/bag_of_features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/spatial/k_means_seeds.h"
#include "shapegauge/retrieval/l1_distance.h"

namespace shapegauge {

namespace {

constexpr std::array bag_of_features_table = {
    option_of<&BagOfFeaturesOptions::words>("words", {.low = 1, .high = 10'000},
                                            "Number of words (cluster centres) in the codebook."),
    option_of<&BagOfFeaturesOptions::soft>(
        "soft", "Assign samples to all words by Gaussian weights, instead of only to the nearest."),
    with_unit("mean nearest-neighbour distances of words",
              option_of<&BagOfFeaturesOptions::softness>(
                  "softness", {.low = 0.01, .high = 100},
                  "With soft: standard deviation of the Gaussian; larger values reach more words.")),
    option_of<&BagOfFeaturesOptions::standardise>("standardise",
                                                  "Divide each field by its standard deviation over the data set."),
    option_of<&BagOfFeaturesOptions::samples_per_shape>("samples_per_shape", {.low = 1, .high = 100'000},
                                                        "Number of samples per shape for learning the codebook."),
    option_of<&BagOfFeaturesOptions::iterations>("iterations", {.low = 1, .high = 10'000},
                                                 "Maximum number of k-means iterations."),
    option_of<&BagOfFeaturesOptions::seed>("seed", {.low = 0, .high = 2'147'483'647}, "Random seed of k-means."),
};
constexpr auto bag_of_features_parameters = parameters_of(bag_of_features_table);

using Vectors = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

void check_fields(ShapeFields fields, std::size_t expected) {
  if (fields.empty() || fields.size() != expected) {
    throw ArgumentError("a bag of features needs one field or more, as many for each shape; there are " +
                        std::to_string(fields.size()) + " and " + std::to_string(expected));
  }
  for (const ScalarField& field : fields) {
    if (field.values.size() != fields.front().values.size() || field.weights.size() != field.values.size()) {
      throw ArgumentError("the fields of a bag of features must be at the same samples; one has " +
                          std::to_string(field.values.size()) + " values and " + std::to_string(field.weights.size()) +
                          " weights, the first " + std::to_string(fields.front().values.size()) + " values");
    }
  }
}

/// Returns the fields' values at a sample; nothing for an invalid sample.
std::optional<Eigen::RowVectorXf> vector_at(ShapeFields fields, Eigen::Index sample) {
  const double weight = fields.front().weights[sample];
  if (!(weight > 0) || !std::isfinite(weight)) return std::nullopt;
  Eigen::RowVectorXf vector(std::ssize(fields));
  for (std::size_t k = 0; k < fields.size(); ++k) {
    vector[static_cast<Eigen::Index>(k)] = static_cast<float>(fields[k].values[sample]);
  }
  if (!vector.allFinite()) return std::nullopt;
  return vector;
}

/// Appends samples of a shape at equal steps of cumulative weight.
void append_samples(ShapeFields fields, int count, std::vector<Eigen::RowVectorXf>& samples) {
  double total = 0;
  for (Eigen::Index i = 0; i < fields.front().values.size(); ++i) {
    if (vector_at(fields, i)) total += fields.front().weights[i];
  }
  double passed = 0;
  int appended = 0;
  for (Eigen::Index i = 0; i < fields.front().values.size(); ++i) {
    const auto vector = vector_at(fields, i);
    if (!vector) continue;
    passed += fields.front().weights[i];
    for (; appended < count && (appended + 0.5) * total < passed * count; ++appended) samples.push_back(*vector);
  }
}

Vectors samples_of(std::span<const ShapeFields> shapes, int per_shape) {
  std::vector<Eigen::RowVectorXf> samples;
  for (const ShapeFields& fields : shapes) {
    check_fields(fields, shapes.front().size());
    append_samples(fields, per_shape, samples);
  }
  if (samples.empty())
    throw ArgumentError("a codebook needs fields with a value of positive weight, and there is none");
  Vectors matrix(std::ssize(samples), samples.front().size());
  for (std::size_t i = 0; i < samples.size(); ++i) matrix.row(static_cast<Eigen::Index>(i)) = samples[i];
  return matrix;
}

/// Returns standard deviations by column; 1 instead of 0.
Eigen::RowVectorXf deviations_of(const Vectors& samples) {
  const Eigen::MatrixXd values = samples.cast<double>();
  const Eigen::RowVectorXd mean = values.colwise().mean();
  const Eigen::RowVectorXd deviation = ((values.rowwise() - mean).colwise().squaredNorm() / values.rows()).cwiseSqrt();
  return (deviation.array() > 0).select(deviation, 1).cast<float>();
}

/// Chooses samples as initial words; fewer if there are fewer distinct samples.
Eigen::MatrixXf seed_words(const Vectors& samples, int count, RandomNumbers& random) {
  const auto squared_distances = [&](Eigen::Index from) -> Eigen::VectorXd {
    const Eigen::MatrixXf word = samples.row(from);
    return (samples.rowwise() - word.row(0)).rowwise().squaredNorm().cast<double>();
  };
  return samples(k_means_seeds(samples.rows(), count, random, squared_distances), Eigen::all);
}

/// Returns the squared distances from each word.
Eigen::VectorXf squared_distances(const Eigen::MatrixXf& words, const Eigen::RowVectorXf& vector) {
  Eigen::VectorXf sum = Eigen::VectorXf::Zero(words.rows());
  for (Eigen::Index k = 0; k < words.cols(); ++k) sum.array() += (words.col(k).array() - vector[k]).square();
  return sum;
}

Eigen::Index nearest_word(const Eigen::MatrixXf& words, const Eigen::RowVectorXf& vector) {
  Eigen::Index nearest = 0;
  squared_distances(words, vector).minCoeff(&nearest);
  return nearest;
}

/// Runs Lloyd's algorithm. A word without nearest samples stays.
void refine(Eigen::MatrixXf& words, const Vectors& samples, int iterations) {
  std::vector<Eigen::Index> nearest(static_cast<std::size_t>(samples.rows()), -1);
  for (int iteration = 0; iteration < iterations; ++iteration) {
    std::vector<Eigen::Index> now(nearest.size());
    parallel_for(Eigen::Index{0}, samples.rows(),
                 [&](Eigen::Index i) { now[static_cast<std::size_t>(i)] = nearest_word(words, samples.row(i)); });
    if (now == nearest) return;
    nearest = std::move(now);
    // In the samples' order, for the same result on any number of threads.
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(words.rows(), words.cols());
    Eigen::VectorXd counts = Eigen::VectorXd::Zero(words.rows());
    for (std::size_t i = 0; i < nearest.size(); ++i) {
      sums.row(nearest[i]) += samples.row(static_cast<Eigen::Index>(i)).cast<double>();
      ++counts[nearest[i]];
    }
    for (Eigen::Index k = 0; k < words.rows(); ++k) {
      if (counts[k] > 0) words.row(k) = (sums.row(k) / counts[k]).cast<float>();
    }
  }
}

/// Returns the mean distance of a word to its nearest neighbour; 1 for a single word.
float spacing_of(const Eigen::MatrixXf& words) {
  float sum = 0;
  for (Eigen::Index k = 0; k < words.rows(); ++k) {
    Eigen::VectorXf square = squared_distances(words, words.row(k));
    square[k] = std::numeric_limits<float>::infinity();
    sum += std::sqrt(square.minCoeff());
  }
  const float mean = sum / static_cast<float>(words.rows());
  return std::isfinite(mean) && mean > 0 ? mean : 1;
}

/// Returns the membership of a sample in each word.
Eigen::VectorXd memberships(const Eigen::MatrixXf& words, const Eigen::RowVectorXf& vector, double width) {
  const Eigen::ArrayXd square = squared_distances(words, vector).cast<double>();
  // Relative to the nearest, to avoid underflow far from all words.
  const Eigen::ArrayXd weights = (-(square - square[nearest_word(words, vector)]) / (2 * width * width)).exp();
  return weights / weights.sum();
}

/// Packs the codebook into one matrix, with the scales first.
LearntFeatures as_matrix(const Codebook& codebook) {
  LearntFeatures matrix(codebook.words.rows() + 1, codebook.words.cols());
  matrix << codebook.scales, codebook.words;
  return matrix;
}

Codebook as_codebook(const LearntFeatures& matrix) {
  if (matrix.rows() < 2) throw InputError("the descriptor bag_of_features has no codebook; learn it from shapes first");
  return {matrix.row(0), matrix.bottomRows(matrix.rows() - 1)};
}

}  // namespace

Codebook codebook(std::span<const ShapeFields> shapes, const BagOfFeaturesOptions& options) {
  check_options("bag_of_features", bag_of_features_table, options);
  if (shapes.empty()) throw ArgumentError("there are no shapes to learn a codebook from");
  Vectors samples = samples_of(shapes, options.samples_per_shape);
  Codebook result{Eigen::RowVectorXf::Ones(samples.cols()), {}};
  if (options.standardise) result.scales = deviations_of(samples);
  samples.array().rowwise() /= result.scales.array();
  RandomNumbers random(static_cast<std::uint64_t>(options.seed));
  result.words = seed_words(samples, options.words, random);
  refine(result.words, samples, options.iterations);
  return result;
}

Eigen::VectorXf bag_of_features(ShapeFields fields, const Codebook& codebook, const BagOfFeaturesOptions& options) {
  check_options("bag_of_features", bag_of_features_table, options);
  check_fields(fields, static_cast<std::size_t>(codebook.words.cols()));
  const double width = options.softness * spacing_of(codebook.words);
  Eigen::VectorXd bag = Eigen::VectorXd::Zero(codebook.words.rows());
  for (Eigen::Index i = 0; i < fields.front().values.size(); ++i) {
    const auto vector = vector_at(fields, i);
    if (!vector) continue;
    const Eigen::RowVectorXf scaled = vector->array() / codebook.scales.array();
    const double weight = fields.front().weights[i];
    if (options.soft) {
      bag += weight * memberships(codebook.words, scaled, width);
    } else {
      bag[nearest_word(codebook.words, scaled)] += weight;
    }
  }
  const double total = bag.sum();
  if (!(total > 0)) throw ArgumentError("a bag of features needs a value of positive weight, and the fields have none");
  Eigen::VectorXf features = Eigen::VectorXf::Zero(std::max<Eigen::Index>(options.words, bag.size()));
  features.head(bag.size()) = (bag / total).cast<float>();
  return features;
}

Descriptor bag_of_features_descriptor() {
  constexpr std::size_t max_fields = 1000;
  return {.name = "bag_of_features",
          .description =
              "Bag of features: area fraction of each word of a learnt codebook of field values (Sivic and Zisserman "
              "2003).",
          .parameters = bag_of_features_parameters,
          .min_fields = 1,
          .max_fields = max_fields,
          .version = 1,
          .describe =
              [](const DescriptorInput& input, const LearntFeatures& learnt, const DescriptorSettings& settings) {
                return bag_of_features(input.fields, as_codebook(learnt),
                                       options_from(bag_of_features_table, settings.values));
              },
          .distance = l1_distance,
          .learn =
              [](std::span<const DescriptorInput> shapes, const DescriptorSettings& settings) {
                std::vector<ShapeFields> fields;
                for (const DescriptorInput& shape : shapes) fields.push_back(shape.fields);
                return as_matrix(codebook(fields, options_from(bag_of_features_table, settings.values)));
              }};
}

}  // namespace shapegauge
