// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/retrieval/write_results.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/engine/result_folder.h"
#include "shapegauge/experiments/evaluation/evaluate_files.h"
#include "shapegauge/experiments/results/evaluation_tables.h"
#include "shapegauge/experiments/retrieval/experiment_report.h"
#include "shapegauge/experiments/retrieval/manifest_entries.h"
#include "shapegauge/experiments/retrieval/run_experiment.h"
#include "shapegauge/experiments/retrieval/run_methods.h"
#include "shapegauge/experiments/signatures/shape_reports.h"
#include "shapegauge/pages/report.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

using OrderedJson = nlohmann::ordered_json;

std::vector<NamedEvaluation> all_evaluations(const ExperimentResults& results) {
  std::vector<NamedEvaluation> all;
  for (const MethodResults& method : results.methods) {
    for (const Evaluation& evaluation : method.evaluations)
      all.push_back({.method = method.name, .evaluation = &evaluation, .failed = method.failures.size()});
  }
  return all;
}

/// By method and protocol: the number of tied queries, and FT in percent with tied relevant models last and first.
OrderedJson ties_json(std::span<const NamedEvaluation> evaluations) {
  OrderedJson rows = OrderedJson::array();
  for (const NamedEvaluation& named : evaluations) {
    const Evaluation& evaluation = *named.evaluation;
    rows.push_back({{"method", named.method},
                    {"protocol", name_of(evaluation.protocol)},
                    {"queries", evaluation.queries.size()},
                    {"queries_with_ties", evaluation.queries_with_ties},
                    {"FT_pessimistic", 100 * evaluation.first_tier_bounds.pessimistic},
                    {"FT_optimistic", 100 * evaluation.first_tier_bounds.optimistic}});
  }
  return rows;
}

std::string summary_json(const ExperimentResults& results, std::span<const NamedEvaluation> evaluations) {
  OrderedJson rows = OrderedJson::array();
  for (const auto& [method, evaluation, intervals, failed] : evaluations) {
    for (const bool micro : {true, false}) {
      OrderedJson row{
          {"method", method}, {"protocol", name_of(evaluation->protocol)}, {"average", micro ? "micro" : "macro"}};
      if (failed > 0) row["failed"] = failed;
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
  const OrderedJson json{{"name", results.configuration.name},
                         {"unit", "percent"},
                         {"ties", name_of(results.configuration.evaluation.ties)},
                         {"tied", ties_json(evaluations)},
                         {"confidence", IntervalOptions().confidence},
                         {"rows", std::move(rows)}};
  return json_text(json, 2) + "\n";
}

bool has_descriptor(const SignatureConfiguration& signature) { return signature.descriptor.has_value(); }

/// Removes a column of words if all rows have the same.
void remove_if_constant(TextTable& table, std::string_view title) {
  const auto column = std::ranges::find(table.header, title) - table.header.begin();
  const auto at = [&](const std::vector<std::string>& row) { return row[static_cast<std::size_t>(column)]; };
  if (std::ranges::any_of(table.rows, [&](const auto& row) { return at(row) != at(table.rows.front()); })) return;
  table.header.erase(table.header.begin() + column);
  for (std::vector<std::string>& row : table.rows) row.erase(row.begin() + column);
  --table.text_columns;
}

/// Formats the summary for a paper, without repetition.
std::string latex_summary(std::span<const NamedEvaluation> evaluations) {
  TextTable table = merge_equal_averages(summary_table(evaluations));
  table.emphases.clear();
  const auto words = static_cast<std::size_t>(std::ranges::find(table.header, "protocol") - table.header.begin());
  for (const char* title : {"protocol", "average"}) remove_if_constant(table, title);
  embolden_best(table, words);
  return to_latex(table);
}

/// Returns the text files of the results by name.
std::vector<std::pair<std::string, std::string>> text_files(const ExperimentResults& results,
                                                            std::span<const NamedEvaluation> evaluations) {
  std::vector<std::string> ids;
  for (const Model& model : results.models) ids.push_back(model.id);
  const TextTable rounded = summary_table(evaluations);
  const std::string id_lines = fmt::format("{}\n", fmt::join(ids, "\n"));
  std::vector<std::pair<std::string, std::string>> files{
      {"summary.csv", to_csv(summary_table(evaluations, {.percent = true, .decimals = 4}))},
      {"summary.json", summary_json(results, evaluations)},
      {"summary.md", to_markdown(rounded)},
      {"summary.tex", latex_summary(evaluations)},
      {"intervals.csv", to_csv(intervals_table(evaluations))},
      {"per_class.csv", to_csv(per_class_table(evaluations, results.classes))},
      {"per_query.csv", to_csv(per_query_table(evaluations, ids, results.classes))},
      {"pr_curves.csv", to_csv(precision_recall_table(evaluations))},
      {"shapes.csv", to_csv(shapes_table(results.models, results.classes, results.shapes,
                                         results.configuration.preparation, results.fields))},
      {"shape_seconds.csv",
       to_csv(shape_seconds_table(results.models, results.shapes, results.fields, results.configuration.signatures))}};
  if (results.configuration.keep_distances) files.emplace_back(fmt::format("distances/{}", stored_ids_name), id_lines);
  if (std::ranges::any_of(results.configuration.signatures, has_descriptor)) {
    files.emplace_back(fmt::format("features/{}", stored_ids_name), id_lines);
  }
  return files;
}

/// Returns the files of that kind, one per method.
std::vector<std::string> method_files(const char* kind, const Configuration& configuration) {
  std::vector<std::string> names;
  for (const SignatureConfiguration& signature : configuration.signatures) names.push_back(signature.name);
  std::vector<std::string> files;
  for (const std::string& name : file_safe_names(names)) files.push_back(fmt::format("{}/{}.npy", kind, name));
  return files;
}

/// Writes the features of descriptor methods. Returns the files' names.
std::vector<std::string> write_features(const fs::path& folder, const ExperimentResults& results) {
  const std::vector<std::string> names = method_files("features", results.configuration);
  std::vector<std::string> files;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!has_descriptor(results.configuration.signatures[i])) continue;
    files.push_back(names[i]);
    write_npy(folder / names[i], results.methods[i].signatures.cast<double>());
  }
  return files;
}

}  // namespace

