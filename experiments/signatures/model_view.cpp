// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/signatures/model_view.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/pages/coarse_view.h"
#include "shapegauge/pages/shape_view.h"

namespace shapegauge {

Eigen::Index faces_of_views(std::size_t models, const ViewFaces& limits) {
  const auto each = limits.max_total / static_cast<Eigen::Index>(std::max<std::size_t>(models, 1));
  return std::clamp(each, limits.fewest, limits.most);
}

std::string model_view(const Shape& shape, std::span<const SampledField> fields, const ShapeDrawing& drawing) {
  ShapeView view{
      .name = "", .shape = coarse_shape(shape, drawing.faces), .site = SampleSite::vertices, .up = drawing.up};
  const Samples vertex_samples = sample_shape(view.shape, view.site);
  std::map<const Samples*, ValueTransfer> carried;  // most fields have the same samples
  for (const SampledField& field : fields) {
    const auto range = central_range({.values = field.values, .weights = field.samples.weights});
    const ValueTransfer& of_samples = carried.try_emplace(&field.samples, field.samples, vertex_samples).first->second;
    view.fields.push_back(
        {.name = "", .values = of_samples.means(field.values), .colours = range.value_or(Interval{})});
  }
  return json_text(shape_view_json(view));
}

}  // namespace shapegauge
