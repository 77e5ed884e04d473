// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/tools/part_model_training.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <numeric>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/segmentation/region_merging.h"

namespace shapegauge {

namespace {

constexpr double examples_end = 0.3;
constexpr std::size_t batch_size = 256;
constexpr float max_deviations = 4;

/// Tracks labels from human segmentations through merges of regions.
class PeoplesView {
 public:
  explicit PeoplesView(Eigen::MatrixXd together) : together_(std::move(together)) {}

  double share(const Regions& regions, std::int32_t a, std::int32_t b) {
    for (; followed_ < regions.merges().size(); ++followed_) {
      const auto [into, from] = regions.merges()[followed_];
      together_.col(into) += together_.col(from);
      together_.row(into) += together_.row(from);
    }
    return together_(a, b) / (regions.of(a).nodes * regions.of(b).nodes);
  }

 private:
  Eigen::MatrixXd together_;
  std::size_t followed_ = 0;
};

/// Parameters of one network: hidden weights by feature, hidden biases, output weights, output bias.
struct Network {
  Network(Eigen::Index hidden_units, RandomNumbers& random)
      : units(hidden_units), values(Eigen::VectorXf::Zero(hidden_units * (region_features + 2) + 1)) {
    const double input = std::sqrt(3.0 / region_features);
    const double output = std::sqrt(3.0 / static_cast<double>(units));
    for (Eigen::Index i = 0; i < units * region_features; ++i) {
      values[i] = static_cast<float>(random.uniform(-input, input));
    }
    for (Eigen::Index i = units * (region_features + 1); i < values.size() - 1; ++i) {
      values[i] = static_cast<float>(random.uniform(-output, output));
    }
  }

  auto hidden(Eigen::VectorXf& of) const {
    return Eigen::Map<Eigen::MatrixXf>(of.data(), units, Eigen::Index{region_features});
  }
  auto bias(Eigen::VectorXf& of) const { return of.segment(units * region_features, units); }
  auto output(Eigen::VectorXf& of) const { return of.segment(units * (region_features + 1), units); }

  Eigen::Index units;
  Eigen::VectorXf values;
};

/// Examples with standardised features, one a column.
struct TrainingSet {
  Eigen::MatrixXf features;
  Eigen::VectorXf together;
  Eigen::VectorXf weights;  ///< of mean 1
};

/// Computes the gradient of the mean cross entropy of a batch, and of the weight decay.
Eigen::VectorXf gradient_of(Network& network, const TrainingSet& set, std::span<const Eigen::Index> batch,
                            float decay) {
  const std::vector<Eigen::Index> chosen(batch.begin(), batch.end());
  const Eigen::MatrixXf x = set.features(Eigen::all, chosen);
  const auto output = network.output(network.values);
  const Eigen::MatrixXf units =
      ((network.hidden(network.values) * x).colwise() + network.bias(network.values)).array().tanh();
  const Eigen::ArrayXf odds = (units.transpose() * output).array() + network.values[network.values.size() - 1];
  const Eigen::VectorXf residuals = set.weights(chosen).array() *
                                    (1 / (1 + (-odds).exp()) - set.together(chosen).array()) /
                                    static_cast<float>(batch.size());
  const Eigen::MatrixXf back = (output * residuals.transpose()).array() * (1 - units.array().square());
  Eigen::VectorXf gradient(network.values.size());
  network.hidden(gradient) = back * x.transpose() + decay * network.hidden(network.values);
  network.bias(gradient) = back.rowwise().sum();
  network.output(gradient) = units * residuals + decay * output;
  gradient[gradient.size() - 1] = residuals.sum();
  return gradient;
}

/// Moments of Adam.
class Adam {
 public:
  explicit Adam(Eigen::Index size) : mean_(Eigen::VectorXf::Zero(size)), square_(Eigen::VectorXf::Zero(size)) {}

  void step(Eigen::VectorXf& values, const Eigen::VectorXf& gradient, float rate) {
    constexpr float keep_mean = 0.9F;
    constexpr float keep_square = 0.999F;
    constexpr float least = 1e-8F;
    ++steps_;
    mean_ = keep_mean * mean_ + (1 - keep_mean) * gradient;
    square_ = keep_square * square_.array() + (1 - keep_square) * gradient.array().square();
    const float mean_scale = 1 / (1 - std::pow(keep_mean, static_cast<float>(steps_)));
    const float square_scale = 1 / (1 - std::pow(keep_square, static_cast<float>(steps_)));
    values.array() -= rate * mean_scale * mean_.array() / ((square_scale * square_.array()).sqrt() + least);
  }

