#include "shapegauge/retrieval/descriptors/descriptor.h"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/retrieval/descriptors/bag_of_features.h"
#include "shapegauge/retrieval/descriptors/d2.h"
#include "shapegauge/retrieval/descriptors/geodesic_spectrum.h"
#include "shapegauge/retrieval/descriptors/joint_histogram.h"
#include "shapegauge/retrieval/descriptors/light_field.h"
#include "shapegauge/retrieval/descriptors/shape_dna.h"
#include "shapegauge/retrieval/descriptors/spherical_harmonics.h"

namespace shapegauge {

namespace {

std::vector<Descriptor>& registry() {
  static std::vector<Descriptor> registered = {
      joint_histogram_descriptor(),     bag_of_features_descriptor(), light_field_descriptor(),       d2_descriptor(),
      spherical_harmonics_descriptor(), shape_dna_descriptor(),       geodesic_spectrum_descriptor(),
  };
  return registered;
}

}  // namespace

std::span<const Descriptor> descriptors() { return registry(); }

void register_descriptor(const Descriptor& added) {
  const auto reserved = [](const Parameter& parameter) {
    return parameter.name == "type" || parameter.name == "fields" || parameter.name == "axes";
  };
  const bool known = std::ranges::find(registry(), added.name, &Descriptor::name) != registry().end();
  if (added.name.empty() || known || added.describe == nullptr || added.distance == nullptr ||
      added.most_fields < added.fewest_fields || std::ranges::any_of(added.parameters, reserved)) {
    throw std::invalid_argument(fmt::format(
        "a descriptor needs a name of its own, functions, at least as many fields at most as at fewest, and parameters "
        "that are not called type, fields or axes: \"{}\"",
        added.name));
  }
  registry().push_back(added);
}

bool learns(const Descriptor& one, const DescriptorSettings& settings) {
  return one.learn != nullptr && (one.learns == nullptr || one.learns(settings));
}

DescriptorSettings default_settings(const Descriptor& of, std::size_t fields) {
  return {.values = ParameterValues(of.parameters),
          .axes = std::vector<ParameterValues>(fields, ParameterValues(of.axis_parameters))};
}

Eigen::VectorXf compute_features(const Descriptor& by, const DescriptorInput& input, const LearntFeatures& learnt,
                                 const DescriptorSettings& settings) {
  Eigen::VectorXf features = by.describe(input, learnt, settings);
  if (features.size() == 0 || !features.allFinite()) {
    throw InputError(fmt::format("the features of the descriptor {} are not finite numbers", by.name));
  }
  return features;
}

const Descriptor& descriptor(std::string_view name) {
  const auto known = descriptors();
  const auto found = std::ranges::find(known, name, &Descriptor::name);
  if (found != known.end()) return *found;
  std::string message = fmt::format("there is no descriptor named \"{}\"; known are:", name);
  for (const Descriptor& one : known) message.append(" ").append(one.name);
  throw InputError(message);
}

DistanceMatrix descriptor_distances(const Descriptor& of, const Signatures& features) {
  for (Eigen::Index i = 0; i < features.rows(); ++i) {
    if (features.row(i).allFinite()) continue;
    throw InputError(fmt::format("the features of shape {} (counted from 0) are not all finite numbers", i));
  }
  const auto row = [&](Eigen::Index i) {
    return std::span(features.data() + i * features.cols(), static_cast<std::size_t>(features.cols()));
  };
  DistanceMatrix matrix = DistanceMatrix::Zero(features.rows(), features.rows());
  parallel_for(Eigen::Index{0}, features.rows(), [&](Eigen::Index i) {
    for (Eigen::Index j = i + 1; j < features.rows(); ++j) matrix(i, j) = matrix(j, i) = of.distance(row(i), row(j));
  });
  return matrix;
}

std::vector<std::string> feature_distance_names() {
  std::vector<std::string> names = distance_names();
  for (const Descriptor& one : descriptors()) names.emplace_back(one.name);
  return names;
}

NamedDistance feature_distance(const std::string& name) {
  const auto known = descriptors();
  const auto found = std::ranges::find(known, name, &Descriptor::name);
  if (found == known.end()) return distance_named(name);
  return {.name = name, .function = found->distance};
}

}  // namespace shapegauge
