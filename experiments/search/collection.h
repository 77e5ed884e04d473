#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "shapegauge/datasets/layouts/dataset.h"

namespace shapegauge {

/// A shape file of a collection.
struct CollectionFile {
  std::string id;              ///< unique in the collection
  std::filesystem::path path;  ///< relative to Collection::base where it is below it
};

/// The shape files that a search looks through.
struct Collection {
  std::filesystem::path base;
  std::vector<CollectionFile> files;  ///< in natural order of their ids
  SkippedEntries skipped = {};        ///< of a folder: what else is in it and below

  [[nodiscard]] std::filesystem::path file(const std::filesystem::path& path) const { return base / path; }
};

/// The collection at a path:
/// - a folder: all files in it and below that are named like shapes, by their paths;
/// - a list (.txt, .lst): a path in each line, relative to the list; blank lines and lines that begin with # are
/// skipped;
/// - a data set: a classification (.cla) beside its models, a table (.csv) with the columns id, path and class, or a
///   configuration (.json) with a "dataset".
/// Throws InputError for other files, for a collection without shapes, and where it cannot be read.
Collection find_collection(const std::filesystem::path& path);

/// Collection::base of the collection at a path, which need not be there any more.
std::filesystem::path collection_base(const std::filesystem::path& path);

/// Where the index of a collection lies if nobody names another place: beside it. `method`: the file of its method;
/// empty: the recommended one.
std::filesystem::path usual_index_path(const std::filesystem::path& collection,
                                       const std::filesystem::path& method = {});

}  // namespace shapegauge
