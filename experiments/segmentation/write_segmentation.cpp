// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/segmentation/write_segmentation.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/engine/manifest.h"
#include "shapegauge/experiments/engine/result_folder.h"
#include "shapegauge/experiments/evaluation/segmentation_tables.h"
#include "shapegauge/experiments/segmentation/part_consistency.h"
#include "shapegauge/experiments/segmentation/segmentation_report.h"
#include "shapegauge/experiments/signatures/shape_reports.h"
#include "shapegauge/segmentation/seg_file.h"

namespace shapegauge {

namespace {

using Json = nlohmann::ordered_json;

std::string summary(const SegmentationResults& results, const std::function<std::string(const TextTable&)>& text) {
  if (!results.has_people) return text(consistency_table(results));
  std::vector<std::string> tables{text(mean_table(results.scores)), text(class_table(results.scores))};
  if (const TextTable effects = perturbation_effect_table(results); !effects.rows.empty())
    tables.push_back(text(effects));
  if (const std::optional<MethodComparison> comparison = rand_comparison(results.scores)) {
    tables.push_back(text(interval_table(results.scores, *comparison)));
    tables.push_back(text(pair_table(results.scores, *comparison)));
  }
  return fmt::format("{}", fmt::join(tables, "\n"));
}

std::string summary_markdown(const SegmentationResults& results) {
  std::string text = fmt::format("# {}\n\n", markdown_text(results.experiment.name));
  if (!results.experiment.description.empty()) text += results.experiment.description + "\n\n";
  return text + summary(results, to_markdown);
}

std::vector<std::pair<std::string, std::string>> text_files(const SegmentationResults& results) {
  std::vector<std::pair<std::string, std::string>> files{
      {"summary.md", summary_markdown(results)},
      {"consistency.csv", to_csv(consistency_table(results))},
      {std::string(report_name), segmentation_page(segmentation_report(results))}};
  if (const TextTable effects = perturbation_effect_table(results); !effects.rows.empty())
    files.emplace_back("moved.csv", to_csv(effects));
  if (!results.has_people) return files;
  files.emplace_back("errors.csv", to_csv(mesh_table(results.scores)));
  files.emplace_back("classes.csv", to_csv(class_error_table(results.scores)));
  if (const std::optional<MethodComparison> comparison = rand_comparison(results.scores)) {
    files.emplace_back("means.csv", to_csv(interval_table(results.scores, *comparison)));
    files.emplace_back("pairs.csv", to_csv(pair_table(results.scores, *comparison)));
  }
  return files;
}

/// Hashes of a shape's files.
struct HashedShape {
  std::string mesh;
  std::vector<std::string> people;
};

/// Hashes the files of a shape. Files that cannot be read have empty hashes.
HashedShape hashes_of(const SegmentedModel& model) {
  HashedShape hashed{.mesh = sha256_if_readable(model.mesh), .people = {}};
  for (const std::filesystem::path& file : model.people) {
    hashed.people.push_back(sha256_of_file_if_readable(file));
  }
  return hashed;
}

/// Adds the hashes of a shape to those of "models", omitting empty ones.
void add_hashes(const SegmentedModel& model, const HashedShape& hashed, Json& models) {
  const auto add = [&](const std::string& name, const std::string& hash) {
    if (!hash.empty()) models[name] = hash;
  };
  add(model.id, hashed.mesh);
  for (std::size_t p = 0; p < model.people.size(); ++p) {
    add(model.id + "/" + model.people[p].filename().string(), hashed.people[p]);
  }
}

/// Makes the inputs of a manifest from hashes; that of the classification is empty if there is none.
Json inputs_json(Json models, const std::string& classification) {
  Json json{{"algorithm", "SHA-256"}, {"models", std::move(models)}};
  if (!classification.empty()) json["classification"] = classification;
  return json;
}

/// Returns the hashes of all meshes and human segmentations of a data set on disk.
Json inputs_on_disk(const SegmentationExperiment& experiment) {
  const SegmentationBenchmark shapes = find_segmented_shapes(experiment.location);
  std::vector<HashedShape> hashes(shapes.models.size());
  parallel_for(std::size_t{0}, hashes.size(), [&](std::size_t i) { hashes[i] = hashes_of(shapes.models[i]); });
  Json models = Json::object();
  for (std::size_t i = 0; i < hashes.size(); ++i) add_hashes(shapes.models[i], hashes[i], models);
  return inputs_json(std::move(models), sha256_of_file_if_readable(experiment.location.classification));
}

/// Returns the hashes of the used and of the failed meshes, and of the human segmentations.
Json inputs(const SegmentationResults& results) {
  Json models = Json::object();
  for (std::size_t i = 0; i < results.shapes.size(); ++i) {
    const SegmentedShape& shape = results.shapes[i];
    add_hashes(results.benchmark.models[i], {.mesh = shape.mesh_sha256, .people = shape.people_sha256}, models);
  }
  for (const SegmentedModel& model : results.failed) add_hashes(model, hashes_of(model), models);
  return inputs_json(std::move(models), results.classification_sha256);
}

Json manifest_entries(const SegmentationResults& results) {
  return {{"inputs", inputs(results)},
          {"shapes", results.shapes.size()},
          {"without_people", results.benchmark.without_people},
          {"failed_models", failures_json(results.failures)}};
}

Json execution_entries(const SegmentationResults& results) {
  Json execution = execution_json(results.threads, results.timings, {}, results.cache);
  const CacheUse& use = results.cache.uses.at(static_cast<std::size_t>(EntryKind::segmentation));
  execution["cache"] = {{"from_cache", use.hits}, {"computed", use.computed}};
  return execution;
}

/// Writes a folder with a .seg file for each shape for each method. Returns their names.
std::vector<std::string> write_parts(const std::filesystem::path& folder, const SegmentationResults& results) {
  std::vector<std::string> names;
  for (const SegmentationMethod& method : results.experiment.methods) names.push_back(method.name);
  const std::vector<std::string> folders = file_safe_names(names);
  std::vector<std::string> files;
  for (std::size_t m = 0; m < folders.size(); ++m) {
    for (std::size_t i = 0; i < results.shapes.size(); ++i) {
      files.push_back(fmt::format("parts/{}/{}.seg", folders[m], results.benchmark.models[i].id));
      std::filesystem::create_directories((folder / files.back()).parent_path());  // ids of folders have folders
      write_seg(folder / files.back(), results.shapes[i].labels[m]);
    }
  }
  return files;
}

std::vector<std::string> notes_of(const SegmentationResults& results) {
  std::vector<std::string> notes;
  if (const std::string skipped = skipped_text(results.benchmark.skipped); !skipped.empty()) notes.push_back(skipped);
  std::vector<std::string> ids;
  std::vector<std::vector<std::string>> remarks;
  std::vector<std::vector<std::string>> warnings;
  for (const SegmentedModel& model : results.benchmark.models) ids.push_back(model.id);
  for (const SegmentedShape& shape : results.shapes) {
    remarks.push_back(shape.remarks);
    warnings.push_back(shape.warnings);
  }
  for (std::string note : {note_on_shapes(ids, remarks, "shape", not_perturbed),
                           note_on_shapes(ids, warnings, "shape", "have samples without a reliable offset SDF")}) {
    if (!note.empty()) notes.push_back(std::move(note));
  }
  const auto count = std::ranges::count_if(results.shapes, &SegmentedShape::has_polygons);
  if (count == 0) return notes;
  notes.push_back(
      fmt::format("{} of {} shapes have polygonal faces, which were triangulated; their .seg files have one line per "
                  "face of the file, with the part that covers most of its area",
                  count, results.shapes.size()));
  return notes;
}

}  // namespace

RunOutcome write_segmentation(const RunResults& to, const SegmentationResults& results) {
  to.manifest = manifest_entries(results);
  to.execution = execution_entries(results);
  RunOutcome outcome{.summary = summary(results, [](const TextTable& table) { return to_plain_text(table); }),
                     .notes = notes_of(results),
                     .left_out = results.failures,
                     .used = results.shapes.size(),
                     .noun = "shape",
                     .cache = results.cache};
  for (const auto& [name, text] : text_files(results)) {
    write_file_atomically(to.folder / name, text);
    outcome.files.push_back(name);
  }
  std::ranges::move(write_parts(to.folder, results), std::back_inserter(outcome.files));
  return outcome;
}

namespace {

Experiment read_segmentation(const nlohmann::json& document, const std::string& source,
                             const std::filesystem::path& folder) {
  const SegmentationExperiment experiment = segmentation_from_json(document, source, folder);
  Experiment read{
      .name = experiment.name,
      .configuration = [experiment] { return to_json(experiment); },
      .run = [experiment](
                 const RunContext& context,
                 const RunResults& to) { return write_segmentation(to, run_segmentation(experiment, context)); },
      .run_part = [experiment](const RunContext& context,
                               const Part& part) { return run_part_of_segmentation(experiment, context, part); }};
  if (experiment.generator) return read;
  read.input_paths = {experiment.location.root, experiment.location.classification};
  read.inputs = [experiment](int threads) {
    Json now;
    with_threads(threads, [&] { now = inputs_on_disk(experiment); });
    return now;
  };
  return read;
}

}  // namespace

ExperimentKind segmentation_kind() {
  return {.name = "segmentation",
          .description = "The parts of the shapes of a data set by several methods, compared with those of people.",
          .keys = {"segmentation"},
          .paths = {.datasets = {"/dataset"}},
          .schema =
              [] {
                return Json{{"$ref", "#/definitions/segmentation_experiment"}};
              },
          .read = read_segmentation};
}

}  // namespace shapegauge
