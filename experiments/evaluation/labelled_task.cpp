#include "shapegauge/experiments/evaluation/labelled_task.h"

#include <algorithm>
#include <fmt/format.h>

#include "shapegauge/core/error.h"
#include "shapegauge/experiments/datasets/model_ids.h"
#include "shapegauge/experiments/datasets/natural_order.h"
#include "shapegauge/experiments/text/quoted_word.h"

namespace shapegauge {
namespace {

using Places = std::unordered_map<std::string, Eigen::Index>;

Places places_of(const std::vector<std::string>& ids, const std::string& source) {
  Places places;
  for (const std::string& id : ids) {
    if (places.emplace(canonical_model_id(id), static_cast<Eigen::Index>(places.size())).second) continue;
    throw InputError(fmt::format("model {} occurs twice among the models to look up in {}", quoted_word(id), source));
  }
  return places;
}

void check_all_there(const std::vector<std::string>& wanted, const Places& places, const std::string& source) {
  for (const std::string& id : wanted) {
    if (places.contains(canonical_model_id(id))) continue;
    throw InputError(fmt::format("{}: model {} is classified but is not among the {} models that are there", source,
                                 quoted_word(id), places.size()));
  }
}

}  // namespace

ClassifiedModels::ClassifiedModels(const ModelLabels& labels) : labels_(labels) {
  for (std::size_t i = 0; i < labels.classification.classes.size(); ++i) {
    for (const std::string& model : labels.classification.classes[i].models) {
      known_[canonical_model_id(model)].label = static_cast<int>(i);
    }
  }
  for (const std::string& model : labels.queries) known_.at(canonical_model_id(model)).query = true;
  for (const std::string& model : labels.targets) known_.at(canonical_model_id(model)).target = true;
}

const ClassifiedModels::Known& ClassifiedModels::at(const std::string& id) const {
  const auto found = known_.find(canonical_model_id(id));
  if (found != known_.end()) return found->second;
  throw InputError(fmt::format("{}: model {} is in no class; add it to the file or leave the model out", labels_.source,
                               quoted_word(id)));
}

MatrixModels ClassifiedModels::usual_models(Eigen::Index rows, Eigen::Index columns, bool labels_order) const {
  MatrixModels models{.rows = labels_.queries, .columns = labels_.targets};
  const bool two_sets = static_cast<std::size_t>(rows) == models.rows.size() &&
                        static_cast<std::size_t>(columns) == models.columns.size();
  if (!two_sets) models.rows = models.columns = models_in_file_order(labels_.classification);
  if (!labels_order) {
    std::ranges::sort(models.rows, natural_less);
    std::ranges::sort(models.columns, natural_less);
  }
  return models;
}

EvaluationInput ClassifiedModels::input_of(const MatrixModels& models) const {
  const Places rows = places_of(models.rows, labels_.source);
  const Places columns = places_of(models.columns, labels_.source);
  EvaluationInput input;
  input.query_ids = models.rows;
  input.same_rows_and_columns = rows == columns;
  for (const ModelClass& model_class : labels_.classification.classes) input.class_names.push_back(model_class.name);
  for (const std::string& id : models.rows) {
    const Known& known = at(id);
    input.task.query_classes.push_back(known.query ? known.label : no_class);
    const auto own = columns.find(canonical_model_id(id));
    input.task.own_column.push_back(own == columns.end() ? -1 : own->second);
  }
  for (const std::string& id : models.columns) {
    const Known& known = at(id);
    input.task.target_classes.push_back(known.target ? known.label : no_class);
  }
  check_all_there(labels_.queries, rows, labels_.source);
  check_all_there(labels_.targets, columns, labels_.source);
  return input;
}

}  // namespace shapegauge
