// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/point_cloud.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/promises.h"
#include "tests/fuzz/soup_from_bytes.h"

namespace shapegauge::fuzz {

namespace {

bool offset_sdf_is_measured(const Measurement& of, const Samples& samples) {
  return is_accepted("", [&] {
    const OffsetSdfResult result = offset_sdf(of.shape, samples, {.offset = of.offset, .parallel = false});
    promise(result.values.size() == samples.points.rows(), "every sample has an offset SDF");
    promise(result.normals.allFinite(), "normals are finite");
    for (Eigen::Index i = 0; i < result.values.size(); ++i) {
      promise(result.values[i] >= 0 ||
                  (std::isnan(result.values[i]) && samples.weights[i] == 0 && result.outcomes.missing > 0),
              "an offset SDF is not negative, and missing only off the surface");
    }
    promise(result.outcomes.total == static_cast<std::size_t>(samples.points.rows()), "every sample is counted");
  });
}

bool cone_sdf_is_measured(const Measurement& of, const Samples& samples) {
  return is_accepted("", [&] {
    const ConeSdfResult result = cone_sdf(of.shape, samples, {.rays = 7, .parallel = false});
    for (const double value : result.values) {
      promise(std::isnan(value) || (std::isfinite(value) && value >= 0), "a conventional SDF is NaN or from 0 up");
    }
  });
}

}  // namespace

bool shape_sdf(std::string_view bytes) {
  const Measurement measurement = measurement_from_bytes(bytes);
  Samples samples;
  const bool usable = is_accepted("", [&] {
    is_closed(measurement.shape);
    samples = sample_shape(measurement.shape, measurement.site);
  });
  if (!usable) return false;
  promise(samples.points.allFinite() && samples.normals.allFinite(), "samples are finite");
  promise((samples.weights.array() >= 0).all(), "areas are not negative");
  is_accepted("", [&] {
    const Shape scaled = prepare_shape(measurement.shape, {}).shape;
    if (is_cloud(scaled)) {
      // Where neighbours are equally far, rounding decides which of them the estimate takes, and scaling rounds.
      promise(point_weights(scaled.vertices).sum() > 0, "a cloud of unit area has an area");
    } else {
      promise(std::abs(surface_area(scaled) - 1) < 1e-9, "a unit area is 1");
    }
  });
  const bool cone = cone_sdf_is_measured(measurement, samples);
  return offset_sdf_is_measured(measurement, samples) || cone;
}

}  // namespace shapegauge::fuzz
