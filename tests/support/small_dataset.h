// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge::test {

/// Returns a mesh of the class `name`: "capsule", "sphere" or "box". Size and proportions vary slightly with `number`,
/// the index of the model within its class.
Shape small_shape(const std::string& name, int number);

/// Writes a data set to a folder: models T0.off to T8.off, three of each class of small_shape(), and their classes in
/// test.cla.
void write_small_dataset(const std::filesystem::path& folder);

/// Replaces a model's file by a point cloud of its vertices, for which no conventional SDF is defined.
void replace_by_cloud(const std::filesystem::path& model);

/// Returns the contents of test.cla, the classification of the data set of write_small_dataset().
std::string small_classification();

/// Returns the configuration of a run on the data set of write_small_dataset() in `folder`: histograms of the cone SDF
/// with a fixed, a per-shape and a data set range, and the first two concatenated; protocols psb and paper.
nlohmann::json small_configuration(const std::filesystem::path& folder);

}  // namespace shapegauge::test
