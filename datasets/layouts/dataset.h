#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace shapegauge {

/// Where a data set is and how it is laid out.
struct DatasetLocation {
  std::string layout;                    ///< a name of dataset_layouts()
  std::filesystem::path root;            ///< its folder
  std::filesystem::path classification;  ///< of layouts that have one: the .cla file or the table
  std::string split = "all";             ///< of layouts with splits: "all", "train", "val" or "test"
};

/// One shape of a data set.
struct Model {
  std::string id;
  std::filesystem::path file;  ///< may be absent; check_models says so
  int label = 0;               ///< index of its class in Dataset::classes
};

/// Entries of folders that are passed over when shapes are looked for. Hidden ones do not count.
struct SkippedEntries {
  std::size_t files = 0;    ///< not named like shapes
  std::size_t shapes = 0;   ///< named like shapes, at a place where the layout has none
  std::size_t folders = 0;  ///< with all that is in them
};

/// The counts in words, such as "skipped: 3 files that are no shapes, 1 folder"; empty where nothing was skipped.
std::string skipped_text(const SkippedEntries& skipped);

/// The models of a data set, in natural order of their ids, and the names of their classes.
struct Dataset {
  std::vector<Model> models;
  std::vector<std::string> classes;
  SkippedEntries skipped = {};  ///< of layouts without a list of models
};

/// Whether the name ends in one of unambiguous_shape_extensions(), in any case, and is not hidden. A .txt file may be
/// anything, and is not counted.
bool is_model_file(const std::filesystem::path& path);

/// Whether the path is a folder, or a link to one. False where the path cannot be examined.
bool is_folder(const std::filesystem::path& path);

/// Whether the path is a folder whose entries can be listed.
bool is_readable_folder(const std::filesystem::path& path);

/// Whether the path is a broken symbolic link, or one in a circle of links.
bool leads_nowhere(const std::filesystem::path& path);

/// What lies in the folder, and in those folders below that hold models, without being one of the models.
SkippedEntries skipped_entries(const std::filesystem::path& root, const std::vector<Model>& models);

/// The entries of the folder that are named like shape files, in natural order. They need not be readable, or files:
/// check_models reports those. Throws InputError where the folder cannot be read.
std::vector<std::filesystem::path> model_files(const std::filesystem::path& folder);

/// The folders right in the folder that are not hidden, in natural order of their names, and broken links without an
/// extension, which may have led to a folder. Throws InputError where the folder cannot be read.
std::vector<std::filesystem::path> subfolders(const std::filesystem::path& folder);

}  // namespace shapegauge
