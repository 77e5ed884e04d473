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
  Classification classification;                              ///< of all models
  std::vector<std::string> queries;                           ///< ids as in the classification
  std::vector<std::string> targets;                           ///< ids as in the classification
  std::vector<std::string> models;                            ///< all models, in the order of the file
  std::unordered_map<std::string, std::string> subclasses{};  ///< by key; models without one are absent
  bool separate_sets = false;                                 ///< some models are only queries or only targets
  bool split = false;                                         ///< because a column `split` of the file says so
  bool listed = false;       ///< the file is a list of models, one per line, without groups
  bool without_ids = false;  ///< the file has no ids: models are 0, 1, ... in its order
  std::string source;        ///< prefixes error messages
  ModelKeys keys{};          ///< for comparing ids with those of the models
};

/// Words that programs write for missing values. A class of such a name usually consists of models without a class.
inline constexpr std::array<std::string_view, 6> missing_value_words{"nan", "NaN", "None", "<NA>", "NaT", "NULL"};

/// Returns a warning for each class named in missing_value_words, or as R and spreadsheets name missing values.
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

/// Labels of the queries and targets of an evaluation: of one set of models, or of two with ids of their own, which
/// have the same classes in the same order.
struct TaskLabels {
  ModelLabels queries;                   ///< labels of the queries; of all models if they are one set
  std::optional<ModelLabels> targets{};  ///< labels of the targets, if these are another set

  [[nodiscard]] const ModelLabels& of_targets() const { return targets ? *targets : queries; }
};

/// Reads the labels of queries and of targets, which are different models even if their ids are equal. Classes are
/// matched by name. Throws InputError as read_labels() does.
TaskLabels read_query_and_target_labels(const std::filesystem::path& queries, const std::filesystem::path& targets,
                                        std::size_t level = 0);

/// Reads the labels of queries and of targets in which an id of both files is one model. Throws InputError as
/// read_labels() does, for a file without ids, and for a model with different classes in the two.
ModelLabels read_shared_labels(const std::filesystem::path& queries, const std::filesystem::path& targets,
                               std::size_t level = 0);

}  // namespace shapegauge
