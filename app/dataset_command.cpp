// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>

#include "app/commands.h"
#include "app/help_format.h"
#include "app/options.h"
#include "app/parameter_options.h"
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/output_files.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/datasets/files/table.h"
#include "shapegauge/datasets/generator/generate_dataset.h"
#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/engine/part.h"
#include "shapegauge/experiments/engine/run_control.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

struct LookArguments {
  fs::path folder;
  fs::path classification;
  std::string layout;
  std::string split = "all";
  std::string part;  ///< parse_part(); empty for all models
  int threads = 0;
};

struct LabelsArguments {
  std::shared_ptr<LookArguments> dataset;
  fs::path output;
  bool replace = false;
};

struct GenerateArguments {
  fs::path folder;
  ParameterTexts settings;
  bool replace = false;
  int threads = 0;
};

// Formats the data set for a configuration.
std::string proposed_configuration(const DatasetLocation& location) {
  nlohmann::ordered_json dataset{{"layout", location.layout},
                                 {"root", fs::absolute(location.root).lexically_normal().string()}};
  if (!location.classification.empty()) {
    const fs::path relative = location.classification.lexically_relative(location.root);
    const bool below = !relative.empty() && *relative.begin() != "..";
    dataset["classification"] =
        below ? relative.string() : fs::absolute(location.classification).lexically_normal().string();
  }
  if (location.split != "all") dataset["split"] = location.split;
  return fmt::format("\"dataset\": {}", json_text(dataset));
}

DatasetLocation location_of_all(const LookArguments& arguments) {
  if (arguments.layout.empty()) return recognise_dataset(arguments.folder, arguments.classification);
  DatasetLocation location{
      .layout = arguments.layout, .root = arguments.folder, .classification = arguments.classification};
  const std::string_view classification = dataset_layouts().at(arguments.layout).default_classification;
  if (location.classification.empty() && !classification.empty())
    location.classification = arguments.folder / classification;
  return location;
}

// Throws InputError for a split of a layout that has none.
DatasetLocation location_of(const LookArguments& arguments) {
  DatasetLocation location = location_of_all(arguments);
  if (arguments.split != "all" && !dataset_layouts().at(location.layout).has_splits) {
    throw InputError(
        fmt::format("{}: the layout {} has no splits; omit --split", arguments.folder.string(), location.layout));
  }
  location.split = arguments.split;
  return location;
}

int show_dataset(const LookArguments& arguments) {
  const DatasetLocation location = location_of(arguments);
  const Dataset dataset = find_dataset(location);
  const std::vector<ModelFailure> failures = check_models(dataset);
  std::vector<std::size_t> models(dataset.classes.size());
  std::vector<std::size_t> unusable(dataset.classes.size());
  for (const Model& model : dataset.models) ++models[static_cast<std::size_t>(model.label)];
  for (const ModelFailure& failure : failures) {
    ++unusable[static_cast<std::size_t>(dataset.models[failure.model].label)];
  }
  TextTable table{.header = {"class", "models"}, .rows = {}, .text_columns = 1};
  if (!failures.empty()) table.header.emplace_back("unusable");
  for (std::size_t label = 0; label < dataset.classes.size(); ++label) {
    if (models[label] == 0) continue;
    table.rows.push_back({dataset.classes[label], fmt::format("{}", models[label])});
    if (!failures.empty()) table.rows.back().push_back(fmt::format("{}", unusable[label]));
  }
  const std::string flaw = failures.empty() ? "" : fmt::format(", {} of them unusable", failures.size());
  print_output("layout {}: {} models in {} classes{}\n\n{}", location.layout, dataset.models.size(), table.rows.size(),
               flaw, to_plain_text(table));
  if (const std::string skipped = skipped_text(dataset.skipped); !skipped.empty()) print_output("\n{}\n", skipped);
  for (const ModelFailure& failure : failures) {
    warn(fmt::format("model {}: {}", dataset.models[failure.model].id, failure.message));
  }
  print_output("\nIn a configuration:\n  {}\n", printable(proposed_configuration(location)));
  if (failures.empty()) note("only headers were checked; 'dataset validate' reads complete files");
  return failures.empty() ? exit_success : exit_with_failures;
}

int validate(const LookArguments& arguments) {
  const Dataset dataset = find_dataset(location_of(arguments));
  catch_interruption();
  ProgressLine progress;
  const RunControl control{.threads = arguments.threads, .interrupted = interrupted, .progress = progress.receiver()};
  std::vector<std::size_t> models(dataset.models.size());
  std::iota(models.begin(), models.end(), std::size_t{0});
  if (!arguments.part.empty()) models = parse_part(arguments.part).of(models);
  std::vector<ModelFailure> failures;
  with_threads(arguments.threads, [&] { failures = validate_models(dataset, models, control); });
  progress.clear();
  for (const ModelFailure& failure : failures) {
    print_output("{}\n", printable(dataset.models[failure.model].id + ": " + failure.message));
  }
  print_output("{} of {} models can be used\n", models.size() - failures.size(), models.size());
  return failures.empty() ? exit_success : exit_with_failures;
}

