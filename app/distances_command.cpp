// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <string>

#include "app/commands.h"
#include "app/help_format.h"
#include "app/options.h"
#include "app/parameter_options.h"
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/output_files.h"
#include "shapegauge/datasets/files/matrix_files.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"
#include "shapegauge/retrieval/feature_checks.h"

namespace shapegauge {

namespace {

struct DistancesArguments {
  std::filesystem::path features;
  std::filesystem::path output;
  std::string distance;
  bool replace = false;
  int threads = 0;
};

int run(const DistancesArguments& arguments) {
  const OutputFile output{.path = arguments.output, .what = "--output", .extensions = {".npy", ".csv"}};
  check_output_files({&arguments.features, 1}, {&output, 1}, arguments.replace);
  const LabelledTable table = read_matrix(arguments.features, TableShape::any);
  const DistanceMatrix distances = with_source(arguments.features.string(), [&] {
    if (const auto warning = check_features(table.numbers)) warn(*warning);
    return feature_distances(arguments.distance, table.numbers.cast<float>());
  });
  write_distance_matrix(arguments.output, distances, table.row_ids);
  return exit_success;
}

}  // namespace

void add_distances_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("distances", "Compute the distance matrix of features");
  command->footer(
      "Example: shapegauge distances features.csv -o distances.csv --distance light_field\nCSV keeps the ids of the "
      "rows.");
  const auto arguments = std::make_shared<DistancesArguments>();
  command
      ->add_option("features", arguments->features,
                   fmt::format("Features, one row per model: {}; .npy and text may be compressed (.gz)",
                               fmt::join(matrix_extensions(), ", ")))
      ->required();
  begin_option_group(*command, output_options);
  command->add_option("-o,--output", arguments->output, "Output file: .npy, or .csv (with ids)")->required();
  add_replace_option(*command, arguments->replace);
  begin_option_group(*command, "Method");
  command
      ->add_option(
          "--distance", arguments->distance,
          "Distance between rows of features, required to read features; a descriptor's name, such as d2, selects "
          "its own distance")
      ->check(one_of(feature_distance_names()))
      ->required();
  add_threads_option(*command, arguments->threads);
  command->callback([arguments, &status] { with_threads(arguments->threads, [&] { status = run(*arguments); }); });
}

}  // namespace shapegauge
