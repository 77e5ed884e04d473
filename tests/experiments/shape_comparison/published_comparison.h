// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "shapegauge/core/io/formats.h"
#include "shapegauge/experiments/configuration/shape_comparison.h"
#include "shapegauge/experiments/engine/result_folder.h"
#include "shapegauge/experiments/shape_comparison/write_shape_comparison.h"
#include "tests/experiments/published_results.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge::test {

/// Writes a sphere of another scale and position than those of a prepared shape.
inline void write_sphere(const std::filesystem::path& path) {
  Shape sphere = test::sphere(10, 3);
  sphere.vertices.rowwise() += Eigen::RowVector3d(5, 0, 1);
  write_off(path, sphere);
}

/// Configuration that compares sphere.off with a copy under another name and with a noisy one.
inline nlohmann::json three_spheres() {
  return nlohmann::json::parse(R"({
    "name": "spheres",
    "shapes": [
      {"name": "noisy", "file": "sphere.off", "perturbations": [{"type": "vertex_noise", "amplitude": 0.01}]},
      {"name": "clean", "file": "sphere.off"},
      {"name": "again", "file": "sphere.off"}
    ],
    "reference": "clean",
    "signatures": [
      {"name": "offset", "field": {"type": "offset_sdf", "offset": 0.03},
       "histogram": {"bins": 10, "range": {"fixed": [0, 0.6]}}},
      {"name": "cone", "field": {"type": "cone_sdf"}, "histogram": {"bins": 10, "range": "dataset"}},
      {"name": "vertices", "field": {"type": "offset_sdf", "offset": 0.03, "at": "vertices"},
       "histogram": {"bins": 10, "range": "per-shape"}}
    ]})");
}

/// Publishes the results of a comparison.
inline RunOutcome publish(const std::filesystem::path& destination, const ShapeComparisonResults& results) {
  return publish_results(destination, to_json(results.comparison),
                         [&](const RunResults& to) { return write_shape_comparison(to, results); });
}

}  // namespace shapegauge::test
