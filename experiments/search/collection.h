// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "shapegauge/datasets/layouts/dataset.h"

namespace shapegauge {

/// Shape file of a collection.
struct CollectionFile {
  std::string id;              ///< id of the shape, unique in the collection
  std::filesystem::path path;  ///< path of the file; relative to Collection::base for a file below that folder
};

/// Searchable collection of shape files, which queries are compared with.
struct Collection {
  std::filesystem::path base;         ///< folder that relative paths of files start from
  std::vector<CollectionFile> files;  ///< shape files, in natural order of ids
  SkippedEntries skipped = {};        ///< numbers of files and folders that are not shapes of the collection

  /// Returns the path of a file of the collection; relative paths start from `base`.
  [[nodiscard]] std::filesystem::path file(const std::filesystem::path& path) const { return base / path; }
};

/// Finds the collection at a path:
/// - a folder: all files in it and below that are named like shapes; ids are their paths;
/// - a list (.txt, .lst): a path in each line, relative to the list, skipping blank lines and lines that begin with #;
/// - a data set: a classification (.cla) next to its models, a table (.csv) with the columns id, path and class, or a
///   configuration (.json) with a "dataset".
///
/// Throws InputError for other files, for a collection without shapes, and if it cannot be read.
Collection find_collection(const std::filesystem::path& path);

/// Returns the absolute path of a collection, with symbolic links resolved where it exists. "models" and "models/" give
/// the same path.
std::string collection_location(const std::filesystem::path& path);

/// Returns the base folder (Collection::base) of the collection at a path, which need not exist any more.
std::filesystem::path collection_base(const std::filesystem::path& path);

/// Returns the default path of the search index of a collection, next to the collection. `method` is the configuration
/// file of the search method; empty for the recommended method.
std::filesystem::path default_index_path(const std::filesystem::path& collection,
                                         const std::filesystem::path& method = {});

}  // namespace shapegauge
