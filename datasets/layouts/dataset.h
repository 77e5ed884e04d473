// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace shapegauge {

/// Location and layout of a data set.
struct DatasetLocation {
  std::string layout;                    ///< one of dataset_layouts()
  std::filesystem::path root;            ///< its folder
  std::filesystem::path classification;  ///< the .cla file or table of layouts that have one
  std::string split = "all";             ///< one of dataset_splits, for layouts with splits
};

/// Shape of a data set.
struct Model {
  std::string id;
  std::filesystem::path file;  ///< may be absent, which check_models() reports
  int label = 0;               ///< index into Dataset::classes
  std::string subclass = {};   ///< name of the subclass, for graded measures; empty for none
  std::string fault = {};      ///< why there is no shape, if the layout knows; reported by check_models()
};

/// Entries of folders that are skipped in the search for shapes, without hidden ones.
struct SkippedEntries {
  std::size_t files = 0;    ///< files without the extension of a shape format
  std::size_t shapes = 0;   ///< shape files where the layout has none
  std::size_t folders = 0;  ///< with their contents
};

/// Describes the counts, such as "skipped: 3 files that are not shapes, 1 folder"; empty if nothing was skipped.
std::string skipped_text(const SkippedEntries& skipped);

/// Models of a data set, in natural order of ids, and the names of their classes.
struct Dataset {
  std::vector<Model> models;
  std::vector<std::string> classes;
  SkippedEntries skipped = {};  ///< of layouts without a list of models
};

/// Returns the label of a class, adding it if the name is new.
int label_of_class(const std::string& name, Dataset& dataset);

/// Adds a model. `ids` are those of the models so far. Throws InputError, with the file, for a repeated id.
void add_model(Model model, std::set<std::string>& ids, Dataset& dataset);

/// Returns true if the name ends in one of unambiguous_shape_extensions(), ignoring case, and is not hidden. A .txt
/// file may be anything and does not count.
bool is_model_file(const std::filesystem::path& path);

/// Returns true for a folder or a link to one. False if the path cannot be examined.
bool is_folder(const std::filesystem::path& path);

/// Returns true for a folder whose entries can be listed.
bool is_readable_folder(const std::filesystem::path& path);

/// Returns true for a broken or cyclic symbolic link.
bool leads_nowhere(const std::filesystem::path& path);

/// Returns true for a symbolic link that leads back to itself.
bool is_cyclic_link(const std::filesystem::path& path);

/// Resolves all links of a path. Returns the path unchanged if it does not exist.
std::filesystem::path canonical_or_same(const std::filesystem::path& path);

/// Returns the entries of a folder that are not hidden and wanted, in natural order. Throws InputError if the folder
/// cannot be read.
std::vector<std::filesystem::path> visible_entries(const std::filesystem::path& folder,
                                                   const std::function<bool(const std::filesystem::path&)>& wanted);

/// Counts the entries of the folder, and of its subfolders with models, that are not models.
SkippedEntries skipped_entries(const std::filesystem::path& root, const std::vector<Model>& models);

/// Returns the entries of a folder that are named like shape files, in natural order. They need not be readable files;
/// check_models() reports those. Throws InputError if the folder cannot be read.
std::vector<std::filesystem::path> model_files(const std::filesystem::path& folder);

/// Returns the immediate subfolders that are not hidden, in natural order. Includes broken links without an extension,
/// which may have led to a folder. Throws InputError if the folder cannot be read.
std::vector<std::filesystem::path> subfolders(const std::filesystem::path& folder);

/// Returns the canonical paths of the root of a data set and of the folders above it, for unvisited().
std::set<std::filesystem::path> visited_at_root(const std::filesystem::path& root);

/// Returns the folders whose canonical paths are not among the visited ones, and adds these. Of a folder and links to
/// it, keeps the folder.
std::vector<std::filesystem::path> unvisited(std::vector<std::filesystem::path> folders,
                                             std::set<std::filesystem::path>& visited);

}  // namespace shapegauge
