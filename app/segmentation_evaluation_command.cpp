// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/help_format.h"
#include "app/options.h"
#include "app/parameter_options.h"
#include "app/terminal.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/output_files.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/evaluation/segmentation_benchmark.h"
#include "shapegauge/experiments/evaluation/segmentation_tables.h"
#include "shapegauge/metrics/method_comparison.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

struct SegmentationEvaluationArguments {
  std::vector<fs::path> folders;
  fs::path benchmark;
  std::string weights{word_of(SegmentationScoring{}.by)};
  bool no_cuts = false;
  std::string format = "table";
  fs::path per_mesh;
  bool replace = false;
  int threads = 0;
};

nlohmann::ordered_json json_of(const SegmentationScores& scores, const SegmentationEvaluationArguments& arguments) {
  const auto errors_json = [&](std::size_t method, int label) {
    nlohmann::ordered_json errors;
    for (const SegmentationErrorEntry& entry : segmentation_error_entries()) {
      errors[std::string(entry.name)] = scores.mean(method, entry.value, label);  // NaN becomes null
    }
    return errors;
  };
  const std::optional<MethodComparison> comparison = rand_comparison(scores);
  nlohmann::ordered_json methods = nlohmann::ordered_json::array();
  for (std::size_t m = 0; m < scores.methods.size(); ++m) {
    nlohmann::ordered_json per_class;
    for (std::size_t c = 0; c < scores.classes.size(); ++c) {
      per_class[scores.classes[c]] = errors_json(m, static_cast<int>(c));
    }
    methods.push_back({{"name", scores.methods[m]}, {"mean", errors_json(m, -1)}});
    if (comparison) {
      methods.back()["macro_rand"] = comparison->averages[static_cast<Eigen::Index>(m)];
      methods.back()["macro_rand_interval"] = {comparison->intervals[m].low, comparison->intervals[m].high};
    }
    methods.back()["per_class"] = per_class;
  }
  return {{"weights", arguments.weights}, {"meshes", scores.ids.size()}, {"methods", methods}};
}

std::string comparison_text(const SegmentationScores& scores, const MethodComparison& comparison) {
  std::string words;
  for (std::size_t m = 0; m < scores.methods.size(); ++m) {
    words += fmt::format("{}: Rand error {:.4f}, 95 % from {:.4f} to {:.4f} (mean of {} classes)\n",
                         printable(scores.methods[m]), comparison.averages[static_cast<Eigen::Index>(m)],
                         comparison.intervals[m].low, comparison.intervals[m].high, comparison.units);
  }
  return words;
}

std::string formatted_errors(const SegmentationScores& scores, const SegmentationEvaluationArguments& arguments) {
  if (arguments.format == "json") return json_text(json_of(scores, arguments), 2) + "\n";
  const auto format = value_of_word<TableFormat>(arguments.format).value();
  const auto text = [&](const TextTable& table) { return table_text(table, format); };
  if (format == TableFormat::csv || format == TableFormat::latex) return text(mean_table(scores));
  std::string result = text(mean_table(scores)) + "\n" + text(class_table(scores));
  const std::optional<MethodComparison> comparison = rand_comparison(scores);
  if (!comparison) return result;
  return result + "\n" + comparison_text(scores, *comparison) + "\n" + text(pair_table(scores, *comparison));
}

int run(const SegmentationEvaluationArguments& arguments) {
  const OutputFile output{.path = arguments.per_mesh, .what = "--per-mesh", .extensions = {".csv"}};
  check_output_files(arguments.folders, {&output, 1}, arguments.replace);
  const SegmentationBenchmark benchmark = find_segmentation_benchmark(arguments.benchmark);
  SegmentationScores scores;
  with_threads(arguments.threads, [&] {
    scores = score_segmentations(
        benchmark, arguments.folders,
        {.by = value_of_word<TriangleWeights>(arguments.weights).value(), .cuts = !arguments.no_cuts});
  });
  if (!benchmark.without_people.empty()) {
    warn(fmt::format("{} meshes without human segmentations ({}, ...) are omitted", benchmark.without_people.size(),
                     benchmark.without_people.front()));
  }
  if (!arguments.per_mesh.empty()) write_file_atomically(arguments.per_mesh, to_csv(mesh_table(scores)));
  print_output("{}", formatted_errors(scores, arguments));
  return exit_success;
}

}  // namespace

void add_segmentation_evaluation_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("evaluate-segmentation", "Evaluate segmentations against human ones");
  command->footer(
      "Example: shapegauge segment psb/off/*.off -o mine/\n         shapegauge evaluate-segmentation mine/ theirs/ "
      "--benchmark psb/\nThe row \"people\" compares human segmentations with "
      "each other.");
  const auto arguments = std::make_shared<SegmentationEvaluationArguments>();
  command->add_option("segmentations", arguments->folders,
                      "One folder per method, with segmentation N.seg for each mesh N.off (default: evaluate human "
                      "segmentations only)");
  begin_option_group(*command, input_options);
  command
      ->add_option("--benchmark", arguments->benchmark,
                   "Folder with meshes off/N.off and human segmentations seg/N/*.seg")
      ->required();
  begin_option_group(*command, "Evaluation");
  command
      ->add_option("--by", arguments->weights,
                   "Weight of a triangle. faces: 1, as in the benchmark's tables; area: its area")
      ->check(one_of(list_of_words<TriangleWeights>()))
      ->capture_default_str();
  command->add_flag("--no-cuts", arguments->no_cuts, "Omit the cut discrepancy, the slowest measure");
  begin_option_group(*command, output_options);
  add_format_option(*command, arguments->format, "Format of the printed result");
  command->add_option("--per-mesh", arguments->per_mesh, "CSV file for errors per mesh");
  add_replace_option(*command, arguments->replace);
  add_threads_option(*command, arguments->threads);
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace shapegauge
