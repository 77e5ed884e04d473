#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "shapegauge/datasets/files/classification.h"

namespace shapegauge {

/// The classes of models, and which models are queries and which are to be found.
struct ModelLabels {
  Classification classification;     ///< of all models
  std::vector<std::string> queries;  ///< ids as the classification has them
  std::vector<std::string> targets;  ///< so too
  std::vector<std::string> models;   ///< all of them, in the order of the file
  bool separate_sets = false;        ///< not every model is both
  bool listed = false;               ///< the file is a list of models, one a line, and no groups of them
  bool without_ids = false;          ///< it has no ids: they are 0, 1, ... in the order of the file
  std::string source;                ///< stands in front of messages
};

/// Reads labels:
/// - a `.cla` file;
/// - a folder with a folder of models for each class, where an id is a model's path below it without the extension;
/// - a table (any other file) with commas, semicolons or tabs: its first row names the columns, in any case, id (name,
///   model, file) and class (label, category), and if there is one, split: query (test, probe), target (train,
///   gallery), or both or nothing. Without such a row the two columns are id and class;
/// - lines of an id and a class with blanks between, where every id has a digit, none repeats and classes do;
/// - a list: one class a line, or a `.npy` array of whole numbers or strings. Models then have no ids.
/// Tables, lists and arrays may be compressed, with `.gz` behind. Level 0 takes the classes of a `.cla` file as they
/// are; level n takes in place of each class its ancestor of the n-th generation from the root (1: the root), or itself
/// where it has none. Throws InputError: what cannot be read, a table whose columns are not clear, an id that occurs
/// twice, a level where there is no hierarchy.
ModelLabels read_labels(const std::filesystem::path& path, std::size_t level = 0);

/// Queries and their classes from one file, targets from another; classes of one name are the same. Throws InputError
/// as read_labels, and where a model is of different classes in the two.
ModelLabels read_query_and_target_labels(const std::filesystem::path& queries, const std::filesystem::path& targets,
                                         std::size_t level = 0);

}  // namespace shapegauge
