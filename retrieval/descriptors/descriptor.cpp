#include "shapegauge/retrieval/descriptors/descriptor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "shapegauge/retrieval/descriptors/bag_of_features.h"
#include "shapegauge/retrieval/descriptors/d2.h"
#include "shapegauge/retrieval/descriptors/joint_histogram.h"
#include "shapegauge/retrieval/descriptors/light_field.h"
#include "shapegauge/retrieval/descriptors/shape_dna.h"
#include "shapegauge/retrieval/descriptors/spherical_harmonics.h"

namespace shapegauge {

std::span<const Descriptor> descriptors() {
  static const std::array registered = {
      joint_histogram_descriptor(),     bag_of_features_descriptor(), light_field_descriptor(), d2_descriptor(),
      spherical_harmonics_descriptor(), shape_dna_descriptor(),
  };
  return registered;
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
  tbb::parallel_for(Eigen::Index{0}, features.rows(), [&](Eigen::Index i) {
    for (Eigen::Index j = i + 1; j < features.rows(); ++j) matrix(i, j) = matrix(j, i) = of.distance(row(i), row(j));
  });
  return matrix;
}

void require_allowed(std::string_view descriptor, const DescriptorParameter& parameter, double value) {
  const bool in_bounds = value >= parameter.lowest && value <= parameter.highest;
  if (in_bounds && (!parameter.whole || value == std::floor(value))) return;
  throw InputError(fmt::format("the descriptor {}: {} must be {}{} to {}, not {}", descriptor, parameter.name,
                               parameter.whole ? "a whole number, " : "", parameter.lowest, parameter.highest, value));
}

}  // namespace shapegauge
