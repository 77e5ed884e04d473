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

/// Values of DatasetLocation::split.
inline constexpr std::array<std::string_view, 4> dataset_splits{"all", "train", "val", "test"};

/// Layout of a data set in a folder.
struct DatasetLayout {
  std::string_view name;
  std::string_view description{};  ///< phrase: the files and where the classes are
  Dataset (*find)(const DatasetLocation&) = nullptr;
  std::string_view usual_classification{};  ///< default file next to the models with their classes; empty for none
  bool has_splits = false;                  ///< DatasetLocation::split selects models
  bool has_classification = true;           ///< a file may define the classes; otherwise names of files and folders do
  /// Returns true if a folder looks like this layout. Null: if the default classification is present.
  bool (*recognises)(const std::filesystem::path& root) = nullptr;
};

/// Returns the registry of layouts: those of layouts.cpp, followed by those added. An entry must have `find`.
Registry<DatasetLayout>& dataset_layouts();

/// Finds the data set at a location. Throws InputError for an absent or invalid folder or classification, and without
/// models.
Dataset find_dataset(const DatasetLocation& location);

/// Returns true for the name of a table of the layout "csv": .csv or .tsv, ignoring case.
bool is_model_table(const std::filesystem::path& path);

/// Detects the layout of a data set from its folder: the first layout that recognises it, otherwise folders. A given
/// classification is a table (csv) or, unless the folder has the layout psb, that of shrec11. Throws InputError if the
/// folder is absent.
DatasetLocation recognise_dataset(const std::filesystem::path& root, const std::filesystem::path& classification = {});

/// Fault of one model.
struct ModelFailure {
  std::size_t model = 0;  ///< index into Dataset::models
  std::string message;
};

/// Checks that the file of every model exists and begins like a shape. Returns the failures in order.
std::vector<ModelFailure> check_models(const Dataset& dataset);

}  // namespace shapegauge
