// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "shapegauge/datasets/files/classification.h"
#include "shapegauge/datasets/files/model_ids.h"

namespace shapegauge {

/// Classes of models, and the roles of models as queries and targets.
struct ModelLabels {
  Classification classification;                              ///< classes of all models
  std::vector<std::string> queries;                           ///< ids of the queries, spelled as in the classification
  std::vector<std::string> targets;                           ///< ids of the targets, spelled as in the classification
  std::vector<std::string> models;                            ///< ids of all models, in the order of the file
  std::unordered_map<std::string, std::string> subclasses{};  ///< subclass per model key (ModelKeys), if it has one
  bool separate_sets = false;                                 ///< true if some models are only queries or only targets
  bool split = false;        ///< true if a column `split` makes some models only queries or only targets
  bool listed = false;       ///< true if the file lists models one by one, not grouped by class
  bool without_ids = false;  ///< true if the file has no ids: models are named 0, 1, ... in order
  std::string source;        ///< name of the file, which prefixes error messages
  ModelKeys keys{};          ///< keys for comparing other ids with the ids of the models
};

/// Words that programs write for missing values. A class of such a name usually consists of models without a class.
inline constexpr std::array<std::string_view, 6> missing_value_words{"nan", "NaN", "None", "<NA>", "NaT", "NULL"};

/// Returns a warning for each class whose name is in missing_value_words or is a missing value of R or spreadsheets.
std::vector<std::string> missing_class_warnings(const ModelLabels& labels);

/// Reads labels from one of these:
/// - a `.cla` file;
/// - a folder with one folder of models per class; ids are paths below it without extensions;
/// - a table (any other file) separated by commas, semicolons or tabs, whose first row names the columns, ignoring
///   case: id (name, model, file), class (label, category) and optionally subclass (subcategory) and split: query
///   (test, probe), target (train, gallery), both, or empty. Without such a row the two columns are id and class. Lines
///   before it that begin with "# " are comments;
/// - lines of an id and a class separated by blanks, if every id has a digit, ids are unique and classes repeat;
/// - a list: one class per line, or a `.npy` array of integers or strings, none of them in missing_value_words. Models
///   then have no ids.
///
/// Tables, lists and arrays may be compressed, with an additional `.gz`. Level 0 uses the classes of a `.cla` file;
/// level n replaces each class by its ancestor in the n-th generation from the root (1: the root), if there is one.
/// Throws InputError for unreadable files, a table with ambiguous columns, a repeated id, and a level without
/// hierarchy.
ModelLabels read_labels(const std::filesystem::path& path, std::size_t level = 0);

/// Labels of the queries and targets of an evaluation: of one set of models, or of two sets with separate ids. Two sets
/// have the same classes in the same order.
struct TaskLabels {
  ModelLabels queries;                   ///< labels of the queries; labels of all models if there is one set
  std::optional<ModelLabels> targets{};  ///< labels of the targets; absent if there is one set

  /// Returns the labels of the targets.
  [[nodiscard]] const ModelLabels& of_targets() const { return targets ? *targets : queries; }
};

/// Reads the labels of queries and of targets, which are different models even if their ids are equal. Classes are
/// matched by name. Throws InputError as read_labels() does.
TaskLabels read_query_and_target_labels(const std::filesystem::path& queries, const std::filesystem::path& targets,
                                        std::size_t level = 0);

/// Reads the labels of queries and of targets; equal ids in both files are the same model. Throws InputError as
/// read_labels() does, for a file without ids, and for a model with different classes in the two files.
ModelLabels read_shared_labels(const std::filesystem::path& queries, const std::filesystem::path& targets,
                               std::size_t level = 0);

}  // namespace shapegauge
