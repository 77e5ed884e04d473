#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// A class of models. Classes form a forest; a class that only groups others has no models of its own.
struct ModelClass {
  std::string name;
  std::optional<std::size_t> parent;  ///< index of the parent, smaller than the class's own; nothing for a root
  std::vector<std::string> models;    ///< ids as the file has them

  bool operator==(const ModelClass&) const = default;
};

/// Which models belong to which class. No class name and no model occurs twice.
struct Classification {
  std::vector<ModelClass> classes;  ///< parents before children

  bool operator==(const Classification&) const = default;
};

/// Number of models in all classes.
std::size_t model_count(const Classification& classification);

/// The ids of all models as the classification has them, in its own order: class after class. This is the order of rows
/// and columns that the Princeton Shape Benchmark's own tools take a distance matrix to have.
std::vector<std::string> models_in_file_order(const Classification& classification);

/// The ids of all models as the classification has them, in natural order.
std::vector<std::string> models_in_natural_order(const Classification& classification);

/// The class (index in classification.classes) of each model; ids are compared as canonical_model_id has it. Throws
/// InputError where a model has no class or occurs twice among the ids, and where the classification has a model that
/// is not among the ids; the message begins with `source`, the name of the classification's file.
std::vector<int> class_labels(const Classification& classification, std::span<const std::string> ids,
                              const std::string& source);

/// Parses the Princeton Shape Benchmark's `.cla` format: "PSB 1"; the numbers of classes and of models; for each class
/// its name, its parent's name or 0, its number of models and that many ids. Words are separated by any white space,
/// there are no comments. Throws InputError with `source`, the line and what is wrong: another format or version, a
/// count that is not a whole number from 0 up, an end too early or too late, a parent that did not come before, a class
/// name or a model that occurs twice, totals that disagree, no models at all.
Classification parse_classification(std::string_view text, const std::string& source);

/// The text of a `.cla` file. It reads back as the same classification if that can be expressed; see
/// write_classification.
std::string format_classification(const Classification& classification);

/// Reads a `.cla` file; see parse_classification. Throws InputError also where the file cannot be read.
Classification read_classification(const std::filesystem::path& path);

/// Writes a `.cla` file, which reads back as the same classification. Throws InputError where the file cannot be
/// written or where the classification cannot be expressed: a name or an id that is empty or has white space in it, a
/// class named 0, a repeated name or model, a parent that does not come before its child, no models at all.
void write_classification(const std::filesystem::path& path, const Classification& classification);

}  // namespace shapegauge
