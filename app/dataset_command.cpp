#include "app/dataset_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <memory>

#include "app/options.h"
#include "app/progress_line.h"
#include "app/run_program.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/datasets/layouts.h"
#include "shapegauge/experiments/files/table.h"
#include "shapegauge/experiments/generator/generate_dataset.h"
#include "shapegauge/experiments/runner/run_control.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

struct LookArguments {
  fs::path folder;
  fs::path classification;
  std::string layout;
  int threads = 0;
};

struct GenerateArguments {
  fs::path folder;
  GeneratorOptions options;
  int threads = 0;
};

DatasetLocation location_of(const LookArguments& arguments) {
  if (arguments.layout.empty()) return recognise_dataset(arguments.folder, arguments.classification);
  DatasetLocation location{
      .layout = arguments.layout, .root = arguments.folder, .classification = arguments.classification};
  const std::string_view usual = dataset_layout(arguments.layout).usual_classification;
  if (location.classification.empty() && !usual.empty()) location.classification = arguments.folder / usual;
  return location;
}

int info(const LookArguments& arguments) {
  const DatasetLocation location = location_of(arguments);
  const Dataset dataset = find_dataset(location);
  Table table{.header = {"class", "models"}, .rows = {}, .text_columns = 1};
  for (std::size_t label = 0; label < dataset.classes.size(); ++label) {
    const auto size = std::ranges::count(dataset.models, static_cast<int>(label), &Model::label);
    if (size > 0) table.rows.push_back({dataset.classes[label], fmt::format("{}", size)});
  }
  fmt::print("layout {}: {} models in {} classes\n\n{}", location.layout, dataset.models.size(), table.rows.size(),
             to_plain_text(table));
  const std::vector<ModelFailure> failures = check_models(dataset);
  for (const ModelFailure& failure : failures) {
    fmt::print(stderr, "shapegauge: warning: model {}: {}\n", dataset.models[failure.model].id, failure.message);
  }
  return failures.empty() ? exit_success : exit_with_failures;
}

int validate(const LookArguments& arguments) {
  const Dataset dataset = find_dataset(location_of(arguments));
  catch_interruption();
  ProgressLine progress;
  const RunControl control{.threads = arguments.threads,
                           .interrupted = interrupted,
                           .progress = [&](std::string_view stage, std::size_t done, std::size_t total) {
                             progress.show(stage, done, total);
                           }};
  std::vector<ModelFailure> failures;
  with_threads(arguments.threads, [&] { failures = validate_models(dataset, control); });
  progress.clear();
  for (const ModelFailure& failure : failures) {
    fmt::print("{}: {}\n", dataset.models[failure.model].id, failure.message);
  }
  fmt::print("{} of {} models can be used\n", dataset.models.size() - failures.size(), dataset.models.size());
  return failures.empty() ? exit_success : exit_with_failures;
}

int generate(const GenerateArguments& arguments) {
  catch_interruption();
  ProgressLine progress;
  with_threads(arguments.threads, [&] {
    generate_dataset(arguments.folder, arguments.options, [&](int done, int total) {
      if (interrupted()) throw Interrupted();
      progress.show("models", static_cast<std::size_t>(done), static_cast<std::size_t>(total));
    });
  });
  progress.clear();
  fmt::print("{} models of {} classes in {}\n", arguments.options.classes * arguments.options.models_per_class,
             arguments.options.classes, arguments.folder.string());
  return exit_success;
}

std::vector<std::string> layout_names() {
  std::vector<std::string> names;
  for (const DatasetLayout& layout : dataset_layouts()) names.emplace_back(layout.name);
  return names;
}

std::shared_ptr<LookArguments> add_look_arguments(CLI::App* command) {
  auto arguments = std::make_shared<LookArguments>();
  command->add_option("folder", arguments->folder, "Folder of the data set")->required();
  command->add_option("--classification", arguments->classification, "The .cla file or the CSV table, if elsewhere");
  command->add_option("--layout", arguments->layout, "Layout (default: told by what is there)")
      ->check(CLI::IsMember(layout_names()));
  return arguments;
}

void add_generate(CLI::App* dataset, int& status) {
  CLI::App* command = dataset->add_subcommand("generate", "Make a data set of articulated shapes in SHREC'11 layout");
  command->footer("Example: shapegauge dataset generate shapes --classes 12 --models-per-class 10 --seed 1");
  const auto arguments = std::make_shared<GenerateArguments>();
  GeneratorOptions& options = arguments->options;
  command->add_option("folder", arguments->folder, "Folder, made where absent")->required();
  command->add_option("--classes", options.classes, "Number of classes")->capture_default_str();
  command->add_option("--models-per-class", options.models_per_class, "Models of each class")->capture_default_str();
  command->add_option("--faces", options.faces, "Approximate number of triangles of a model")->capture_default_str();
  command->add_option("--seed", options.seed, "The same seed gives the same data set")->capture_default_str();
  command->add_flag("--force", options.force, "Replace a data set in the folder");
  add_threads_option(*command, arguments->threads);
  command->callback([arguments, &status] { status = generate(*arguments); });
}

}  // namespace

void add_dataset_command(CLI::App& app, int& status) {
  CLI::App* dataset = app.add_subcommand("dataset", "Look at, check or generate data sets");
  dataset->require_subcommand(1);
  dataset->footer("Example: shapegauge dataset info shrec11 --classification test.cla");

  CLI::App* info_command =
      dataset->add_subcommand("info", "Classes and numbers of models; looks at the files' headers");
  info_command->footer("Example: shapegauge dataset info shrec11 --classification test.cla");
  const auto info_arguments = add_look_arguments(info_command);
  info_command->callback([info_arguments, &status] { status = info(*info_arguments); });

  CLI::App* validate_command =
      dataset->add_subcommand("validate", "Read every model and name those that cannot be used");
  validate_command->footer("Example: shapegauge dataset validate shrec11");
  const auto validate_arguments = add_look_arguments(validate_command);
  add_threads_option(*validate_command, validate_arguments->threads);
  validate_command->callback([validate_arguments, &status] { status = validate(*validate_arguments); });

  add_generate(dataset, status);
}

}  // namespace shapegauge
