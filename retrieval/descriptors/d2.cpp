// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/descriptors/d2.h"

#include <algorithm>
#include <array>

#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/retrieval/l1_distance.h"

namespace shapegauge {

namespace {

constexpr std::array d2_table = {
    option_of<&D2Options::points>("points", {.low = 2, .high = 10'000},
                                  "Number of surface points; distances are measured between all pairs."),
    option_of<&D2Options::bins>("bins", {.low = 1, .high = 10'000}, "Number of bins of the distance histogram."),
    with_unit("mean pair distances",
              option_of<&D2Options::longest>("longest", {.low = 0.1, .high = 100},
                                             "Upper end of the histogram; larger distances count in the last bin.")),
};
constexpr auto d2_parameters = parameters_of(d2_table);

/// Calls visit(distance, weight) for each pair.
template <typename Visit>
void for_each_pair(const Samples& samples, Visit visit) {
  for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
    check_interruption();
    for (Eigen::Index j = i + 1; j < samples.points.rows(); ++j) {
      visit((samples.points.row(i) - samples.points.row(j)).norm(), samples.weights[i] * samples.weights[j]);
    }
  }
}

}  // namespace

Eigen::VectorXf d2(const Shape& shape, const D2Options& options) {
  check_options("d2", d2_table, options);
  const Samples samples = sample_surface(shape, options.points);
  double sum = 0;
  double total = 0;
  for_each_pair(samples, [&](double distance, double weight) {
    sum += weight * distance;
    total += weight;
  });
  if (!(sum > 0) || !(total > 0))
    throw InputError("the descriptor d2 needs a shape with extent; check it for coincident points");
  const double bins_per_unit = options.bins / options.longest * total / sum;
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(options.bins);
  for_each_pair(samples, [&](double distance, double weight) {
    const double position = std::min(distance * bins_per_unit, static_cast<double>(options.bins - 1));
    counts[static_cast<Eigen::Index>(position)] += weight;
  });
  return (counts / total).cast<float>();
}

Descriptor d2_descriptor() {
  return {.name = "d2",
          .description = "Shape distribution of the distances between points on the surface (Osada et al. 2002).",
          .parameters = d2_parameters,
          .version = 2,
          .describe =
              [](const DescriptorInput& input, const LearntFeatures&, const DescriptorSettings& settings) {
                return d2(input.shape, options_from(d2_table, settings.values));
              },
          .distance = l1_distance};
}

}  // namespace shapegauge
