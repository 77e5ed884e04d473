// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/signatures/shape_reports.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/configuration/chosen_offset.h"
#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/engine/manifest.h"

namespace shapegauge {

bool offset_leaks(const ShapeDiagnostics& model, std::optional<double> offset) {
  return offset && model.gap_size > *offset * model.diagonal;
}

std::vector<FieldReport> report_fields(const std::vector<const ModelDescription*>& models,
                                       std::span<const Field> fields) {
  std::vector<FieldReport> reports;
  for (std::size_t field = 0; field < fields.size(); ++field) {
    FieldReport& report = reports.emplace_back(FieldReport{.settings = fields[field].settings});
    const std::optional<double> fixed = fixed_offset(report.settings);
    for (const ModelDescription* model : models) {
      if (!model->fields[field].error.empty()) continue;
      ++report.models;
      report.seconds += model->fields[field].seconds;
      const std::optional<double> chosen = model->fields[field].offset;
      if (offset_leaks(model->diagnostics, chosen ? chosen : fixed)) ++report.leaking;
      for (const auto& [outcome, count] : model->fields[field].outcomes) report.outcomes[outcome] += count;
    }
  }
  return reports;
}

std::string perturbation_note(std::span<const std::string> names, std::span<const std::vector<std::string>> remarks,
                              std::string_view noun) {
  const auto fell_short = [](const std::vector<std::string>& of_shape) { return !of_shape.empty(); };
  const auto first = std::ranges::find_if(remarks, fell_short);
  if (first == remarks.end()) return {};
  return fmt::format("{} of {} {}s were not perturbed as requested; the first, {}: {}",
                     std::ranges::count_if(remarks, fell_short), remarks.size(), noun,
                     printable(names[static_cast<std::size_t>(first - remarks.begin())], 100), fmt::join(*first, "; "));
}

std::vector<std::string> field_warnings(std::span<const FieldReport> fields) {
  std::vector<std::string> warnings;
  for (const FieldReport& field : fields) {
    if (field.leaking > 0) {
      warnings.push_back(fmt::format(
          "{} of {} shapes have gaps wider than the offset of the field {}: the offset surface leaks into them; use a "
          "larger offset{}",
          field.leaking, field.models, to_json(field.settings).dump(),
          fixed_offset(field.settings) ? R"( or "auto")" : ""));
    }
    for (const std::string& warning : outcome_warnings(field.outcomes)) {
      warnings.push_back(fmt::format("{} in the field {}", warning, to_json(field.settings).dump()));
    }
  }
  return warnings;
}

nlohmann::ordered_json diagnostics_json(const ShapeDiagnostics& diagnostics) {
  // A positive length implies a positive diagonal.
  const auto fraction = [&](double length) { return length > 0 ? length / diagnostics.diagonal : 0; };
  return {{"closed", diagnostics.closed},
          {"vertices", diagnostics.vertices},
          {"unreferenced_vertices", diagnostics.unreferenced_vertices},
          {"coincident_vertices", diagnostics.coincident_vertices},
          {"diagonal", diagnostics.diagonal},
          {"triangles", diagnostics.triangles},
          {"area", diagnostics.area},
          {"degenerate_triangles", diagnostics.degenerate_triangles},
          {"duplicate_triangles", diagnostics.duplicate_triangles},
          {"components", diagnostics.components},
          {"edges", diagnostics.edges},
          {"boundary_edges", diagnostics.boundary_edges},
          {"boundary_length", diagnostics.boundary_length},
          {"boundary_fraction", fraction(diagnostics.boundary_length)},
          {"non_manifold_edges", diagnostics.non_manifold_edges},
          {"inconsistent_edges", diagnostics.inconsistent_edges},
          {"gap_size", diagnostics.gap_size},
          {"gap_fraction", fraction(diagnostics.gap_size)},
          {"outliers", diagnostics.outliers},
          {"stray_normals", diagnostics.stray_normals},
          {"point_spacing", diagnostics.point_spacing},
          {"noisy", diagnostics.noisy},
          {"noise_fraction", fraction(diagnostics.noise_deviation)}};
}

namespace {

/// Returns a field's name for headers: its type and other settings, such as "offset_sdf at=faces offset=0.05".
std::string name_of(const FieldReport& field) {
  std::string name = field.settings.type;
  const nlohmann::json settings = to_json(field.settings);
  for (const auto& [key, value] : settings.items()) {
    if (key != "type") name += fmt::format(" {}={}", key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  return name;
}

bool has_offset(const FieldReport& field) { return field.settings.values.find("offset") != nullptr; }

void append_header(std::vector<std::string>& header, const PreparationOptions& preparation,
                   std::span<const FieldReport> fields) {
  const nlohmann::ordered_json diagnostics = diagnostics_json({});
  for (const auto& [name, value] : diagnostics.items()) header.push_back(name);
  header.emplace_back("area scaled to 1");
  if (preparation.denoise) header.insert(header.end(), {"noise", "smoothing pass band"});
  for (const FieldReport& field : fields) {
    if (has_offset(field) && !fixed_offset(field.settings))
      header.push_back(fmt::format("{}: chosen offset", name_of(field)));
    for (const auto& [outcome, count] : field.outcomes) {
      header.push_back(fmt::format("{}: {}", name_of(field), outcome));
    }
  }
}

void append_report(std::vector<std::string>& row, const ModelDescription& shape, const PreparationOptions& preparation,
                   std::span<const FieldReport> fields) {
  row.push_back(fmt::format("{}", fmt::join(shape.chosen, " ")));
  const nlohmann::ordered_json diagnostics = diagnostics_json(shape.diagnostics);
  for (const auto& [name, value] : diagnostics.items()) row.push_back(value.dump());
  row.push_back(fmt::format("{}", shape.area));
  if (preparation.denoise) {
    row.push_back(fmt::format("{:.4g}", shape.noise));
    row.push_back(fmt::format("{:.4g}", shape.pass_band));
  }
  for (std::size_t field = 0; field < fields.size(); ++field) {
    if (const auto& offset = shape.fields[field].offset) row.push_back(fmt::format("{:.6g}", *offset));
    for (const auto& [outcome, sum] : fields[field].outcomes) {
      const FieldOutcomes& of_shape = shape.fields[field].outcomes;
      const auto count = of_shape.find(outcome);
      row.push_back(std::to_string(count == of_shape.end() ? 0 : count->second));
    }
  }
}

}  // namespace

TextTable with_shape_reports(TextTable table, std::span<const ModelDescription> shapes,
                             const PreparationOptions& preparation, std::span<const FieldReport> fields) {
  table.text_columns = table.header.size() + 1;
  table.header.emplace_back("choices");
  append_header(table.header, preparation, fields);
  for (std::size_t i = 0; i < shapes.size(); ++i) append_report(table.rows[i], shapes[i], preparation, fields);
  return table;
}

TextTable shapes_table(std::span<const Model> models, std::span<const std::string> classes,
                       std::span<const ModelDescription> shapes, const PreparationOptions& preparation,
                       std::span<const FieldReport> fields) {
  TextTable table{.header = {"id", "class"}, .rows = {}};
  for (const Model& model : models) table.rows.push_back({model.id, classes[static_cast<std::size_t>(model.label)]});
  return with_shape_reports(std::move(table), shapes, preparation, fields);
}

TextTable shape_seconds_table(std::span<const Model> models, std::span<const ModelDescription> shapes,
                              std::span<const FieldReport> fields, std::span<const SignatureConfiguration> signatures) {
  TextTable table{.header = {"id"}, .rows = {}, .text_columns = 1};
  for (const FieldReport& field : fields) table.header.push_back(name_of(field));
  for (const SignatureConfiguration& signature : signatures) {
    if (signature.descriptor) table.header.push_back(signature.name);
  }
  for (std::size_t i = 0; i < models.size(); ++i) {
    auto& row = table.rows.emplace_back();
    row.push_back(models[i].id);
    for (const FieldDescription& field : shapes[i].fields) row.push_back(fmt::format("{:.6f}", field.seconds));
    for (std::size_t s = 0; s < signatures.size(); ++s) {
      if (signatures[s].descriptor) row.push_back(fmt::format("{:.6f}", shapes[i].features[s].seconds));
    }
  }
  return table;
}

nlohmann::ordered_json fields_json(std::span<const FieldReport> fields) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const FieldReport& field : fields) {
    nlohmann::ordered_json entry{{"field", to_json(field.settings)}, {"samples", field.outcomes}};
    if (has_offset(field)) entry["shapes_with_gaps_wider_than_offset"] = field.leaking;
    list.push_back(std::move(entry));
  }
  return list;
}

nlohmann::ordered_json execution_json(int threads, std::span<const std::pair<std::string, double>> timings,
                                      std::span<const FieldReport> fields, const CacheReport& cache) {
  nlohmann::ordered_json seconds = nlohmann::ordered_json::object();
  for (const auto& [stage, time] : timings) seconds[stage] = time;
  nlohmann::ordered_json by_field = nlohmann::ordered_json::array();
  for (const FieldReport& field : fields) {
    by_field.push_back({{"field", to_json(field.settings)}, {"seconds", field.seconds}});
  }
  return {{"threads", threads},
          {"seconds", std::move(seconds)},
          {"field_seconds", std::move(by_field)},
          {"cache", cache_json(cache)}};
}

}  // namespace shapegauge
