// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// Class of models in a hierarchy. Classes form a forest; a class that only groups other classes has no models.
struct ModelClass {
  std::string name;                   ///< name of the class
  std::optional<std::size_t> parent;  ///< index of the parent class, which precedes this class; absent for a root
  std::vector<std::string> models;    ///< ids of the class's models, spelled as in the file

  bool operator==(const ModelClass&) const = default;
};

/// Assignment of models to classes. Class names and models are unique.
struct Classification {
  std::vector<ModelClass> classes;  ///< all classes, parents before children

  bool operator==(const Classification&) const = default;
};

/// Returns the number of models in all classes.
std::size_t model_count(const Classification& classification);

/// Returns the ids of all models in the order of the classification, class by class. The Princeton Shape Benchmark's
/// tools assume this order for the rows and columns of a distance matrix.
std::vector<std::string> models_in_file_order(const Classification& classification);

/// Returns the ids of all models in natural order (natural_less()), spelled as in the classification.
std::vector<std::string> models_in_natural_order(const Classification& classification);

/// Returns the class (index into classification.classes) of each model; compares ids by canonical_model_id(). Throws
/// InputError for a model without a class, a repeated id, and a classified model that is not among the ids. `source`,
/// the name of the classification's file, prefixes the message.
std::vector<int> class_labels(const Classification& classification, std::span<const std::string> ids,
                              const std::string& source);

/// Parses the Princeton Shape Benchmark's `.cla` format: "PSB 1"; the numbers of classes and of models; for each class
/// its name, its parent's name or 0, its number of models and that many ids. Words are separated by white space; there
/// are no comments. Throws InputError, with `source` and the line, for another format or version, an invalid count,
/// truncated or trailing text, a parent that does not precede its child, a repeated class name or model, inconsistent
/// totals, and no models.
Classification parse_classification(std::string_view text, const std::string& source);

/// Formats a classification as `.cla`. Parsing restores the same classification if it is representable; see
/// write_classification().
std::string format_classification(const Classification& classification);

/// Reads a `.cla` file; see parse_classification(). Throws InputError also if the file cannot be read.
Classification read_classification(const std::filesystem::path& path);

/// Writes a `.cla` file; reading restores the same classification. Throws InputError if the file cannot be written or
/// the classification is not representable: a name or an id that is empty or contains white space, a class named 0, a
/// repeated name or model, a parent that does not precede its child, no models.
void write_classification(const std::filesystem::path& path, const Classification& classification);

}  // namespace shapegauge
