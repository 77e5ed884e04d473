// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/multi_dataset/run_multi_dataset.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/experiments/configuration/dataset_files.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/configuration/schema.h"
#include "shapegauge/experiments/engine/manifest.h"
#include "shapegauge/experiments/engine/result_folder.h"
#include "shapegauge/experiments/results/multi_dataset_results.h"
#include "shapegauge/experiments/retrieval/write_results.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;

// Result files of the whole experiment, next to the folders of its data sets.
constexpr std::array<std::string_view, 6> result_files{"summary.csv", "summary.json", "summary.md",
                                                       "summary.tex", "pairs.csv",    report_name};

// One data set of the experiment: its experiment, or why it cannot be read.
struct DatasetPart {
  std::string name;
  std::string folder;
  Json dataset;  ///< as the configuration has it
  Experiment experiment{};
  std::string error{};
};

struct MultiDatasetExperiment {
  std::string name;
  std::string description;
  std::vector<DatasetPart> parts;
};

// The retrieval experiment on one of the data sets.
Json document_of(Json common, Json dataset, const std::string& name) {
  common.erase("datasets");
  dataset.erase("name");
  common["dataset"] = std::move(dataset);
  common["name"] = fmt::format("{}: {}", common.at("name").get<std::string>(), name);
  return common;
}

// Returns the names of the data sets' folders. Throws InputError for the name of a result file.
std::vector<std::string> folders_of_datasets(const std::vector<std::string>& names, const std::string& source) {
  std::vector<std::string> folders = file_safe_names(names);
  for (std::size_t i = 0; i < folders.size(); ++i) {
    const std::string folder = lower_case(folders[i]);
    if (folder == manifest_name || std::ranges::find(result_files, folder) != result_files.end()) {
      throw InputError(
          fmt::format("{}: datasets.{}.name: the data set {} would have its results in the folder {}, which is the "
                      "name of a result file; choose another name",
                      source, i, quoted_word(names[i]), folders[i]));
    }
  }
  return folders;
}

// Reads all data sets. One that cannot be read, as a variable is not set, is kept with its error. Throws InputError
// where all cannot.
MultiDatasetExperiment read_parts(const Json& document, const std::string& source, const fs::path& folder) {
  MultiDatasetExperiment experiment{.name = document.at("name"), .description = {}, .parts = {}};
  if (document.contains("description")) experiment.description = document.at("description");
  const std::vector<std::string> names = with_source(
      source, [&] { return at_key("datasets", [&] { return unique_names(document.at("datasets"), "datasets"); }); });
  const std::vector<std::string> folders = folders_of_datasets(names, source);
  for (std::size_t i = 0; i < names.size(); ++i) {
    DatasetPart part{.name = names[i], .folder = folders[i], .dataset = document.at("datasets")[i]};
    try {
      part.experiment = retrieval_kind().read(document_of(document, part.dataset, part.name), source, folder);
    } catch (const InputError& error) {
      // Without the source: a replay of the run has another one, and the same results.
      const std::string message = error.what();
      part.error = message.starts_with(source + ": ") ? message.substr(source.size() + 2) : message;
    }
    experiment.parts.push_back(std::move(part));
  }
  const auto readable = [](const DatasetPart& part) { return part.error.empty(); };
  if (std::ranges::none_of(experiment.parts, readable)) {
    throw InputError(fmt::format("{}: {}", source, experiment.parts.front().error));
  }
  return experiment;
}

// With all defaults, and absolute paths of the data sets that could be read.
Json configuration_of(const MultiDatasetExperiment& experiment) {
  Json configuration;
  for (const DatasetPart& part : experiment.parts) {
    if (part.error.empty() && configuration.is_null()) configuration = part.experiment.configuration();
  }
  configuration.erase("dataset");
  configuration["name"] = experiment.name;
  configuration["datasets"] = Json::array();
  for (const DatasetPart& part : experiment.parts) {
    Json dataset = part.error.empty() ? part.experiment.configuration().at("dataset") : part.dataset;
    dataset["name"] = part.name;
    configuration["datasets"].push_back(std::move(dataset));
  }
  return configuration;
}

// The inputs of a data set among those of the experiment.
void add_inputs(const Json& inputs, const std::string& name, Json& all) {
  const Json models = inputs.value("models", Json::object());
  for (const auto& [model, hash] : models.items()) {
    all["models"][fmt::format("{}: {}", name, model)] = hash;
  }
  if (inputs.contains("classification")) {
    all["models"][fmt::format("{}: classification", name)] = inputs.at("classification");
  }
}

