// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/segmentation/segmentation_report.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <numeric>

#include "shapegauge/experiments/segmentation/part_consistency.h"

namespace shapegauge {

namespace {

SegmentationPageErrors page_errors(const SegmentationResults& results) {
  const SegmentationScores& scores = results.scores;
  SegmentationPageErrors errors{
      .triangle_weights = results.experiment.by == TriangleWeights::area ? "by area" : "equally",
      .tables = {mean_table(scores)},
      .methods = scores.methods,
      .by_class = {}};
  if (const std::optional<MethodComparison> comparison = rand_comparison(scores)) {
    errors.tables.push_back(interval_table(scores, *comparison));
    errors.tables.push_back(pair_table(scores, *comparison));
  }
  for (std::size_t c = 0; c < scores.classes.size(); ++c) {
    std::vector<double>& of_class = errors.by_class.emplace_back();
    for (std::size_t m = 0; m < scores.methods.size(); ++m) {
      of_class.push_back(scores.mean(m, &SegmentationErrors::rand_index, static_cast<int>(c)));
    }
  }
  return errors;
}

SegmentationFigure figure_of(const SegmentationResults& results, std::size_t shape) {
  const SegmentationScores& scores = results.scores;
  const std::vector<std::string>& pictures = results.shapes[shape].pictures;
  const auto label = static_cast<std::size_t>(scores.labels[shape]);
  SegmentationFigure figure{
      fmt::format("{} ({})", scores.ids[shape], scores.classes[label]), {}, results.shapes[shape].view};
  if (results.has_people) {
    figure.pictures.push_back({pictures.front(), reference_name(results.experiment)});
  }
  const std::size_t people = figure.pictures.size();
  for (std::size_t m = 0; m < results.experiment.methods.size(); ++m) {
    const std::string& method = results.experiment.methods[m].name;
    const double error = scores.errors[m][shape].rand_index;
    figure.pictures.push_back(
        {pictures[m + people], results.has_people ? fmt::format("{}: {:.3f}", method, error) : method});
  }
  return figure;
}

/// Returns the shapes' indices, largest error of the first method first.
std::vector<std::size_t> worst_first(const SegmentationScores& scores) {
  std::vector<std::size_t> order(scores.ids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater<>{}, [&](std::size_t i) { return scores.errors.front()[i].rand_index; });
  return order;
}

/// Returns the shape of median error of each class, as indices into the order.
std::vector<std::size_t> typical_shapes(const SegmentationScores& scores, const std::vector<std::size_t>& order) {
  std::vector<std::vector<std::size_t>> by_class(scores.classes.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    by_class[static_cast<std::size_t>(scores.labels[order[i]])].push_back(i);
  std::vector<std::size_t> typical;
  for (const auto& shapes : by_class) {
    if (!shapes.empty()) typical.push_back(shapes[shapes.size() / 2]);
  }
  return typical;
}

}  // namespace

SegmentationPage segmentation_report(const SegmentationResults& results) {
  SegmentationPage page{.title = results.experiment.name,
                        .description = results.experiment.description,
                        .classes = results.scores.classes,
                        .labels = results.scores.labels,
                        .errors = {},
                        .perturbation_effects = perturbation_effect_table(results),
                        .consistency = consistency_table(results),
                        .failures = {},
                        .shown = {},
                        .typical = {}};
  if (results.has_people) page.errors = page_errors(results);
  for (const LeftOutShape& failure : results.failures) {
    page.failures.emplace_back(failure.id, failure.message);
  }
  if (!results.experiment.pictures) return page;
  const std::vector<std::size_t> order = worst_first(results.scores);
  for (const std::size_t i : order) page.shown.push_back(figure_of(results, i));
  page.typical = typical_shapes(results.scores, order);
  return page;
}

}  // namespace shapegauge
