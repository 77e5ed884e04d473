#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <tbb/parallel_for.h>
#include <vector>

#include "app/commands.h"
#include "app/options.h"
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/experiments/files/table.h"
#include "shapegauge/experiments/runner/run_control.h"
#include "shapegauge/experiments/segmentation/segmentation_benchmark.h"
#include "shapegauge/metrics/method_comparison.h"
#include "shapegauge/segmentation/seg_file.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

constexpr const char* people_name = "people";

struct EvaluationArguments {
  std::vector<fs::path> folders;
  fs::path benchmark;
  std::string weights = "faces";
  bool no_cuts = false;
  std::string format = "table";
  fs::path per_mesh;
  int threads = 0;
};

/// All errors: methods (people last) by model.
struct Scores {
  SegmentationBenchmark benchmark;
  std::vector<std::string> methods;
  std::vector<std::vector<SegmentationErrors>> errors;  ///< by method, then by model

  /// models x methods; NaN where an error is not defined.
  [[nodiscard]] Eigen::MatrixXd table_of(double SegmentationErrors::*value) const {
    Eigen::MatrixXd table(std::ssize(benchmark.models), std::ssize(methods));
    for (Eigen::Index m = 0; m < table.cols(); ++m) {
      for (Eigen::Index i = 0; i < table.rows(); ++i) {
        table(i, m) = errors[static_cast<std::size_t>(m)][static_cast<std::size_t>(i)].*value;
      }
    }
    return table;
  }

  [[nodiscard]] std::vector<int> labels() const {
    std::vector<int> result;
    for (const SegmentedModel& model : benchmark.models) result.push_back(model.label);
    return result;
  }
};

/// The mean of what is defined, of the models of a class or (-1) of all.
double mean_of(const Scores& scores, std::size_t method, double SegmentationErrors::*value, int label) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < scores.benchmark.models.size(); ++i) {
    const double error = scores.errors[method][i].*value;
    if ((label >= 0 && scores.benchmark.models[i].label != label) || std::isnan(error)) continue;
    sum += error;
    ++count;
  }
  return count > 0 ? sum / count : std::nan("");
}

void score_model(Scores& scores, std::size_t i, const EvaluationArguments& arguments) {
  const SegmentedModel& model = scores.benchmark.models[i];
  const Shape mesh = read_shape(model.mesh);
  const auto faces = static_cast<std::size_t>(mesh.triangles.rows());
  const SegmentationScorer scorer(mesh, {.by_area = arguments.weights == "area", .cuts = !arguments.no_cuts});
  std::vector<std::vector<std::int32_t>> people;
  for (const fs::path& file : model.people) people.push_back(read_seg(file, faces));
  for (std::size_t m = 0; m < arguments.folders.size(); ++m) {
    const fs::path file = arguments.folders[m] / (model.id + ".seg");
    scores.errors[m][i] = scorer.errors_against(read_seg(file, faces), people);
  }
  scores.errors.back()[i] = scorer.errors_among(people);
}

Scores scored(const EvaluationArguments& arguments) {
  Scores scores;
  scores.benchmark = find_segmentation_benchmark(arguments.benchmark);
  for (const fs::path& folder : arguments.folders) {
    const fs::path named = folder.has_filename() ? folder : folder.parent_path();
    scores.methods.push_back(named.filename().string());
  }
  scores.methods.emplace_back(people_name);
  const std::size_t models = scores.benchmark.models.size();
  scores.errors.assign(scores.methods.size(), std::vector<SegmentationErrors>(models));
  std::vector<std::string> failures(models);
  with_threads(arguments.threads, [&] {
    tbb::parallel_for(std::size_t{0}, models, [&](std::size_t i) {
      try {
        score_model(scores, i, arguments);
      } catch (const InputError& error) {
        failures[i] = error.what();
      }
    });
  });
  for (const std::string& failure : failures) {
    if (!failure.empty()) throw InputError(failure);
  }
  return scores;
}