 private:
  Eigen::VectorXf mean_;
  Eigen::VectorXf square_;
  int steps_ = 0;
};

Network trained(const TrainingSet& set, const TrainingOptions& options, int number) {
  RandomNumbers random(options.seed, static_cast<std::uint64_t>(number));
  Network network(options.hidden_units, random);
  Adam adam(network.values.size());
  std::vector<Eigen::Index> order(static_cast<std::size_t>(set.together.size()));
  std::iota(order.begin(), order.end(), 0);
  const std::size_t batches = (order.size() + batch_size - 1) / batch_size;
  const auto steps = static_cast<double>(batches) * options.epochs;
  double step = 0;
  for (int epoch = 0; epoch < options.epochs; ++epoch) {
    for (std::size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[random.below(i + 1)]);
    for (std::size_t begin = 0; begin < order.size(); begin += batch_size) {
      const auto batch = std::span(order).subspan(begin, std::min(batch_size, order.size() - begin));
      const double rate = options.rate * (1 + std::cos(std::numbers::pi * ++step / steps)) / 2;
      adam.step(network.values, gradient_of(network, set, batch, static_cast<float>(options.decay)),
                static_cast<float>(rate));
    }
  }
  return network;
}

/// Stores means and deviations of the features in the model and returns the standardised examples.
TrainingSet standardised(const std::vector<PartExample>& examples, PartModel& model) {
  const auto count = static_cast<double>(examples.size());
  model.mean.setZero();
  for (const PartExample& example : examples) model.mean += example.features / count;
  RegionFeatures variance = RegionFeatures::Zero();
  double weight = 0;
  for (const PartExample& example : examples) {
    variance += (example.features - model.mean).cwiseAbs2() / count;
    weight += example.weight / count;
  }
  model.deviation = variance.cwiseSqrt().unaryExpr([](double d) { return d > 0 ? d : 1.0; });
  TrainingSet set;
  const auto columns = static_cast<Eigen::Index>(examples.size());
  set.features.resize(region_features, columns);
  set.together.resize(columns);
  set.weights.resize(columns);
  for (Eigen::Index i = 0; i < columns; ++i) {
    const PartExample& example = examples[static_cast<std::size_t>(i)];
    const RegionFeatures x = (example.features - model.mean).array() / model.deviation.array();
    set.features.col(i) = x.cast<float>().cwiseMax(-max_deviations).cwiseMin(max_deviations);
    set.together[i] = static_cast<float>(example.together);
    set.weights[i] = static_cast<float>(example.weight / weight);
  }
  return set;
}

}  // namespace

Eigen::MatrixXd pairs_together(std::span<const std::int32_t> patch, std::int32_t regions,
                               const std::vector<std::vector<std::int32_t>>& segmentations) {
  Eigen::MatrixXd together = Eigen::MatrixXd::Zero(regions, regions);
  for (const std::vector<std::int32_t>& segments : segmentations) {
    if (segments.size() != patch.size()) throw ArgumentError("a segmentation needs one segment a node");
    std::map<std::int32_t, Eigen::Index> columns;
    for (const std::int32_t segment : segments) columns.emplace(segment, std::ssize(columns));
    Eigen::MatrixXd counts = Eigen::MatrixXd::Zero(regions, std::ssize(columns));
    for (std::size_t i = 0; i < patch.size(); ++i) counts(patch[i], columns[segments[i]]) += 1;
    together += counts * counts.transpose() / static_cast<double>(segmentations.size());
  }
  for (const std::int32_t p : patch) together(p, p) -= 1;
  return together;
}

std::vector<PartExample> part_examples(Regions regions, const Eigen::MatrixXd& together, const PartModel* model) {
  std::vector<PartExample> examples;
  PeoplesView people(together);
  const auto affinity = [&](const Regions& now, std::int32_t a, std::int32_t b) {
    PartExample example;
    example.features = features_of(now, a, b);
    example.together = people.share(now, a, b);
    example.weight = std::sqrt(now.of(a).nodes * now.of(b).nodes);
    examples.push_back(example);
    return model != nullptr ? model->probability(example.features) : example.together;
  };
  merge_regions(regions, affinity, {.min_affinity = examples_end});
  double sum = 0;
  for (const PartExample& example : examples) sum += example.weight;
  for (PartExample& example : examples) example.weight /= sum;
  return examples;
}

PartModel train_part_model(const std::vector<PartExample>& examples, const TrainingOptions& options) {
  if (examples.empty()) throw ArgumentError("training needs examples");
  if (options.hidden_units < 1 || options.networks < 1 || options.epochs < 1 || !(options.rate > 0)) {
    throw ArgumentError("the options of training must be positive");
  }
  PartModel model;
  const TrainingSet set = standardised(examples, model);
  const Eigen::Index units = options.hidden_units;
  const Eigen::Index all = units * options.networks;
  model.hidden.resize(all, region_features);
  model.hidden_bias.resize(all);
  model.output.resize(all);
  for (int number = 0; number < options.networks; ++number) {
    Network network = trained(set, options, number);
    model.hidden.middleRows(number * units, units) = network.hidden(network.values).cast<double>();
    model.hidden_bias.segment(number * units, units) = network.bias(network.values).cast<double>();
    model.output.segment(number * units, units) = network.output(network.values).cast<double>() / options.networks;
    model.output_bias += static_cast<double>(network.values[network.values.size() - 1]) / options.networks;
  }
  return model;
}

}  // namespace shapegauge
