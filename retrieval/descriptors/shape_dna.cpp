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
                                             "Number of positive eigenvalues, smallest first."),
    option_of<&ShapeDnaOptions::divide_by_rank>("divide_by_rank", "Divide the k-th eigenvalue by k."),
};
constexpr std::array<std::string_view, 2> surfaces{"mesh", "proxy"};

constexpr auto parameters = [] {
  constexpr auto options = parameters_of(table);
  return std::array{options[0], options[1],
                    Parameter{.name = "on",
                              .kind = ParameterKind::choice,
                              .default_value = surfaces[0],
                              .choices = surfaces,
                              .description = "mesh: the mesh's own Laplacian; proxy: that of the surface proxy, for "
                                             "damaged meshes and clouds too."}};
}();

Eigen::VectorXf features_of(const Spectrum& spectrum, double area, const ShapeDnaOptions& options) {
  Eigen::VectorXf features = Eigen::VectorXf::Zero(options.eigenvalues);
  const Eigen::Index known = std::min<Eigen::Index>(features.size(), spectrum.eigenvalues.size() - spectrum.components);
  for (Eigen::Index k = 0; k < known; ++k) {
    const double by_area = spectrum.eigenvalues[k + spectrum.components] * area / (4 * std::numbers::pi);
    features[k] = static_cast<float>(options.divide_by_rank ? by_area / static_cast<double>(k + 1) : by_area);
  }
  return features;
}

}  // namespace

Eigen::VectorXf shape_dna(const Shape& mesh, const ShapeDnaOptions& options) {
  check_options("shape_dna", table, options);
  require_usable(mesh);
  return features_of(laplacian_spectrum(mesh, options.eigenvalues + 1), surface_area(mesh), options);
}

Eigen::VectorXf shape_dna_on_proxy(ProxySource& source, const ShapeDnaOptions& options) {
  check_options("shape_dna", table, options);
  return features_of(source.spectrum(options.eigenvalues + 1), source.proxy().areas.sum(), options);
}

Descriptor shape_dna_descriptor() {
  return {.name = "shape_dna",
          .description = "The first eigenvalues of the surface's Laplacian (Reuter, Wolter, Peinecke 2006).",
          .parameters = parameters,
          .version = version_on_proxy(shape_dna_version),
          .describe =
              [](const DescriptorInput& input, const LearntFeatures&, const DescriptorSettings& settings) {
                const ShapeDnaOptions options = options_from(table, settings.values);
                if (settings.values.word("on") == "mesh") return shape_dna(input.shape, options);
                return on_proxy(input, [&](ProxySource& source) { return shape_dna_on_proxy(source, options); });
              },
          .distance = l2_distance};
}

}  // namespace shapegauge
