// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/descriptors/shape_dna.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/fields/laplacian.h"
#include "shapegauge/core/fields/proxy_source.h"
#include "shapegauge/retrieval/distances.h"

namespace shapegauge {

namespace {

constexpr std::array shape_dna_table = {
    option_of<&ShapeDnaOptions::eigenvalues>("eigenvalues", {.low = 1, .high = 1000},
                                             "Number of positive eigenvalues, smallest first."),
    option_of<&ShapeDnaOptions::divide_by_rank>("divide_by_rank",
                                                "Divide the k-th eigenvalue by k, to weight all similarly."),
};

struct ShapeDnaSettings {
  ShapeDnaOptions options = {};
  FieldSurface on = FieldSurface::mesh;
};

constexpr std::array settings_table = {
    nested_option<&ShapeDnaSettings::options, shape_dna_table, 0>(),
    nested_option<&ShapeDnaSettings::options, shape_dna_table, 1>(),
    option_of<&ShapeDnaSettings::on>("on",
                                     "Laplacian to use. mesh: of the mesh; proxy: of evenly spread surface points, "
                                     "also for damaged meshes and clouds."),
};
constexpr auto shape_dna_parameters = parameters_of(settings_table);

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
  check_options("shape_dna", shape_dna_table, options);
  require_usable(mesh);
  return features_of(laplacian_spectrum(mesh, options.eigenvalues + 1), surface_area(mesh), options);
}

Eigen::VectorXf shape_dna_on_proxy(ProxySource& source, const ShapeDnaOptions& options) {
  check_options("shape_dna", shape_dna_table, options);
  return features_of(source.spectrum(options.eigenvalues + 1), source.proxy().areas.sum(), options);
}

Descriptor shape_dna_descriptor() {
  return {.name = "shape_dna",
          .description = "Smallest eigenvalues of the surface's Laplacian (Reuter, Wolter, Peinecke 2006).",
          .parameters = shape_dna_parameters,
          .version = version_on_proxy(3),
          .describe =
              [](const DescriptorInput& input, const LearntFeatures&, const DescriptorSettings& settings) {
                const ShapeDnaSettings chosen = options_from(settings_table, settings.values);
                if (chosen.on == FieldSurface::mesh) return shape_dna(input.shape, chosen.options);
                return call_with_proxy(input,
                                       [&](ProxySource& source) { return shape_dna_on_proxy(source, chosen.options); });
              },
          .distance = l2_distance};
}

}  // namespace shapegauge