std::string cell(double value) { return std::isnan(value) ? "-" : fmt::format("{:.4f}", value); }

Table mean_table(const Scores& scores) {
  Table table;
  table.header = {"method"};
  for (const SegmentationErrorEntry& entry : segmentation_error_entries()) table.header.emplace_back(entry.name);
  for (std::size_t m = 0; m < scores.methods.size(); ++m) {
    table.rows.push_back({scores.methods[m]});
    for (const SegmentationErrorEntry& entry : segmentation_error_entries()) {
      table.rows.back().push_back(cell(mean_of(scores, m, entry.value, -1)));
    }
  }
  return table;
}

Table class_table(const Scores& scores) {
  Table table;
  table.header = {"Rand by class"};
  table.header.insert(table.header.end(), scores.methods.begin(), scores.methods.end());
  for (std::size_t c = 0; c < scores.benchmark.classes.size(); ++c) {
    table.rows.push_back({scores.benchmark.classes[c]});
    for (std::size_t m = 0; m < scores.methods.size(); ++m) {
      table.rows.back().push_back(cell(mean_of(scores, m, &SegmentationErrors::rand_index, static_cast<int>(c))));
    }
  }
  return table;
}

Table mesh_table(const Scores& scores) {
  Table table;
  table.header = {"method", "id", "class"};
  table.text_columns = 3;
  for (const SegmentationErrorEntry& entry : segmentation_error_entries()) table.header.emplace_back(entry.name);
  for (std::size_t m = 0; m < scores.methods.size(); ++m) {
    for (std::size_t i = 0; i < scores.benchmark.models.size(); ++i) {
      const SegmentedModel& model = scores.benchmark.models[i];
      table.rows.push_back(
          {scores.methods[m], model.id, scores.benchmark.classes[static_cast<std::size_t>(model.label)]});
      for (const SegmentationErrorEntry& entry : segmentation_error_entries()) {
        const double value = scores.errors[m][i].*entry.value;
        table.rows.back().push_back(std::isnan(value) ? "" : fmt::format("{}", value));
      }
    }
  }
  return table;
}

/// The comparison of Rand errors, where there is more than one class and people agree on all meshes or not at all.
std::optional<MethodComparison> rand_comparison(const Scores& scores) {
  const Eigen::MatrixXd table = scores.table_of(&SegmentationErrors::rand_index);
  if (scores.benchmark.classes.size() < 2 || scores.methods.size() < 2 || !table.allFinite()) return std::nullopt;
  return compare_methods(table, scores.labels(), {.average = Average::macro});
}

Table pair_table(const Scores& scores, const MethodComparison& comparison) {
  Table table;
  table.header = {"first", "second", "difference", "low", "high", "p", "p (Holm)", "classes won"};
  table.text_columns = 2;
  const int classes = static_cast<int>(scores.benchmark.classes.size());
  for (const PairDifference& pair : comparison.pairs) {
    int won = 0;
    for (int c = 0; c < classes; ++c) {
      won += mean_of(scores, pair.first, &SegmentationErrors::rand_index, c) <
                     mean_of(scores, pair.second, &SegmentationErrors::rand_index, c)
                 ? 1
                 : 0;
    }
    table.rows.push_back({scores.methods[pair.first], scores.methods[pair.second], cell(pair.difference),
                          cell(pair.interval.low), cell(pair.interval.high), cell(pair.p), cell(pair.p_holm),
                          fmt::format("{} of {}", won, classes)});
  }
  return table;
}

