#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "shapegauge/experiments/files/classification.h"

namespace shapegauge {

/// The classes of models, and which models are queries and which are to be found.
struct ModelLabels {
  Classification classification;     ///< of all models
  std::vector<std::string> queries;  ///< ids as the classification has them
  std::vector<std::string> targets;  ///< so too
  bool separate_sets = false;        ///< not every model is both
  std::string source;                ///< stands in front of messages
};

/// Reads labels: a `.cla` file; a `.csv` table with the columns id and class, and if there is one, split: query (test,
/// probe), target (train, gallery), or both or nothing; or a folder with a folder of models for each class, where an id
/// is a model's path below it without the extension. Level 0 takes the classes of a `.cla` file as they are; level n
/// takes in place of each class its ancestor of the n-th generation from the root (1: the root), or itself where it has
/// none. Throws InputError: what cannot be read, a table without these columns, an id that occurs twice, a level where
/// there is no hierarchy.
ModelLabels read_labels(const std::filesystem::path& path, std::size_t level = 0);

/// Queries and their classes from one file, targets from another; classes of one name are the same. Throws InputError
/// as read_labels, and where a model is of different classes in the two.
ModelLabels read_query_and_target_labels(const std::filesystem::path& queries, const std::filesystem::path& targets,
                                         std::size_t level = 0);

}  // namespace shapegauge
