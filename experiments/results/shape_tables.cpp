#include "shapegauge/experiments/results/shape_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>
#include <vector>

#include "shapegauge/experiments/results/diagnostics_json.h"

namespace shapegauge {

namespace {

/// A field's name in a header: its type, then its other settings, for example "offset_sdf at=faces offset=0.05".
std::string name_of(const FieldReport& field) {
  std::string name = field.settings.at("type");
  for (const auto& [key, value] : field.settings.items()) {
    if (key != "type") name += fmt::format(" {}={}", key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  return name;
}

bool chooses_offset(const FieldReport& field) { return field.settings.value("offset", nlohmann::json()).is_string(); }

std::vector<std::string> shapes_header(const ExperimentResults& results) {
  std::vector<std::string> header{"id", "class", "choices"};
  const nlohmann::ordered_json diagnostics = diagnostics_json({});
  for (const auto& [name, value] : diagnostics.items()) header.push_back(name);
  if (results.configuration.preparation.denoise) header.insert(header.end(), {"noise", "smoothing pass band"});
  for (const FieldReport& field : results.fields) {
    if (chooses_offset(field)) header.push_back(fmt::format("{}: chosen offset", name_of(field)));
    for (const auto& [outcome, count] : field.outcomes) {
      header.push_back(fmt::format("{}: {}", name_of(field), outcome));
    }
  }
  return header;
}

}  // namespace

Table shapes_table(const ExperimentResults& results) {
  Table table{.header = shapes_header(results), .rows = {}, .text_columns = 3};
  for (std::size_t i = 0; i < results.models.size(); ++i) {
    const Model& model = results.models[i];
    const ShapeReport& shape = results.shapes[i];
    auto& row = table.rows.emplace_back();
    row = {model.id, results.classes[static_cast<std::size_t>(model.label)],
           fmt::format("{}", fmt::join(shape.chosen, " "))};
    const nlohmann::ordered_json diagnostics = diagnostics_json(shape.diagnostics);
    for (const auto& [name, value] : diagnostics.items()) row.push_back(value.dump());
    if (results.configuration.preparation.denoise) {
      row.push_back(fmt::format("{:.4g}", shape.noise));
      row.push_back(fmt::format("{:.4g}", shape.pass_band));
    }
    for (std::size_t field = 0; field < results.fields.size(); ++field) {
      if (const auto& offset = shape.offsets[field]) row.push_back(fmt::format("{:.6g}", *offset));
      for (const auto& [outcome, sum] : results.fields[field].outcomes) {
        const auto count = shape.outcomes[field].find(outcome);
        row.push_back(std::to_string(count == shape.outcomes[field].end() ? 0 : count->second));
      }
    }
  }
  return table;
}

Table shape_seconds_table(const ExperimentResults& results) {
  Table table{.header = {"id"}, .rows = {}, .text_columns = 1};
  for (const FieldReport& field : results.fields) table.header.push_back(name_of(field));
  for (std::size_t i = 0; i < results.models.size(); ++i) {
    auto& row = table.rows.emplace_back();
    row.push_back(results.models[i].id);
    for (const double seconds : results.shapes[i].seconds) row.push_back(fmt::format("{:.6f}", seconds));
  }
  return table;
}

}  // namespace shapegauge
