#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <utility>

#include "app/commands.h"
#include "app/options.h"
#include "app/output_files.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/datasets/files/matrix_files.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

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
  LabelledTable table = read_number_table(arguments.features);
  DistanceMatrix distances;
  try {
    distances = feature_distances(arguments.distance, table.numbers.cast<float>());
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", arguments.features.string(), error.what()));
  }
  write_distance_matrix(arguments.output, {std::move(distances), std::move(table.row_ids)});
  return exit_success;
}

}  // namespace

void add_distances_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("distances", "Compute the distances between features: a square matrix");
  command->footer(
      "Example: shapegauge describe models/*.off --descriptor light_field -o features.csv\n"
      "         shapegauge distances features.csv -o distances.csv --distance light_field\n"
      "A descriptor's name stands for that descriptor's own distance. CSV keeps the ids of the rows.\n"
      "'shapegauge rerank' and 'shapegauge evaluate' take the matrix.");
  const auto arguments = std::make_shared<DistancesArguments>();
  command
      ->add_option("features", arguments->features,
                   "Features, a row a model: .npy, .npz, .mat, .csv, .txt or .dat; text and .npy also with .gz behind")
      ->required();
  command->add_option("-o,--output", arguments->output, "File for the distances: .npy, or .csv (with ids)")->required();
  add_replace_option(*command, arguments->replace);
  command->add_option("--distance", arguments->distance, "Distance, or descriptor whose distance it is")
      ->check(CLI::IsMember(feature_distance_names()))
      ->required();
  add_threads_option(*command, arguments->threads);
  command->callback([arguments, &status] { with_threads(arguments->threads, [&] { status = run(*arguments); }); });
}

}  // namespace shapegauge
