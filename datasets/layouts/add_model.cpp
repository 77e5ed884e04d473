#include "shapegauge/datasets/layouts/add_model.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

int label_of_class(const std::string& name, Dataset& dataset) {
  const auto found = std::ranges::find(dataset.classes, name);
  const auto label = static_cast<int>(found - dataset.classes.begin());
  if (found == dataset.classes.end()) dataset.classes.push_back(name);
  return label;
}

void add_model(Model model, std::set<std::string>& ids, Dataset& dataset) {
  if (!ids.insert(model.id).second) {
    throw InputError(fmt::format("{}: another file is also model {}; keep one", model.file.string(), model.id));
  }
  dataset.models.push_back(std::move(model));
}

}  // namespace shapegauge
