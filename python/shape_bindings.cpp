// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes and what is computed from one: fields, parts, features.
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "python/native.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/preparation/outliers.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/core/preparation/stray_normals.h"
#include "shapegauge/experiments/configuration/chosen_offset.h"
#include "shapegauge/experiments/configuration/descriptor_choice.h"
#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/configuration/schema.h"
#include "shapegauge/experiments/configuration/segmentation_experiment.h"
#include "shapegauge/segmentation/segment_shape.h"

namespace py = pybind11;

namespace shapegauge {

Shape shape_of(const Eigen::Ref<const Points>& vertices, const Eigen::Ref<const Triangles>& faces,
               const Eigen::Ref<const Points>& normals) {
  Shape shape{.vertices = vertices, .triangles = faces, .normals = normals};
  require_usable(shape);
  return shape;
}

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

bool chooses_offset(const Field& field) {
  return field.settings.values.find("offset") != nullptr && !fixed_offset(field.settings);
}

/// Shape without the outliers of a cloud.
struct CleanedShape {
  Shape shape;
  std::vector<bool> removed;  ///< per vertex
  std::vector<std::string> warnings = {};

  /// Returns the rows of all vertices: those of the remaining ones, and others that are filled.
  template <typename Rows>
  [[nodiscard]] Rows spread(const Rows& rows, typename Rows::Scalar fill) const {
    if (std::ranges::find(removed, true) == removed.end() || rows.rows() == 0) return rows;
    Rows all = Rows::Constant(std::ssize(removed), rows.cols(), fill);
    Eigen::Index next = 0;
    for (std::size_t i = 0; i < removed.size(); ++i) {
      if (!removed[i]) all.row(static_cast<Eigen::Index>(i)) = rows.row(next++);
    }
    return all;
  }
};

/// Removes outliers as requested, or warns of them, and removes stray normals.
CleanedShape cleaned(Shape shape, bool remove) {
  CleanedShape result{.shape = {}, .removed = std::vector<bool>(static_cast<std::size_t>(shape.vertices.rows()))};
  if (remove_stray_normals(shape)) result.warnings.emplace_back(stray_normals_warning);
  if (!remove) {
    if (auto warning = outlier_warning(shape)) result.warnings.push_back(std::move(*warning));
    result.shape = std::move(shape);
    return result;
  }
  result.removed = outliers(shape);
  if (const auto count = std::ranges::count(result.removed, true); count > 0) {
    result.warnings.push_back(outlier_text(static_cast<std::size_t>(count), shape.vertices.rows()) +
                              "; these points have no results");
  }
  result.shape = without_outliers(std::move(shape));
  return result;
}

/// Values of a field at samples of a shape, and remarks on them.
struct ComputedField {
  Samples samples;
  FieldValues values;
  std::optional<double> offset;
  std::optional<std::string> leak;
  std::optional<std::string> hollow;
  std::vector<std::string> warnings;
};

ComputedField computed_field(const Field& field, const CleanedShape& clean) {
  const Shape& shape = clean.shape;
  FieldSource source(shape);
  ComputedField result;
  result.samples = take_samples(shape, field.settings.samples);
  result.values = field.compute(source, result.samples, true);
  if (const auto chosen = offset_of(field.settings, source)) {
    result.offset = chosen->offset;
    result.leak = leak_warning(*chosen);
    result.hollow = hollow_remark(shape, true);
  }
  result.warnings = outcome_warnings(result.values.outcomes);
  std::ranges::copy(clean.warnings, std::back_inserter(result.warnings));
  if (auto warning = weights_warning(result.samples)) result.warnings.push_back(*std::move(warning));
  result.values.values = clean.spread(result.values.values, std::numeric_limits<double>::quiet_NaN());
  result.values.normals = clean.spread(result.values.normals, 0);
  result.samples.weights = clean.spread(result.samples.weights, 0);
  return result;
}

py::dict field(const Eigen::Ref<const Points>& vertices, const Eigen::Ref<const Triangles>& faces,
               const Eigen::Ref<const Points>& normals, const std::string& settings, bool remove_outliers,
               int threads) {
  ComputedField computed = compute(threads, [&] {
    const Json json = Json::parse(settings);
    check_against_schema(json, "field", "the field");
    const Field requested = read_field(json);
    ComputedField result = computed_field(
        requested, cleaned(shape_of(vertices, faces, normals), remove_outliers || chooses_offset(requested)));
    if (result.samples.site == SampleSite::vertices) result.samples.points = vertices;
    return result;
  });
  const auto listed = [](const std::optional<std::string>& warning) {
    return warning ? std::vector{*warning} : std::vector<std::string>();
  };
  py::dict result;
  result["values"] = array_of(std::move(computed.values.values));
  result["weights"] = array_of(std::move(computed.samples.weights));
  result["points"] = array_of(std::move(computed.samples.points));
  result["normals"] = array_of(std::move(computed.values.normals));
  result["offset"] = computed.offset;
  result["leaks"] = listed(computed.leak);
  result["hollow"] = listed(computed.hollow);
  result["without_value"] = std::move(computed.warnings);
  return result;
}

/// Returns the parts and warnings.
py::tuple segment(const Eigen::Ref<const Points>& vertices, const Eigen::Ref<const Triangles>& faces,
                  const Eigen::Ref<const Points>& normals, const std::string& settings, bool remove_outliers,
                  int threads) {
  auto [spread_labels, all_warnings] = compute(threads, [&] {
    const Json json = Json::parse(settings);
    check_against_schema(json, "segmentation_method", "the segmentation");
    if (json.contains("perturbations")) throw InputError("perturbations are settings of experiments; use run()");
    const SegmentationMethod method = segmentation_method(json);
    const CleanedShape clean = cleaned(shape_of(vertices, faces, normals), remove_outliers);
    const Shape& shape = clean.shape;
    OffsetSdfOutcomes outcomes;
    const std::vector<std::int32_t> parts = segment_shape(shape, method.options, &outcomes);
    const Eigen::VectorX<std::int32_t> labels =
        Eigen::Map<const Eigen::VectorX<std::int32_t>>(parts.data(), static_cast<Eigen::Index>(parts.size()));
    std::vector<std::string> warnings = outcome_warnings(field_outcomes(outcomes));
    std::ranges::copy(clean.warnings, std::back_inserter(warnings));
    const SegmentationOptions& options = method.options;
    if (options.method == SegmentationAlgorithm::paper && options.field == SegmentedSdf::offset) {
      const auto leak = leak_warning(choose_offset(options.offset, shape));
      if (leak) warnings.push_back(*leak);
    }
    return std::pair(clean.spread(labels, -1), std::move(warnings));
  });
  return py::make_tuple(array_of(std::move(spread_labels)), all_warnings);
}

/// Returns the features and warnings.
py::tuple describe(const Eigen::Ref<const Points>& vertices, const Eigen::Ref<const Triangles>& faces,
                   const Eigen::Ref<const Points>& normals, const std::string& settings, bool remove_outliers,
                   int threads) {
  auto [features, warnings] = compute(threads, [&] {
    const Json json = Json::parse(settings);
    check_against_schema(json, "descriptor", "the descriptor");
    const DescriptorChoice choice = make_descriptor(json);
    if (needs_learning(choice.descriptor, choice.values)) {
      throw InputError("the descriptor " + std::string(choice.descriptor.name) +
                       " learns from a whole data set; use run() with a configuration");
    }
    CleanedShape clean = cleaned(shape_of(vertices, faces, normals), remove_outliers);
    const Shape shape = prepare_shape(std::move(clean.shape), {}).shape;
    FieldSource source(shape);
    DescriptorFields computed = compute_fields(choice, source);
    std::ranges::copy(clean.warnings, std::back_inserter(computed.warnings));
    return std::pair(
        compute_features(choice.descriptor, {.shape = shape, .fields = computed.fields, .proxy = &source.proxy()}, {},
                         choice.values),
        std::move(computed.warnings));
  });
  return py::make_tuple(array_of(std::move(features)), warnings);
}

}  // namespace

void bind_shapes(py::module_& module) {
  module.def("read", [](const fs::path& path) {
    Shape shape = compute(0, [&] { return read_shape(path); });
    return py::make_tuple(array_of(std::move(shape.vertices)), array_of(std::move(shape.triangles)),
                          array_of(std::move(shape.normals)));
  });
  module.def("write", [](const fs::path& path, const Eigen::Ref<const Points>& vertices,
                         const Eigen::Ref<const Triangles>& faces, const Eigen::Ref<const Points>& normals) {
    const py::gil_scoped_release released;
    const Shape shape = shape_of(vertices, faces, normals);
    shape_writer(path)(path, shape, {});
    return precision_warning(path, shape);
  });
  module.def("field", &field);
  module.def("segment", &segment);
  module.def("describe", &describe);
}

}  // namespace shapegauge
