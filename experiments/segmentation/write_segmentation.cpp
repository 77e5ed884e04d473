#include "shapegauge/experiments/segmentation/write_segmentation.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/experiments/files/table.h"
#include "shapegauge/experiments/results/manifest.h"
#include "shapegauge/experiments/results/result_folder.h"
#include "shapegauge/experiments/segmentation/part_consistency.h"
#include "shapegauge/experiments/segmentation/segmentation_report.h"
#include "shapegauge/experiments/segmentation/segmentation_tables.h"
#include "shapegauge/segmentation/seg_file.h"

namespace shapegauge {

namespace {

using Json = nlohmann::ordered_json;

std::string summary(const SegmentationResults& results, std::string (*text)(const Table&)) {
  if (!results.has_people) return text(consistency_table(results));
  std::string result = text(mean_table(results.scores)) + "\n" + text(class_table(results.scores));
  if (const Table moved = moved_table(results); !moved.rows.empty()) result += "\n" + text(moved);
  if (const std::optional<MethodComparison> comparison = rand_comparison(results.scores)) {
    result += "\n" + text(interval_table(results.scores, *comparison));
    result += "\n" + text(pair_table(results.scores, *comparison));
  }
  return result;
}

std::string summary_markdown(const SegmentationResults& results) {
  std::string text = fmt::format("# {}\n\n", results.experiment.name);
  if (!results.experiment.description.empty()) text += results.experiment.description + "\n\n";
  return text + summary(results, to_markdown);
}

std::vector<std::pair<std::string, std::string>> text_files(const SegmentationResults& results) {
  std::vector<std::pair<std::string, std::string>> files{
      {"summary.md", summary_markdown(results)},
      {"consistency.csv", to_csv(consistency_table(results))},
      {std::string(report_name), segmentation_page(report_of(results))}};
  if (const Table moved = moved_table(results); !moved.rows.empty()) files.emplace_back("moved.csv", to_csv(moved));
  if (!results.has_people) return files;
  files.emplace_back("errors.csv", to_csv(mesh_table(results.scores)));
  files.emplace_back("classes.csv", to_csv(class_error_table(results.scores)));
  if (const std::optional<MethodComparison> comparison = rand_comparison(results.scores)) {
    files.emplace_back("means.csv", to_csv(interval_table(results.scores, *comparison)));
    files.emplace_back("pairs.csv", to_csv(pair_table(results.scores, *comparison)));
  }
  return files;
}

/// Of the meshes that were used and of people's segmentations.
Json inputs(const SegmentationResults& results) {
  Json models = Json::object();
  for (std::size_t i = 0; i < results.shapes.size(); ++i) {
    const SegmentedModel& model = results.benchmark.models[i];
    models[model.id] = results.shapes[i].mesh_sha256;
    for (std::size_t p = 0; p < model.people.size(); ++p) {
      models[model.id + "/" + model.people[p].filename().string()] = results.shapes[i].people_sha256[p];
    }
  }
  return {{"algorithm", "SHA-256"}, {"models", std::move(models)}};
}

Json manifest(const SegmentationResults& results, const std::vector<std::string>& files,
              const std::filesystem::path& folder) {
  Json failures = Json::array();
  for (const FailedSegmentation& failure : results.failures) {
    failures.push_back({{"model", failure.model.id}, {"error", failure.message}});
  }
  Json execution = execution_json(results.threads, results.timings, {});
  const CacheUse& use = results.cache.uses.at(static_cast<std::size_t>(EntryKind::segmentation));
  execution["cache"] = {{"from_cache", use.hits}, {"computed", use.computed}};
  Json json = program_json();
  json.update({{"configuration", to_json(results.experiment)},
               {"inputs", inputs(results)},
               {"shapes", results.shapes.size()},
               {"without_people", results.benchmark.without_people},
               {"failed_models", std::move(failures)},
               {"files", files},
               {"outputs", outputs_json(folder, files)},
               {"execution", std::move(execution)}});
  return json;
}

/// Of each method a folder with a .seg file for each shape. Returns their names.
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

}  // namespace

void write_segmentation(const std::filesystem::path& destination, const SegmentationResults& results) {
  StagedResults staged(destination);
  const std::filesystem::path& folder = staged.folder();
  std::vector<std::string> files;
  for (const auto& [name, text] : text_files(results)) {
    write_file_atomically(folder / name, text);
    files.push_back(name);
  }
  for (std::string& file : write_parts(folder, results)) files.push_back(std::move(file));
  write_file_atomically(folder / manifest_name, manifest(results, files, folder).dump(2) + "\n");
  staged.publish(files);
}

std::string summary_text(const SegmentationResults& results) { return summary(results, to_plain_text); }

}  // namespace shapegauge
