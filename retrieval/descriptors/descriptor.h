// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/base/registry.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/retrieval/distances.h"

namespace shapegauge {

class ProxySource;

/// Parameter values of a descriptor.
struct DescriptorSettings {
  ParameterValues values;             ///< values of the descriptor's parameters
  std::vector<ParameterValues> axes;  ///< per field: values of Descriptor::axis_parameters, such as the bins
};

/// Shape to be described, with its fields and surface proxy.
struct DescriptorInput {
  const Shape& shape;                   ///< prepared shape of unit area
  std::span<const ScalarField> fields;  ///< scalar fields at the same samples; empty for a descriptor without them
  ProxySource* proxy = nullptr;  ///< proxy of the shape, shared with its fields and other descriptors; null: none yet
};

/// Returns use(proxy) for the input's proxy, or for a new proxy of the shape if the input has none.
Eigen::VectorXf call_with_proxy(const DescriptorInput& input, const std::function<Eigen::VectorXf(ProxySource&)>& use);

/// Features learnt from the whole data set before shapes are described, such as a codebook. Empty for descriptors that
/// learn nothing.
using LearntFeatures = Eigen::MatrixXf;

/// Descriptor: a function from a shape, or fields on it, to features whose length depends only on the settings, and a
/// distance between features. Functions throw InputError for settings out of range and for shapes that cannot be
/// described. Names, parameters and descriptions must outlive the Descriptor; they are not copied.
struct Descriptor {
  std::string_view name;                  ///< name of the descriptor in configurations and commands
  std::string_view description;           ///< description in one sentence
  std::span<const Parameter> parameters;  ///< parameters of the descriptor; none is called type, fields or axes
  std::span<const Parameter> axis_parameters = {};  ///< parameters with a value per field, such as its bins
  std::size_t min_fields = 0;                       ///< minimum number of scalar fields that the descriptor uses
  std::size_t max_fields = 0;                       ///< maximum number of scalar fields that the descriptor uses
  int version = 1;  ///< cache version; increment when features or distances change (docs/manual/cache.md)
  /// Computes the features of one shape; required.
  Eigen::VectorXf (*describe)(const DescriptorInput&, const LearntFeatures&, const DescriptorSettings&) = nullptr;
  DistanceFunction distance = nullptr;  ///< distance between the features of two shapes; required
  /// Learns from all shapes before they are described; null if nothing is learnt.
  LearntFeatures (*learn)(std::span<const DescriptorInput>, const DescriptorSettings&) = nullptr;
  /// Returns true if the settings require learning. Null if all settings do, or `learn` is null.
  bool (*learns)(const DescriptorSettings&) = nullptr;
  /// Throws InputError if parameter values contradict each other; null if they cannot.
  void (*check)(const DescriptorSettings&) = nullptr;
};

/// Returns the registry of descriptors: those of the library (descriptor.cpp), followed by those that callers add
/// (docs/developer/extending.md). An entry must have `describe` and `distance`, and no parameters called type, fields
/// or axes.
Registry<Descriptor>& descriptors();

/// Returns true if the descriptor must learn from all shapes before it can describe one.
bool needs_learning(const Descriptor& descriptor, const DescriptorSettings& settings);

/// Computes the features of one shape and validates them; `learnt` is the result of the descriptor's `learn`, or empty.
/// Throws InputError if there are no features or some are not finite, and as `describe` does.
Eigen::VectorXf compute_features(const Descriptor& descriptor, const DescriptorInput& input,
                                 const LearntFeatures& learnt, const DescriptorSettings& settings);

/// Computes all pairwise distances of features, one shape per row, by the descriptor's distance. Parallel, with the
/// same bytes for any number of threads. Throws InputError for a feature that is not finite.
DistanceMatrix descriptor_distances(const Descriptor& descriptor, const Signatures& features);

/// Returns the names that feature_distance() accepts: those of distances(), followed by those of descriptors().
std::vector<std::string> feature_distance_names();

/// Returns a distance between features by its name, or by the name of the descriptor that defines it. Throws InputError
/// for an unknown name; the message lists the known ones.
NamedDistance feature_distance(const std::string& name);

/// Computes all pairwise distances of features, one model per row, by the feature_distance() called `name`. Throws
/// InputError as feature_distance() does, and for features outside the distance's domain.
DistanceMatrix feature_distances(const std::string& name, const Signatures& features);

}  // namespace shapegauge
