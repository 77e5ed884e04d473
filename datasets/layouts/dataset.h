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
  std::string layout;                    ///< name of the layout, one of dataset_layouts()
  std::filesystem::path root;            ///< folder of the data set
  std::filesystem::path classification;  ///< file that defines the classes (.cla or table); empty for none
  std::string split = "all";             ///< subset of the models, one of dataset_splits; used by layouts with splits
};

/// Model of a data set: its id, shape file and class.
struct Model {
  std::string id;              ///< id, unique in the data set
  std::filesystem::path file;  ///< path of the shape file; check_models() reports missing files
  int label = 0;               ///< class of the model, as an index into Dataset::classes
  std::string subclass = {};   ///< name of the subclass, for graded measures; empty for none
  std::string fault = {};      ///< reason why `file` is not a shape, reported by check_models(); empty for none
};

/// Numbers of folder entries that the search for shapes skipped; hidden entries are not counted.
struct SkippedEntries {
  std::size_t files = 0;    ///< number of files without the extension of a shape format
  std::size_t shapes = 0;   ///< number of shape files in folders where the layout has none
  std::size_t folders = 0;  ///< number of folders, each skipped with its contents
};

/// Formats the counts as text, such as "skipped: 3 files that are not shapes, 1 folder"; empty if nothing was skipped.
std::string skipped_text(const SkippedEntries& skipped);

/// Models of a data set, in natural order of ids, and the names of their classes.
struct Dataset {
  std::vector<Model> models;         ///< models in natural order of ids
  std::vector<std::string> classes;  ///< names of the classes, indexed by Model::label
  SkippedEntries skipped = {};       ///< skipped entries, counted only for layouts without a classification file
};

/// Returns the label of a class, which is its index in Dataset::classes. Adds the class if the name is new.
int label_of_class(const std::string& name, Dataset& dataset);

/// Adds a model to a data set and its id to `ids`, the ids of all models so far. Throws InputError for a repeated id.
void add_model(Model model, std::set<std::string>& ids, Dataset& dataset);

/// Returns true if the name ends in one of unambiguous_shape_extensions(), ignoring case, and is not hidden. A .txt
/// file may be anything and does not count.
bool is_model_file(const std::filesystem::path& path);

/// Returns true for a folder or a link to one. False if the path cannot be examined.
bool is_folder(const std::filesystem::path& path);

/// Returns true for a folder whose entries can be listed.
bool is_readable_folder(const std::filesystem::path& path);

/// Returns true for a broken or cyclic symbolic link.
bool is_broken_link(const std::filesystem::path& path);

/// Returns true for a symbolic link that leads back to itself.
bool is_cyclic_link(const std::filesystem::path& path);

/// Resolves all links of a path. Returns the path unchanged if it does not exist.
std::filesystem::path canonical_or_same(const std::filesystem::path& path);

/// Returns the entries of a folder that are not hidden and for which `condition` is true, in natural order. Throws
/// InputError if the folder cannot be read.
std::vector<std::filesystem::path> visible_entries(const std::filesystem::path& folder,
                                                   const std::function<bool(const std::filesystem::path&)>& condition);

/// Counts the entries that are not files of `models`, in the folder `root` and in its subfolders that contain models.
SkippedEntries skipped_entries(const std::filesystem::path& root, const std::vector<Model>& models);

/// Returns the entries of a folder that are named like shape files, in natural order. Includes unreadable files, which
/// check_models() reports. Throws InputError if the folder cannot be read.
std::vector<std::filesystem::path> model_files(const std::filesystem::path& folder);

/// Returns the immediate subfolders that are not hidden, in natural order. Includes broken links without an extension,
/// which may have led to a folder. Throws InputError if the folder cannot be read.
std::vector<std::filesystem::path> subfolders(const std::filesystem::path& folder);

/// Returns the canonical paths of the root of a data set and of its parent folders: the initial value of `visited` in
/// unvisited(), which prevents endless walks through links.
std::set<std::filesystem::path> visited_at_root(const std::filesystem::path& root);

/// Returns the folders whose canonical paths are not in `visited`, and adds their canonical paths to `visited`. If a
/// folder and links to it are listed, returns the folder only.
std::vector<std::filesystem::path> unvisited(std::vector<std::filesystem::path> folders,
                                             std::set<std::filesystem::path>& visited);

}  // namespace shapegauge
