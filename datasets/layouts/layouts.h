#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/registry.h"
#include "shapegauge/datasets/layouts/dataset.h"

namespace shapegauge {

/// A way in which a data set lies in a folder.
struct DatasetLayout {
  std::string_view name;
  Dataset (*find)(const DatasetLocation&);
  std::string_view usual_classification{};  ///< the file beside the models that says their classes; empty: none
  bool has_splits = false;                  ///< DatasetLocation::split chooses among the models
  bool has_classification = true;           ///< a file may say the classes; else names of files and folders do
  /// Whether a folder looks like one of the layout; null: where the usual classification is there.
  bool (*recognises)(const std::filesystem::path& root) = nullptr;
};

/// All layouts: those of layouts.cpp, then those that were added.
Registry<DatasetLayout>& dataset_layouts();

/// The data set at the location. Throws InputError: a folder or a classification that is absent or wrong, no models.
Dataset find_dataset(const DatasetLocation& location);

/// Whether the file is named like a table of the layout "csv": .csv or .tsv, in any case.
bool is_model_table(const std::filesystem::path& path);

/// The location in a folder whose layout is told by what is there: the first layout that recognises it, else folders. A
/// classification that is named is a table (csv) or, unless the folder is one of psb, that of shrec11. Throws
/// InputError where the folder is absent.
DatasetLocation recognise_dataset(const std::filesystem::path& root, const std::filesystem::path& classification = {});

/// Something that is wrong with one model.
struct ModelFailure {
  std::size_t model = 0;  ///< index in Dataset::models
  std::string message;
};

/// Looks at the file of every model: is it there, and does it begin like a shape? Models that fail, in order.
std::vector<ModelFailure> check_models(const Dataset& dataset);

}  // namespace shapegauge