int generate(const GenerateArguments& arguments) {
  GeneratorOptions options = options_from(
      generator_table(), parameter_values(generator_parameters(), arguments.settings, "generated data sets"));
  options.replace = arguments.replace;
  catch_interruption();
  ProgressLine progress;
  with_threads(arguments.threads, [&] {
    generate_dataset(arguments.folder, options, [&](int done, int total) {
      if (interrupted()) {
        throw Interrupted(fmt::format("interrupted; the data set in {} is incomplete; --replace replaces it",
                                      arguments.folder.string()));
      }
      progress.show("models", static_cast<std::size_t>(done), static_cast<std::size_t>(total));
    });
  });
  progress.clear();
  print_output("{} models of {} classes in {}\n", options.classes * options.models_per_class, options.classes,
               printable(arguments.folder.string()));
  return exit_success;
}

// Returns the table of models that 'evaluate --labels' reads.
TextTable label_table(const Dataset& dataset) {
  const bool has_subclasses =
      std::ranges::any_of(dataset.models, [](const Model& model) { return !model.subclass.empty(); });
  TextTable table{.header = {"id", "class"}, .rows = {}};
  if (has_subclasses) table.header.emplace_back("subclass");
  for (const Model& model : dataset.models) {
    table.rows.push_back({model.id, dataset.classes[static_cast<std::size_t>(model.label)]});
    if (has_subclasses) table.rows.back().push_back(model.subclass);
  }
  return table;
}

int print_labels(const LabelsArguments& arguments) {
  const OutputFile output{.path = arguments.output, .what = "--output", .extensions = {".csv"}};
  const DatasetLocation location = location_of(*arguments.dataset);
  check_output_files({&location.classification, 1}, {&output, 1}, arguments.replace);
  const std::string text = to_csv(label_table(find_dataset(location)));
  if (arguments.output.empty()) {
    print_output("{}", text);
  } else {
    write_file_atomically(arguments.output, text);
  }
  return exit_success;
}

std::vector<std::string> layout_names() {
  std::vector<std::string> names;
  for (const DatasetLayout& layout : dataset_layouts().entries()) names.emplace_back(layout.name);
  return names;
}

std::shared_ptr<LookArguments> add_look_arguments(CLI::App* command) {
  auto arguments = std::make_shared<LookArguments>();
  command->add_option("folder", arguments->folder, "Folder of the data set")->required();
  command->add_option("--classification", arguments->classification,
                      "File of classes, .cla or CSV (default: the layout's, such as test.cla)");
  command
      ->add_option("--layout", arguments->layout,
                   "Layout of the data set (default: detected). folders: one per class; tree: nested folders; csv: "
                   "table id,path,class; named: class in file names (cat0.off); others: benchmarks")
      ->check(one_of(layout_names()));
  command->add_option("--split", arguments->split, "Split to use; layouts shapenet and folders only")
      ->check(one_of(std::vector<std::string>(dataset_splits.begin(), dataset_splits.end())))
      ->capture_default_str();
  return arguments;
}

void add_generate(CLI::App* dataset, int& status) {
  CLI::App* command =
      dataset->add_subcommand("generate", "Generate a data set of articulated shapes in the layout of SHREC'11");
  command->footer("Example: shapegauge dataset generate shapes --classes 12 --models-per-class 10 --seed 1");
  const auto arguments = std::make_shared<GenerateArguments>();
  command->add_option("folder", arguments->folder, "Folder for the data set, created if missing")->required();
  for (const Parameter& parameter : generator_parameters()) {
    add_parameter_option(*command, parameter, arguments->settings[std::string(parameter.name)]);
  }
  command->add_flag("--replace", arguments->replace, "Delete a data set in the folder and generate a new one");
  command->add_flag("--force", arguments->replace)->group(hidden_options);  // the older name
  add_threads_option(*command, arguments->threads);
  command->callback([arguments, &status] { status = generate(*arguments); });
}

}  // namespace

void add_dataset_command(CLI::App& app, int& status) {
  CLI::App* dataset = app.add_subcommand("dataset", "Describe, validate or generate data sets");
  dataset->require_subcommand(1);
  dataset->footer("Example: shapegauge dataset info shrec11 --classification test.cla");

  CLI::App* info_command =
      dataset->add_subcommand("info", "Print classes and numbers of models; check the files' headers");
  info_command->footer("Example: shapegauge dataset info shrec11 --classification test.cla");
  const auto info_arguments = add_look_arguments(info_command);
  info_command->callback([info_arguments, &status] { status = show_dataset(*info_arguments); });

  CLI::App* validate_command = dataset->add_subcommand("validate", "Read every model and list the unusable ones");
  validate_command->footer("Example: shapegauge dataset validate shrec11");
  const auto validate_arguments = add_look_arguments(validate_command);
  add_threads_option(*validate_command, validate_arguments->threads);
  add_part_option(*validate_command, validate_arguments->part,
                  "Process only share K of N of the models (such as 1/4); auto: K and N from Slurm or mpirun");
  validate_command->callback([validate_arguments, &status] { status = validate(*validate_arguments); });

  CLI::App* labels_command =
      dataset->add_subcommand("labels", "Print the models and their classes as a table for 'evaluate --labels'");
  labels_command->footer("Example: shapegauge dataset labels shapenet --split test -o test.csv");
  const auto labels_arguments = std::make_shared<LabelsArguments>();
  labels_arguments->dataset = add_look_arguments(labels_command);
  labels_command->add_option("-o,--output", labels_arguments->output, "CSV file (default: standard output)");
  add_replace_option(*labels_command, labels_arguments->replace);
  labels_command->callback([labels_arguments, &status] { status = print_labels(*labels_arguments); });

  add_generate(dataset, status);
}

}  // namespace shapegauge
