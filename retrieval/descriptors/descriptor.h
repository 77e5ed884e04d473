#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/base/registry.h"
#include "shapegauge/core/fields/proxy_source.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/retrieval/distances.h"

namespace shapegauge {

/// The settings of a descriptor.
struct DescriptorSettings {
  ParameterValues values;             ///< of Descriptor::parameters
  std::vector<ParameterValues> axes;  ///< of Descriptor::axis_parameters, one for each field
};

/// What a descriptor is computed from.
struct DescriptorInput {
  const Shape& shape;                   ///< prepared, of unit area
  std::span<const ScalarField> fields;  ///< at the same samples; none where the descriptor takes none
  ProxySource* proxy = nullptr;         ///< of the shape, shared with its fields and other descriptors; nullptr: none
};

/// Calls use(ProxySource&) with the input's proxy or, where it has none, with a new one.
template <typename Use>
auto on_proxy(const DescriptorInput& input, Use use) {
  if (input.proxy != nullptr) return use(*input.proxy);
  ProxySource own(input.shape);
  return use(own);
}

/// What a descriptor must know of the whole data set before it can describe a shape: a codebook, for example. Empty for
/// most.
using LearntFeatures = Eigen::MatrixXf;

/// A descriptor: from a shape, or fields on it, to features of a length that only the settings decide, and the distance
/// between two such. Functions throw InputError for settings out of range and for what cannot
/// be described. Names, parameters and descriptions are referred to, not copied.
struct Descriptor {
  std::string_view name;
  std::string_view description;                     ///< one sentence
  std::span<const Parameter> parameters;            ///< not called type, fields or axes
  std::span<const Parameter> axis_parameters = {};  ///< of each field
  std::size_t fewest_fields = 0;
  std::size_t most_fields = 0;
  int version = 1;  ///< raised with every change of a feature or a distance: caches give none of the old ones then
  Eigen::VectorXf (*describe)(const DescriptorInput&, const LearntFeatures&, const DescriptorSettings&) = nullptr;
  DistanceFunction distance = nullptr;
  /// What is learnt from all shapes before; nullptr: nothing.
  LearntFeatures (*learn)(std::span<const DescriptorInput>, const DescriptorSettings&) = nullptr;
  /// Whether it learns with these settings; nullptr: always, where there is `learn`.
  bool (*learns)(const DescriptorSettings&) = nullptr;
  /// Throws InputError where settings contradict each other; nullptr: they cannot.
  void (*check)(const DescriptorSettings&) = nullptr;
};

/// All descriptors: those of this folder, one line each in descriptor.cpp (docs/developer/extending.md), then those
/// that were added. An entry has `describe` and `distance`, and no parameters called type, fields or axes.
Registry<Descriptor>& descriptors();

/// Whether the descriptor must see all shapes before it can describe one.
bool learns(const Descriptor& one, const DescriptorSettings& settings);

/// Computes the features of one shape; `learnt` is for descriptors that learn. Checks what `describe` returns: throws
/// InputError where there are no features or some are not finite, and what `describe` throws.
Eigen::VectorXf compute_features(const Descriptor& by, const DescriptorInput& input, const LearntFeatures& learnt,
                                 const DescriptorSettings& settings);

/// All distances between shapes with such features, one shape a row; in parallel, the same bytes for any number of
/// threads. Throws InputError for a feature that is not finite.
DistanceMatrix descriptor_distances(const Descriptor& of, const Signatures& features);

/// The names that feature_distance() understands: those of distances(), then of descriptors().
std::vector<std::string> feature_distance_names();

/// The distance of that name between features; by a descriptor's name that descriptor's own. Throws
/// InputError, naming those there are.
NamedDistance feature_distance(const std::string& name);

/// All distances between features, a row a model, by the distance of that name. Throws InputError as
/// feature_distance(), and for features that the distance does not take.
DistanceMatrix feature_distances(const std::string& name, const Signatures& features);

}  // namespace shapegauge
