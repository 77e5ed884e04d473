#include "shapegauge/experiments/results/write_results.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/experiments/files/npy.h"
#include "shapegauge/experiments/report/report.h"
#include "shapegauge/experiments/results/evaluation_tables.h"
#include "shapegauge/experiments/results/manifest.h"
#include "shapegauge/experiments/results/result_folder.h"
#include "shapegauge/experiments/results/shape_tables.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

using OrderedJson = nlohmann::ordered_json;

std::vector<NamedEvaluation> all_evaluations(const ExperimentResults& results) {
  std::vector<NamedEvaluation> all;
  for (const MethodResults& method : results.methods) {
    for (const Evaluation& evaluation : method.evaluations)
      all.push_back({.method = method.name, .evaluation = &evaluation});
  }
  return all;
}

std::string summary_json(const ExperimentResults& results, std::span<const NamedEvaluation> evaluations) {
  OrderedJson rows = OrderedJson::array();
  for (const auto& [method, evaluation, intervals] : evaluations) {
    for (const bool micro : {true, false}) {
      OrderedJson row{
          {"method", method}, {"protocol", name_of(evaluation->protocol)}, {"average", micro ? "micro" : "macro"}};
      const Eigen::VectorXd& values = micro ? evaluation->micro : evaluation->macro;
      for (std::size_t i = 0; i < evaluation->measures.size(); ++i) {
        row[evaluation->measures[i]] = 100 * values[static_cast<Eigen::Index>(i)];
      }
      const std::vector<ConfidenceInterval>& of_average = micro ? intervals.micro : intervals.macro;
      for (std::size_t i = 0; i < of_average.size(); ++i) {
        row["intervals"][evaluation->measures[i]] = {100 * of_average[i].low, 100 * of_average[i].high};
      }
      rows.push_back(std::move(row));
    }
  }
  return OrderedJson{{"name", results.configuration.name},
                     {"unit", "percent"},
                     {"ties", name_of(results.configuration.ties)},
                     {"confidence", IntervalOptions().confidence},
                     {"rows", std::move(rows)}}
             .dump(2) +
         "\n";
}

/// The text files of the results by name.
std::vector<std::pair<std::string, std::string>> text_files(const ExperimentResults& results) {
  std::vector<NamedEvaluation> evaluations = all_evaluations(results);
  for (NamedEvaluation& named : evaluations) named.intervals = intervals_of(*named.evaluation);
  std::vector<std::string> ids;
  for (const Model& model : results.models) ids.push_back(model.id);
  const Table rounded = summary_table(evaluations);
  return {{"summary.csv", to_csv(summary_table(evaluations, {.percent = true, .decimals = 4}))},
          {"summary.json", summary_json(results, evaluations)},
          {"summary.md", to_markdown(rounded)},
          {"summary.tex", to_latex(rounded)},
          {"intervals.csv", to_csv(intervals_table(evaluations))},
          {"per_class.csv", to_csv(per_class_table(evaluations, results.classes))},
          {"per_query.csv", to_csv(per_query_table(evaluations, ids, results.classes))},
          {"pr_curves.csv", to_csv(precision_recall_table(evaluations))},
          {"shapes.csv", to_csv(shapes_table(results))},
          {"shape_seconds.csv", to_csv(shape_seconds_table(results))}};
}

/// A name for the files of each method.
std::vector<std::string> method_files(const ExperimentResults& results) {
  std::vector<std::string> names;
  for (const MethodResults& method : results.methods) names.push_back(method.name);
  return file_safe_names(names);
}

/// Writes the distances of all methods, and the features of those that are descriptors. Returns the files' names.
std::vector<std::string> write_matrices(const fs::path& folder, const ExperimentResults& results) {
  const std::vector<std::string> names = method_files(results);
  std::vector<std::string> files;
  const auto write = [&](const char* kind, const std::string& name, const DistanceMatrix& matrix) {
    make_folder(folder / kind);
    files.push_back(fmt::format("{}/{}.npy", kind, name));
    write_npy(folder / files.back(), matrix);
  };
  for (std::size_t i = 0; i < names.size(); ++i) write("distances", names[i], results.methods[i].distances);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!results.configuration.signatures[i].descriptor) continue;
    write("features", names[i], results.methods[i].signatures.cast<double>());
  }
  return files;
}

}  // namespace

void write_results(const fs::path& destination, const ExperimentResults& results) {
  StagedResults staged(destination);
  const fs::path& folder = staged.folder();
  std::vector<std::string> files;
  for (const auto& [name, text] : text_files(results)) {
    write_file_atomically(folder / name, text);
    files.push_back(name);
  }
  const std::vector<std::string> matrices = write_matrices(folder, results);
  files.insert(files.end(), matrices.begin(), matrices.end());
  if (results.configuration.report.wanted) {
    write_file_atomically(folder / report_name, report_page(report_of(results)));
    files.emplace_back(report_name);
  }
  write_file_atomically(folder / manifest_name, manifest(results, files, folder).dump(2) + "\n");
  staged.publish(files);
}

std::string summary_text(const ExperimentResults& results) {
  return to_plain_text(summary_table(all_evaluations(results)));
}

}  // namespace shapegauge