std::vector<std::string> distance_files(const Configuration& configuration) {
  return configuration.keep_distances ? method_files("distances", configuration) : std::vector<std::string>();
}

RunOutcome write_results(const RunResults& to, const ExperimentResults& results, bool bold) {
  to.manifest = manifest_entries(results);
  to.execution = execution_json(results.threads, results.timings, results.fields, results.cache);
  std::vector<NamedEvaluation> evaluations = all_evaluations(results);
  RunOutcome outcome{.summary = to_plain_text(merge_equal_averages(summary_table(evaluations)), bold),
                     .warnings = run_warnings(results),
                     .left_out = results.failures,
                     .incomplete = incomplete_methods(results),
                     .used = results.models.size(),
                     .cache = results.cache};
  std::vector<std::string> ids;
  std::vector<std::vector<std::string>> remarks;
  for (const Model& model : results.models) ids.push_back(model.id);
  for (const ModelDescription& shape : results.shapes) remarks.push_back(shape.remarks);
  for (std::string note : {skipped_text(results.skipped), note_on_shapes(ids, remarks, outcome.noun, not_perturbed)}) {
    if (!note.empty()) outcome.notes.push_back(std::move(note));
  }
  for (NamedEvaluation& named : evaluations) named.intervals = intervals_of(*named.evaluation);
  for (const auto& [name, text] : text_files(results, evaluations)) {
    make_folder((to.folder / name).parent_path());
    write_file_atomically(to.folder / name, text);
    outcome.files.push_back(name);
  }
  for (const std::vector<std::string>& more :
       {distance_files(results.configuration), write_features(to.folder, results)}) {
    outcome.files.insert(outcome.files.end(), more.begin(), more.end());
  }
  if (results.configuration.report.enabled) {
    write_file_atomically(to.folder / report_name, report_page(experiment_report(results, evaluations)));
    outcome.files.emplace_back(report_name);
  }
  return outcome;
}

namespace {

RunOutcome run_retrieval(const Configuration& configuration, const RunContext& context, const RunResults& to) {
  std::vector<fs::path> files;
  for (const std::string& file : method_files("distances", configuration)) files.push_back(to.folder / file);
  if (configuration.keep_distances) make_folder(to.folder / "distances");
  const ExperimentResults results = run_experiment(configuration, context, files);
  RunOutcome outcome;
  with_threads(context.control.threads, [&] { outcome = write_results(to, results, context.control.bold); });
  return outcome;
}

nlohmann::json inputs_of(const Configuration& configuration, int threads) {
  nlohmann::json inputs;
  with_threads(threads, [&] {
    const Dataset dataset = find_dataset(configuration.location.value());
    check_queries(dataset.models, configuration.evaluation);
    inputs = dataset_inputs(configuration, dataset.models);
  });
  return inputs;
}

Experiment read_retrieval(const nlohmann::json& document, const std::string& source, const fs::path& folder) {
  return retrieval_experiment(configuration_from_json(document, source, folder));
}

}  // namespace

Experiment retrieval_experiment(Configuration configuration) {
  Experiment experiment{
      .name = configuration.name, .configuration = [configuration] { return to_json(configuration); }, .run = {}};
  if (configuration.location) {
    experiment.input_paths = {configuration.location->root, configuration.location->classification};
    experiment.inputs = [configuration](int threads) { return inputs_of(configuration, threads); };
  }
  experiment.run_part = [configuration](const RunContext& context, const Part& part) {
    return run_part_of_experiment(configuration, context, part);
  };
  experiment.run = [configuration = std::move(configuration)](const RunContext& context, const RunResults& to) {
    return run_retrieval(configuration, context, to);
  };
  return experiment;
}

ExperimentKind retrieval_kind() {
  return {.name = "retrieval",
          .description = "Signatures of the models of a data set, their distances, and what these are worth.",
          .keys = {"dataset", "signatures"},
          .paths = retrieval_paths(),
          .schema =
              [] {
                return OrderedJson{{"$ref", "#/definitions/retrieval_experiment"}};
              },
          .read = read_retrieval};
}

}  // namespace shapegauge
