#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
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

}  // namespace shapegauge
