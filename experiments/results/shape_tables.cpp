#include "shapegauge/experiments/results/shape_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>
#include <utility>
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

void append_header(std::vector<std::string>& header, std::span<const FieldReport> fields) {
  const nlohmann::ordered_json diagnostics = diagnostics_json({});
  for (const auto& [name, value] : diagnostics.items()) header.push_back(name);
  for (const FieldReport& field : fields) {
    for (const auto& [outcome, count] : field.outcomes) {
      header.push_back(fmt::format("{}: {}", name_of(field), outcome));
    }
  }
}

}  // namespace

Table with_shape_reports(Table table, std::span<const ShapeReport> shapes, std::span<const FieldReport> fields) {
  table.text_columns = table.header.size() + 1;
  table.header.emplace_back("choices");
  append_header(table.header, fields);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    auto& row = table.rows[i];
    row.push_back(fmt::format("{}", fmt::join(shapes[i].chosen, " ")));
    const nlohmann::ordered_json diagnostics = diagnostics_json(shapes[i].diagnostics);
    for (const auto& [name, value] : diagnostics.items()) row.push_back(value.dump());
    for (std::size_t field = 0; field < fields.size(); ++field) {
      for (const auto& [outcome, sum] : fields[field].outcomes) {
        const auto count = shapes[i].outcomes[field].find(outcome);
        row.push_back(std::to_string(count == shapes[i].outcomes[field].end() ? 0 : count->second));
      }
    }
  }
  return table;
}

Table shapes_table(const ExperimentResults& results) {
  Table table{.header = {"id", "class"}, .rows = {}};
  for (const Model& model : results.models) {
    table.rows.push_back({model.id, results.classes[static_cast<std::size_t>(model.label)]});
  }
  return with_shape_reports(std::move(table), results.shapes, results.fields);
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