Json inputs_of_parts(const MultiDatasetExperiment& experiment, int threads) {
  Json inputs{{"models", Json::object()}};
  for (const DatasetPart& part : experiment.parts) {
    if (!part.error.empty() || !part.experiment.inputs) continue;
    try {
      add_inputs(part.experiment.inputs(threads), part.name, inputs);
    } catch (const InputError&) {
      continue;  // the run says what is wrong with the data set
    }
  }
  return inputs;
}

// A run of the experiment.
class MultiDatasetRun {
 public:
  MultiDatasetRun(const MultiDatasetExperiment& experiment, const RunContext& context, const RunResults& to)
      : experiment_(&experiment), context_(&context), to_(&to) {
    results_.name = experiment.name;
    results_.description = experiment.description;
  }

  RunOutcome run() {
    to_->manifest = {{"inputs", {{"models", Json::object()}}}, {"data_sets", Json::object()}};
    outcome_.noun = "input";
    const Stopwatch stopwatch;
    for (const DatasetPart& part : experiment_->parts) run_part(part);
    if (results_.datasets.empty()) throw InputError(no_data_set());
    write();
    return std::move(outcome_);
  }

 private:
  // A failure leaves the data set out.
  void run_part(const DatasetPart& part) {
    if (!part.error.empty()) return leave_out(part, part.error);
    OrderedJson manifest;
    OrderedJson execution;
    const RunResults to{.folder = to_->folder / part.folder, .manifest = manifest, .execution = execution};
    try {
      make_folder(to.folder);
      add(part, to,
          part.experiment.run(
              {.control = context_->control, .cache = context_->cache, .generated = context_->generated / part.folder},
              to));
    } catch (const InputError& error) {
      leave_out(part, error.what());
    }
  }

  void leave_out(const DatasetPart& part, const std::string& reason) {
    results_.failures.emplace_back(part.name, reason);
    outcome_.left_out.push_back({.id = part.name, .message = reason});
  }

  void add(const DatasetPart& part, const RunResults& to, const RunOutcome& outcome) {
    const OrderedJson manifest = manifest_of(part.experiment, to, outcome.files);
    write_file_atomically(to.folder / manifest_name, json_text(manifest, 2) + "\n");
    const bool has_report = std::ranges::find(outcome.files, report_name) != outcome.files.end();
    results_.datasets.push_back({.name = part.name,
                                 .folder = part.folder,
                                 .page = has_report ? fmt::format("{}/{}", part.folder, report_name) : "",
                                 .models = outcome.used,
                                 .scores = read_method_scores(to.folder / "per_query.csv")});
    for (const std::string& file : outcome.files) outcome_.files.push_back(part.folder + "/" + file);
    outcome_.files.push_back(fmt::format("{}/{}", part.folder, manifest_name));
    for (const std::string& note : outcome.notes) outcome_.notes.push_back(fmt::format("{}: {}", part.name, note));
    for (const std::string& warning : outcome.warnings) {
      outcome_.warnings.push_back(fmt::format("{}: {}", part.name, warning));
    }
    for (const std::string& sentence : outcome.incomplete) {
      outcome_.incomplete.push_back(fmt::format("{}: {}", part.name, sentence));
    }
    for (const LeftOutShape& shape : outcome.left_out) {
      outcome_.left_out.push_back({.id = fmt::format("{}, model {}", part.name, shape.id), .message = shape.message});
    }
    outcome_.used += outcome.used;
    outcome_.cache = outcome.cache;  // counts all so far
    add_inputs(to.manifest.at("inputs"), part.name, inputs_);
    to.manifest.erase("inputs");
    to_->manifest["data_sets"][part.name] = std::move(to.manifest);
    to_->execution[part.name] = std::move(to.execution);
  }

  [[nodiscard]] std::string no_data_set() const {
    std::string message = "no data set can be used";
    for (const auto& [name, reason] : results_.failures) message += fmt::format("; {}: {}", name, reason);
    return message;
  }

  void write() {
    results_.methods.clear();
    const std::vector<MethodScores>& scores = results_.datasets.front().scores;
    for (const MethodScores& one : scores) {
      if (one.protocol == scores.front().protocol) results_.methods.push_back(one.method);
    }
    const std::vector<std::string>& measures = scores.front().measures;
    const bool has_map = std::ranges::find(measures, "mAP") != measures.end();
    results_.main_measure = has_map ? "mAP" : measures.front();
    results_.tables = multi_dataset_tables(results_.datasets, results_.alpha);
    const MultiDatasetTable& main = main_table(results_);
    const TextTable summary = multi_dataset_summary(results_, main);
    const std::array<std::string, result_files.size()> texts{to_csv(multi_dataset_csv_table(results_)),
                                                             json_text(multi_dataset_json(results_), 2) + "\n",
                                                             to_markdown(summary),
                                                             to_latex(summary),
                                                             to_csv(multi_dataset_pairs_table(results_)),
                                                             multi_dataset_html(results_)};
    for (std::size_t i = 0; i < texts.size(); ++i) {
      write_file_atomically(to_->folder / result_files[i], texts[i]);
      outcome_.files.emplace_back(result_files[i]);
    }
    to_->manifest["inputs"] = inputs_;
    to_->manifest["failed_models"] = failures_json(outcome_.left_out);
    outcome_.summary = fmt::format("{} ({}, {}), percent\n{}\n{}\n", main.measure, main.protocol, name_of(main.average),
                                   to_plain_text(summary, context_->control.bold), test_words(results_, main));
  }

