// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge::test {

/// A capsule, sphere or box, by class ("capsule", "sphere", "box"), whose size and proportions vary slightly with the
/// number.
Shape small_shape(const std::string& name, int number);

/// Writes 9 models T0.off to T8.off, three of each class of small_shape, and test.cla.
void write_small_dataset(const std::filesystem::path& folder);

/// Replaces a model by a point cloud, of which there is no conventional SDF.
void make_cloud(const std::filesystem::path& model);

/// The .cla file of that data set.
std::string small_classification();

/// A configuration for that data set: the cone SDF with a fixed, a per-shape and a data set's range, and the first two
/// concatenated; both protocols.
nlohmann::json small_configuration(const std::filesystem::path& folder);

}  // namespace shapegauge::test
