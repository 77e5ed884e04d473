#include "shapegauge/experiments/comparison/write_comparison.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "shapegauge/core/io/atomic_file.h"
#include "shapegauge/experiments/comparison/comparison_tables.h"
#include "shapegauge/experiments/results/manifest_parts.h"
#include "shapegauge/experiments/results/result_folder.h"
#include "shapegauge/experiments/results/sha256.h"
#include "shapegauge/experiments/results/shape_tables.h"
#include "shapegauge/experiments/results/staged_results.h"

namespace shapegauge {

namespace {

using Json = nlohmann::ordered_json;

Table shapes_table(const ComparisonResults& results) {
  Table table{.header = {"shape"}, .rows = {}};
  std::vector<ShapeReport> reports;
  for (const ShapeMeasurement& shape : results.shapes) {
    table.rows.push_back({shape.name});
    reports.push_back(shape.report);
  }
  return with_shape_reports(std::move(table), reports, results.comparison.preparation, results.fields);
}

/// The tables that say how the shapes compare, by title; those without rows are left out.
std::vector<std::pair<std::string, Table>> comparing_tables(const ComparisonResults& results) {
  std::vector<std::pair<std::string, Table>> tables{
      {"Distances", distances_table(results)}, {"Errors", errors_table(results)}, {"Normals", normals_table(results)}};
  std::erase_if(tables, [](const auto& titled) { return titled.second.rows.empty(); });
  return tables;
}

std::string summary_markdown(const ComparisonResults& results) {
  std::string text = fmt::format("# {}\n", results.comparison.name);
  if (!results.comparison.description.empty()) text += fmt::format("\n{}\n", results.comparison.description);
  for (const auto& [title, table] : comparing_tables(results)) {
    text += fmt::format("\n## {}\n\n{}", title, to_markdown(table));
  }
  return text;
}

std::vector<std::pair<std::string, std::string>> text_files(const ComparisonResults& results) {
  std::vector<std::pair<std::string, std::string>> files{{"summary.md", summary_markdown(results)},
                                                         {"histograms.csv", to_csv(histograms_table(results))},
                                                         {"timings.csv", to_csv(timings_table(results))},
                                                         {"shapes.csv", to_csv(shapes_table(results))}};
  if (!results.comparison.reference) return files;
  files.emplace_back("distances.csv", to_csv(distances_table(results)));
  if (!results.comparison.registered) return files;
  files.emplace_back("errors.csv", to_csv(errors_table(results)));
  files.emplace_back("normals.csv", to_csv(normals_table(results)));
  return files;
}

Json inputs(const ComparisonResults& results) {
  Json shapes = Json::object();
  for (const ShapeMeasurement& measured : results.shapes) {
    for (const ComparedShape& shape : results.comparison.shapes) {
      if (shape.name == measured.name && !shape.generated) shapes[shape.name] = sha256_of_file(shape.file);
    }
  }
  return {{"algorithm", "SHA-256"}, {"shapes", std::move(shapes)}};
}

Json manifest(const ComparisonResults& results, const std::vector<std::string>& files,
              const std::filesystem::path& folder) {
  Json failures = Json::array();
  for (const FailedShape& failure : results.failures) {
    failures.push_back({{"shape", failure.name}, {"error", failure.message}});
  }
  Json json = program_json();
  json.update({{"configuration", to_json(results.comparison)},
               {"seed", results.comparison.seed},
               {"inputs", inputs(results)},
               {"shapes", results.shapes.size()},
               {"failed_shapes", std::move(failures)},
               {"fields", fields_json(results.fields)},
               {"files", files},
               {"outputs", outputs_json(folder, files)},
               {"execution", execution_json(results.threads, results.timings, results.fields)}});
  return json;
}

}  // namespace

void write_comparison(const std::filesystem::path& destination, const ComparisonResults& results) {
  StagedResults staged(destination);
  const std::filesystem::path& folder = staged.folder();
  std::vector<std::string> files;
  for (const auto& [name, text] : text_files(results)) {
    write_file_atomically(folder / name, text);
    files.push_back(name);
  }
  write_file_atomically(folder / manifest_name, manifest(results, files, folder).dump(2) + "\n");
  staged.publish(files);
}

std::string summary_text(const ComparisonResults& results) {
  std::string text;
  for (const auto& [title, table] : comparing_tables(results)) {
    text += fmt::format("{}\n{}\n", title, to_plain_text(table));
  }
  return text + fmt::format("Timings ({} threads)\n{}", results.threads, to_plain_text(timings_table(results)));
}

}  // namespace shapegauge
