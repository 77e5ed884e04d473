#include "shapegauge/experiments/runner/validate_models.h"

#include <numeric>

#include "shapegauge/core/io/read_shape.h"
#include "shapegauge/core/shape/normalise.h"
#include "shapegauge/experiments/runner/for_each_model.h"

namespace shapegauge {

std::vector<ModelFailure> validate_models(const Dataset& dataset, const RunControl& control) {
  std::vector<std::size_t> all(dataset.models.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return for_each_model(all, "models", false, control,
                        [&](std::size_t model) { positive_area(read_shape(dataset.models[model].file)); });
}

}  // namespace shapegauge