nlohmann::ordered_json json_of(const Scores& scores, const EvaluationArguments& arguments) {
  const auto errors_json = [&](std::size_t method, int label) {
    nlohmann::ordered_json errors;
    for (const SegmentationErrorEntry& entry : segmentation_error_entries()) {
      errors[std::string(entry.name)] = mean_of(scores, method, entry.value, label);  // NaN becomes null
    }
    return errors;
  };
  const std::optional<MethodComparison> comparison = rand_comparison(scores);
  nlohmann::ordered_json methods = nlohmann::ordered_json::array();
  for (std::size_t m = 0; m < scores.methods.size(); ++m) {
    nlohmann::ordered_json per_class;
    for (std::size_t c = 0; c < scores.benchmark.classes.size(); ++c) {
      per_class[scores.benchmark.classes[c]] = errors_json(m, static_cast<int>(c));
    }
    methods.push_back({{"name", scores.methods[m]}, {"mean", errors_json(m, -1)}});
    if (comparison) {
      methods.back()["macro_rand"] = comparison->averages[static_cast<Eigen::Index>(m)];
      methods.back()["macro_rand_interval"] = {comparison->intervals[m].low, comparison->intervals[m].high};
    }
    methods.back()["per_class"] = per_class;
  }
  return {{"weights", arguments.weights}, {"meshes", scores.benchmark.models.size()}, {"methods", methods}};
}

std::string words_of(const Scores& scores, const MethodComparison& comparison) {
  std::string words;
  for (std::size_t m = 0; m < scores.methods.size(); ++m) {
    words += fmt::format("{}: Rand error {:.4f}, 95 % from {:.4f} to {:.4f} (mean of {} classes)\n", scores.methods[m],
                         comparison.averages[static_cast<Eigen::Index>(m)], comparison.intervals[m].low,
                         comparison.intervals[m].high, comparison.units);
  }
  return words;
}

std::string formatted_errors(const Scores& scores, const EvaluationArguments& arguments) {
  if (arguments.format == "json") return json_of(scores, arguments).dump(2) + "\n";
  if (arguments.format == "csv") return to_csv(mean_table(scores));
  const auto text = arguments.format == "markdown" ? to_markdown : to_plain_text;
  std::string result = text(mean_table(scores)) + "\n" + text(class_table(scores));
  const std::optional<MethodComparison> comparison = rand_comparison(scores);
  if (!comparison) return result;
  return result + "\n" + words_of(scores, *comparison) + "\n" + text(pair_table(scores, *comparison));
}

int run(const EvaluationArguments& arguments) {
  const Scores scores = scored(arguments);
  if (!scores.benchmark.without_people.empty()) {
    warn(fmt::format("nobody segmented {} of the meshes ({}, ...); they are left out",
                     scores.benchmark.without_people.size(), scores.benchmark.without_people.front()));
  }
  if (!arguments.per_mesh.empty()) write_file_atomically(arguments.per_mesh, to_csv(mesh_table(scores)));
  fmt::print("{}", formatted_errors(scores, arguments));
  return exit_success;
}

}  // namespace

void add_segmentation_evaluation_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("evaluate-segmentation", "Compare segmentations with those of people");
  command->footer(
      "Example: shapegauge segment psb/off/*.off -o mine/\n"
      "         shapegauge evaluate-segmentation mine/ theirs/ --benchmark psb/\n"
      "Errors are fractions, less is better; the row \"people\" is one person against another.");
  const auto arguments = std::make_shared<EvaluationArguments>();
  command->add_option("segmentations", arguments->folders, "Folders with N.seg for every mesh, one a method");
  command
      ->add_option("--benchmark", arguments->benchmark,
                   "Folder with meshes off/N.off and people's segmentations seg/N/*.seg (Princeton's layout)")
      ->required();
  command->add_option("--by", arguments->weights, "What a triangle counts")
      ->check(CLI::IsMember({"faces", "area"}))
      ->capture_default_str();
  command->add_flag("--no-cuts", arguments->no_cuts, "Leave out the cut discrepancy, which takes the longest");
  command->add_option("--format", arguments->format, "Format of the result")
      ->check(CLI::IsMember({"table", "markdown", "csv", "json"}))
      ->capture_default_str();
  command->add_option("--per-mesh", arguments->per_mesh, "CSV file for the errors of each mesh");
  add_threads_option(*command, arguments->threads);
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace shapegauge
