#include "shapegauge/experiments/datasets/classification.h"

#include <algorithm>
#include <fmt/format.h>
#include <unordered_map>
#include <unordered_set>

#include "shapegauge/core/error.h"
#include "shapegauge/experiments/datasets/model_ids.h"
#include "shapegauge/experiments/datasets/natural_order.h"
#include "shapegauge/experiments/text/quoted_word.h"

namespace shapegauge {

std::size_t model_count(const Classification& classification) {
  std::size_t count = 0;
  for (const ModelClass& model_class : classification.classes) count += model_class.models.size();
  return count;
}

std::vector<std::string> models_in_file_order(const Classification& classification) {
  std::vector<std::string> models;
  for (const ModelClass& model_class : classification.classes) {
    models.insert(models.end(), model_class.models.begin(), model_class.models.end());
  }
  return models;
}

std::vector<std::string> models_in_natural_order(const Classification& classification) {
  std::vector<std::string> models = models_in_file_order(classification);
  std::ranges::sort(models, natural_less);
  return models;
}

std::vector<int> class_labels(const Classification& classification, std::span<const std::string> ids,
                              const std::string& source) {
  std::unordered_map<std::string, int> class_of_model;
  for (std::size_t i = 0; i < classification.classes.size(); ++i) {
    for (const std::string& model : classification.classes[i].models) {
      class_of_model.emplace(canonical_model_id(model), static_cast<int>(i));
    }
  }
  std::vector<int> labels;
  std::unordered_set<std::string> seen;
  for (const std::string& id : ids) {
    const std::string canonical = canonical_model_id(id);
    const auto found = class_of_model.find(canonical);
    if (found == class_of_model.end()) {
      throw InputError(fmt::format("{}: model {} is in no class; add it to the file or leave the model out", source,
                                   quoted_word(id)));
    }
    if (!seen.insert(canonical).second) {
      throw InputError(fmt::format("model {} occurs twice among the models to look up in {}", quoted_word(id), source));
    }
    labels.push_back(found->second);
  }
  for (const std::string& model : models_in_file_order(classification)) {
    if (seen.contains(canonical_model_id(model))) continue;
    throw InputError(fmt::format("{}: model {} is classified but is not among the {} models that are there", source,
                                 quoted_word(model), ids.size()));
  }
  return labels;
}

}  // namespace shapegauge
