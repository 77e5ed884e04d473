#pragma once

#include <Eigen/Core>
#include <string>
#include <unordered_map>
#include <vector>

#include "shapegauge/experiments/evaluation/evaluation_input.h"
#include "shapegauge/experiments/evaluation/model_labels.h"

namespace shapegauge {

/// The models that the rows and columns of a matrix stand for.
struct MatrixModels {
  std::vector<std::string> rows;
  std::vector<std::string> columns;
};

/// Labels, to be looked up by model; ids are compared as canonical_model_id has it.
class ClassifiedModels {
 public:
  explicit ClassifiedModels(const ModelLabels& labels);

  /// What is known of a model.
  struct Known {
    int label = 0;  ///< index of its class
    bool query = false;
    bool target = false;
  };

  /// Throws InputError where the model is in no class.
  [[nodiscard]] const Known& at(const std::string& id) const;

  /// The models of a matrix that does not name them, in natural order or that of the labels. Where query and target set
  /// differ: queries by targets where the matrix is of that size, else all by all.
  [[nodiscard]] MatrixModels usual_models(Eigen::Index rows, Eigen::Index columns, bool labels_order) const;

  /// The task of a matrix of those models, without its distances. Throws InputError: a model in no class, twice among
  /// the rows or the columns, a query that has no row, a target that has no column.
  [[nodiscard]] EvaluationInput input_of(const MatrixModels& models) const;

  [[nodiscard]] const ModelLabels& labels() const { return labels_; }

 private:
  ModelLabels labels_;
  std::unordered_map<std::string, Known> known_;
};

}  // namespace shapegauge
