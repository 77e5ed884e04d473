// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/descriptors/descriptor.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/fields/proxy_source.h"
#include "shapegauge/retrieval/descriptors/bag_of_features.h"
#include "shapegauge/retrieval/descriptors/d2.h"
#include "shapegauge/retrieval/descriptors/geodesic_spectrum.h"
#include "shapegauge/retrieval/descriptors/joint_histogram.h"
#include "shapegauge/retrieval/descriptors/light_field.h"
#include "shapegauge/retrieval/descriptors/panorama.h"
#include "shapegauge/retrieval/descriptors/shape_dna.h"
#include "shapegauge/retrieval/descriptors/spherical_harmonics.h"
#include "shapegauge/retrieval/descriptors/surflet_pairs.h"

namespace shapegauge {

namespace {

std::vector<Descriptor> builtin_descriptors() {
  return {
      joint_histogram_descriptor(),
      bag_of_features_descriptor(),
      light_field_descriptor(),
      d2_descriptor(),
      spherical_harmonics_descriptor(),
      shape_dna_descriptor(),
      panorama_descriptor(),
      geodesic_spectrum_descriptor(),
      surflet_pairs_descriptor(),
  };
}

void check_descriptor(const Descriptor& added) {
  const auto reserved = [](const Parameter& parameter) {
    return parameter.name == "type" || parameter.name == "fields" || parameter.name == "axes";
  };
  if (added.max_fields < added.min_fields) {
    throw ArgumentError(fmt::format("the descriptor \"{}\" has max_fields below its min_fields", added.name));
  }
  if (std::ranges::any_of(added.parameters, reserved)) {
    throw ArgumentError(fmt::format(
        "a parameter of the descriptor \"{}\" is called type, fields or axes, which are reserved", added.name));
  }
}

}  // namespace

Eigen::VectorXf call_with_proxy(const DescriptorInput& input, const std::function<Eigen::VectorXf(ProxySource&)>& use) {
  if (input.proxy != nullptr) return use(*input.proxy);
  ProxySource proxy(input.shape);
  return use(proxy);
}

Registry<Descriptor>& descriptors() {
  static Registry<Descriptor> all("descriptor", builtin_descriptors(),
                                  has_functions<&Descriptor::describe, &Descriptor::distance>, check_descriptor);
  return all;
}

bool needs_learning(const Descriptor& one, const DescriptorSettings& settings) {
  return one.learn != nullptr && (one.learns == nullptr || one.learns(settings));
}

Eigen::VectorXf compute_features(const Descriptor& by, const DescriptorInput& input, const LearntFeatures& learnt,
                                 const DescriptorSettings& settings) {
  Eigen::VectorXf features = by.describe(input, learnt, settings);
  if (features.size() == 0 || !features.allFinite()) {
    throw InputError(
        fmt::format("the descriptor {} returned no features, or some that are not finite numbers", by.name));
  }
  return features;
}

DistanceMatrix descriptor_distances(const Descriptor& of, const Signatures& features) {
  for (Eigen::Index i = 0; i < features.rows(); ++i) {
    if (features.row(i).allFinite()) continue;
    throw InputError(fmt::format("the features of shape {} (counted from 0) are not all finite numbers", i));
  }
  return distance_matrix(features, NamedDistance{.name = std::string(of.name), .function = of.distance});
}

std::vector<std::string> feature_distance_names() {
  std::vector<std::string> names = distances().names();
  std::ranges::move(descriptors().names(), std::back_inserter(names));
  return names;
}

NamedDistance feature_distance(const std::string& name) {
  if (const Descriptor* const known = descriptors().find(name)) return {.name = name, .function = known->distance};
  return distances().at(name);
}

DistanceMatrix feature_distances(const std::string& name, const Signatures& features) {
  const Descriptor* const known = descriptors().find(name);
  return known != nullptr ? descriptor_distances(*known, features) : distance_matrix(features, name);
}

}  // namespace shapegauge
