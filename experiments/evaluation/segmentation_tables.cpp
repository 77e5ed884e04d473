// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/evaluation/segmentation_tables.h"

#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/segmentation/seg_file.h"

namespace shapegauge {

namespace {

std::string cell(double value) { return std::isnan(value) ? "-" : fmt::format("{:.4f}", value); }

std::string full_cell(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

void add_entry_names(TextTable& table) {
  for (const SegmentationErrorEntry& entry : segmentation_error_entries()) table.header.emplace_back(entry.name);
}

/// Returns Rand errors, meshes x methods.
Eigen::MatrixXd rand_errors(const SegmentationScores& scores) {
  Eigen::MatrixXd table(std::ssize(scores.ids), std::ssize(scores.methods));
  for (Eigen::Index m = 0; m < table.cols(); ++m) {
    for (Eigen::Index i = 0; i < table.rows(); ++i) {
      table(i, m) = scores.errors[static_cast<std::size_t>(m)][static_cast<std::size_t>(i)].rand_index;
    }
  }
  return table;
}

}  // namespace

double SegmentationScores::mean(std::size_t method, double SegmentationErrors::*value, int label) const {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const double error = errors[method][i].*value;
    if ((label >= 0 && labels[i] != label) || std::isnan(error)) continue;
    sum += error;
    ++count;
  }
  return count > 0 ? sum / count : std::nan("");
}

SegmentationScores empty_scores(const SegmentationBenchmark& benchmark, std::vector<std::string> methods) {
  SegmentationScores scores;
  for (const SegmentedModel& model : benchmark.models) {
    scores.ids.push_back(model.id);
    scores.labels.push_back(model.label);
  }
  scores.classes = benchmark.classes;
  scores.methods = std::move(methods);
  scores.errors.assign(scores.methods.size(), std::vector<SegmentationErrors>(benchmark.models.size()));
  return scores;
}

namespace {

/// Computes the errors on one mesh: one entry per method, the last between human segmentations.
std::vector<SegmentationErrors> errors_on(const SegmentedModel& model,
                                          const std::vector<std::filesystem::path>& folders,
                                          const SegmentationScoring& scoring) {
  const Shape mesh = read_shape(model.mesh);
  const SegmentationScorer scorer(mesh, scoring);
  std::vector<std::vector<std::int32_t>> people;
  for (const std::filesystem::path& file : model.people) people.push_back(read_seg(file, mesh));
  std::vector<SegmentationErrors> errors;
  for (const std::filesystem::path& folder : folders) {
    errors.push_back(scorer.mean_errors_against(read_seg(folder / (model.id + ".seg"), mesh), people));
  }
  errors.push_back(scorer.mean_errors_among(people));
  return errors;
}

}  // namespace

SegmentationScores score_segmentations(const SegmentationBenchmark& benchmark,
                                       const std::vector<std::filesystem::path>& folders,
                                       const SegmentationScoring& scoring) {
  std::vector<std::string> methods;
  for (const std::filesystem::path& folder : folders) {
    const std::filesystem::path named = folder.has_filename() ? folder : folder.parent_path();
    methods.push_back(named.filename().string());
  }
  methods.emplace_back(people_name);
  SegmentationScores scores = empty_scores(benchmark, std::move(methods));
  std::vector<std::string> failures(benchmark.models.size());
  parallel_for(std::size_t{0}, benchmark.models.size(), [&](std::size_t i) {
    try {
      const std::vector<SegmentationErrors> errors = errors_on(benchmark.models[i], folders, scoring);
      for (std::size_t m = 0; m < errors.size(); ++m) scores.errors[m][i] = errors[m];
    } catch (const InputError& error) {
      failures[i] = error.what();
    }
  });
  for (const std::string& failure : failures) {
    if (!failure.empty()) throw InputError(failure);
  }
  return scores;
}

TextTable mean_table(const SegmentationScores& scores) {
  TextTable table;
  table.header = {"method"};
  add_entry_names(table);
  for (std::size_t m = 0; m < scores.methods.size(); ++m) {
    table.rows.push_back({scores.methods[m]});
    for (const SegmentationErrorEntry& entry : segmentation_error_entries()) {
      table.rows.back().push_back(cell(scores.mean(m, entry.value)));
    }
  }
  return table;
}

TextTable class_table(const SegmentationScores& scores) {
  TextTable table;
  table.header = {"Rand by class"};
  table.header.insert(table.header.end(), scores.methods.begin(), scores.methods.end());
  for (std::size_t c = 0; c < scores.classes.size(); ++c) {
    table.rows.push_back({scores.classes[c]});
    for (std::size_t m = 0; m < scores.methods.size(); ++m) {
      table.rows.back().push_back(cell(scores.mean(m, &SegmentationErrors::rand_index, static_cast<int>(c))));
    }
  }
  return table;
}

TextTable class_error_table(const SegmentationScores& scores) {
  TextTable table;
  table.header = {"method", "class"};
  table.text_columns = 2;
  add_entry_names(table);
  for (std::size_t m = 0; m < scores.methods.size(); ++m) {
    for (std::size_t c = 0; c < scores.classes.size(); ++c) {
      table.rows.push_back({scores.methods[m], scores.classes[c]});
      for (const SegmentationErrorEntry& entry : segmentation_error_entries()) {
        table.rows.back().push_back(full_cell(scores.mean(m, entry.value, static_cast<int>(c))));
      }
    }
  }
  return table;
}

TextTable mesh_table(const SegmentationScores& scores) {
  TextTable table;
  table.header = {"method", "id", "class"};
  table.text_columns = 3;
  add_entry_names(table);
  for (std::size_t m = 0; m < scores.methods.size(); ++m) {
    for (std::size_t i = 0; i < scores.ids.size(); ++i) {
      table.rows.push_back(
          {scores.methods[m], scores.ids[i], scores.classes[static_cast<std::size_t>(scores.labels[i])]});
      for (const SegmentationErrorEntry& entry : segmentation_error_entries()) {
        table.rows.back().push_back(full_cell(scores.errors[m][i].*entry.value));
      }
    }
  }
  return table;
}

std::optional<MethodComparison> rand_comparison(const SegmentationScores& scores) {
  const Eigen::MatrixXd table = rand_errors(scores);
  if (scores.classes.size() < 2 || scores.methods.size() < 2 || !table.allFinite()) return std::nullopt;
  return compare_methods(table, scores.labels, {.blocks = ResamplingUnit::classes, .average = Average::macro});
}

TextTable interval_table(const SegmentationScores& scores, const MethodComparison& comparison) {
  TextTable table;
  table.header = {"method", "Rand, mean of classes", "95 % low", "high"};
  for (std::size_t m = 0; m < scores.methods.size(); ++m) {
    table.rows.push_back({scores.methods[m], cell(comparison.averages[static_cast<Eigen::Index>(m)]),
                          cell(comparison.intervals[m].low), cell(comparison.intervals[m].high)});
  }
  return table;
}

TextTable pair_table(const SegmentationScores& scores, const MethodComparison& comparison) {
  TextTable table;
  table.header = {"first", "second", "difference", "low", "high", "p", "p (Holm)", "classes won"};
  table.text_columns = 2;
  const int classes = static_cast<int>(scores.classes.size());
  for (const PairDifference& pair : comparison.pairs) {
    int won = 0;
    for (int c = 0; c < classes; ++c) {
      won += scores.mean(pair.first, &SegmentationErrors::rand_index, c) <
                     scores.mean(pair.second, &SegmentationErrors::rand_index, c)
                 ? 1
                 : 0;
    }
    table.rows.push_back({scores.methods[pair.first], scores.methods[pair.second], cell(pair.difference),
                          cell(pair.interval.low), cell(pair.interval.high), cell(pair.p), cell(pair.p_holm),
                          fmt::format("{} of {}", won, classes)});
  }
  return table;
}

}  // namespace shapegauge
