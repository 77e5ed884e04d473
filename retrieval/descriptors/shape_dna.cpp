#include "shapegauge/retrieval/descriptors/shape_dna.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/fields/laplacian.h"
#include "shapegauge/retrieval/distances.h"

namespace shapegauge {

namespace {

constexpr std::array table = {
    option_of<&ShapeDnaOptions::eigenvalues>("eigenvalues", {.low = 1, .high = 1000},
                                             "Positive eigenvalues, from the least on."),
    option_of<&ShapeDnaOptions::divide_by_rank>("divide_by_rank", "Whether the k-th is divided by k."),
};
constexpr auto parameters = parameters_of(table);

}  // namespace

Eigen::VectorXf shape_dna(const Shape& mesh, const ShapeDnaOptions& options) {
  check_options("shape_dna", table, options);
  require_usable(mesh);
  const double area = surface_area(mesh);
  const Spectrum spectrum = laplacian_spectrum(mesh, options.eigenvalues + 1);
  Eigen::VectorXf features = Eigen::VectorXf::Zero(options.eigenvalues);
  for (Eigen::Index k = 0; k + spectrum.components < spectrum.eigenvalues.size(); ++k) {
    const double by_area = spectrum.eigenvalues[k + spectrum.components] * area / (4 * std::numbers::pi);
    features[k] = static_cast<float>(options.divide_by_rank ? by_area / static_cast<double>(k + 1) : by_area);
  }
  return features;
}

Descriptor shape_dna_descriptor() {
  return {.name = "shape_dna",
          .description = "The first eigenvalues of the surface's Laplacian (Reuter, Wolter, Peinecke 2006).",
          .parameters = parameters,
          .version = shape_dna_version,
          .describe =
              [](const DescriptorInput& input, const LearntFeatures&, const DescriptorSettings& settings) {
                return shape_dna(input.shape, options_from(table, settings.values));
              },
          .distance = l2_distance};
}

}  // namespace shapegauge