  const MultiDatasetExperiment* experiment_;
  const RunContext* context_;
  const RunResults* to_;
  MultiDatasetResults results_;
  RunOutcome outcome_;
  Json inputs_{{"models", Json::object()}};
};

// Computes a part of the run on each data set.
PartOutcome run_part_of_each(const MultiDatasetExperiment& experiment, const RunContext& context, const Part& part) {
  PartOutcome outcome;
  for (const DatasetPart& dataset : experiment.parts) {
    if (!dataset.error.empty()) continue;  // the run says so
    try {
      const PartOutcome of_dataset = dataset.experiment.run_part(
          {.control = context.control, .cache = context.cache, .generated = context.generated / dataset.folder}, part);
      outcome.shapes += of_dataset.shapes;
      outcome.all += of_dataset.all;
      outcome.rows += of_dataset.rows;
      for (const LeftOutShape& shape : of_dataset.left_out) {
        outcome.left_out.push_back(
            {.id = fmt::format("{}, model {}", dataset.name, shape.id), .message = shape.message});
      }
    } catch (const InputError& error) {
      outcome.left_out.push_back({.id = dataset.name, .message = error.what()});
    }
  }
  return outcome;
}

const DocumentPaths& multi_dataset_paths() {
  static const DocumentPaths paths{.datasets = {"/datasets/*"}};
  return paths;
}

// The schema of retrieval experiments with a list of data sets, which have names, instead of one.
OrderedJson multi_dataset_schema() {
  const OrderedJson definitions = schema_definitions();
  OrderedJson dataset = definitions.at("dataset");
  dataset["required"] = {"name"};
  dataset["properties"]["name"] = {{"$ref", "#/definitions/plain_name"}};
  OrderedJson schema = definitions.at("retrieval_experiment");
  schema["title"] = "retrieval experiment on several data sets";
  schema["description"] = "Data sets, signatures to compare, and settings of the evaluation.";
  schema["required"] = {"name", "datasets", "signatures"};
  schema["properties"].erase("dataset");
  schema["properties"]["datasets"] = {
      {"description",
       "Data sets, or files that describe them; each has a name, and its results go to a folder of that name."},
      {"type", "array"},
      {"minItems", 1},
      {"items", {{"if", {{"type", "string"}}}, {"else", std::move(dataset)}}}};
  return schema;
}

Experiment read_multi_dataset(const Json& json, const std::string& source, const fs::path& folder) {
  Json document = json;  // read_experiment() has read files of data sets, other callers have not
  read_dataset_files(document, source, folder, multi_dataset_paths().datasets);
  check_by_schema(document, multi_dataset_schema(), source);
  const auto experiment = std::make_shared<const MultiDatasetExperiment>(read_parts(document, source, folder));
  std::vector<fs::path> input_paths;
  std::vector<std::string> result_folders;
  for (const DatasetPart& part : experiment->parts) {
    const std::vector<fs::path>& more = part.experiment.input_paths;
    input_paths.insert(input_paths.end(), more.begin(), more.end());
    result_folders.push_back(part.folder);
  }
  return {.name = experiment->name,
          .configuration = [experiment] { return configuration_of(*experiment); },
          .input_paths = std::move(input_paths),
          .result_folders = std::move(result_folders),
          .inputs = [experiment](int threads) { return inputs_of_parts(*experiment, threads); },
          .run = [experiment](const RunContext& context,
                              const RunResults& to) { return MultiDatasetRun(*experiment, context, to).run(); },
          .run_part = [experiment](const RunContext& context,
                                   const Part& part) { return run_part_of_each(*experiment, context, part); }};
}

}  // namespace

ExperimentKind multi_dataset_kind() {
  return {.name = "multi_dataset",
          .description = "One retrieval experiment on several data sets: methods by data sets, ranks and their tests.",
          .keys = {"datasets"},
          .paths = multi_dataset_paths(),
          .schema = multi_dataset_schema,
          .read = read_multi_dataset};
}

}  // namespace shapegauge
