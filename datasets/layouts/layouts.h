// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/registry.h"
#include "shapegauge/datasets/layouts/dataset.h"

namespace shapegauge {

/// Names of the splits of a data set: valid values of DatasetLocation::split.
inline constexpr std::array<std::string_view, 4> dataset_splits{"all", "train", "val", "test"};

/// Registry entry of a layout, which defines where a data set's folder has its models and their classes.
struct DatasetLayout {
  std::string_view name;           ///< name of the layout in options, such as "folders"
  std::string_view description{};  ///< short phrase that names the files and what defines the classes
  Dataset (*find)(const DatasetLocation&) = nullptr;  ///< finds the data set at a location; required
  std::string_view default_classification{};          ///< name of the default classification file; empty for none
  bool has_splits = false;                            ///< true if DatasetLocation::split selects models
  bool has_classification = true;  ///< true if a file may define the classes; else file and folder names do
  /// Returns true if a folder has this layout. If null, a folder with the default classification file has it.
  bool (*recognises)(const std::filesystem::path& root) = nullptr;
};

/// Returns the registry of layouts: the built-in layouts, followed by added ones. An entry must have `find`.
Registry<DatasetLayout>& dataset_layouts();

/// Finds the data set at a location. Throws InputError for an absent or invalid folder or classification, and for a
/// data set without models.
Dataset find_dataset(const DatasetLocation& location);

/// Returns true if a file name is that of a table of models (layout "csv"): .csv or .tsv, ignoring case.
bool is_model_table(const std::filesystem::path& path);

/// Detects the layout of a data set from its folder: the first layout that recognises it, otherwise "folders". With a
/// classification, the layout is "csv" for a table, else "psb" if the folder has that layout, else "shrec11". Throws
/// InputError if the folder is absent.
DatasetLocation recognise_dataset(const std::filesystem::path& root, const std::filesystem::path& classification = {});

/// Error message about a model without a usable shape file.
struct ModelFailure {
  std::size_t model = 0;  ///< index of the model in Dataset::models
  std::string message;    ///< reason, with the path of the file
};

/// Checks that the file of every model exists and begins like a shape. Returns the failures in the order of the models.
std::vector<ModelFailure> check_models(const Dataset& dataset);

}  // namespace shapegauge
