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
      .triangle_weights = results.experiment.by == TriangleWeights::area ? "by area" : "alike",
      .tables = {mean_table(scores)},
      .methods = scores.methods,
      .classes = {},
      .class_table = class_table(scores)};
  if (const std::optional<MethodComparison> comparison = rand_comparison(scores)) {
    errors.tables.push_back(interval_table(scores, *comparison));
    errors.tables.push_back(pair_table(scores, *comparison));
  }
  for (std::size_t c = 0; c < scores.classes.size(); ++c) {
    SegmentationClassErrors& one = errors.classes.emplace_back(SegmentationClassErrors{scores.classes[c], {}});
    for (std::size_t m = 0; m < scores.methods.size(); ++m) {
      one.errors.push_back(scores.mean(m, &SegmentationErrors::rand_index, static_cast<int>(c)));
    }
  }
  return errors;
}

SegmentationFigure figure_of(const SegmentationResults& results, std::size_t shape) {
  const SegmentationScores& scores = results.scores;
  const std::vector<std::string>& pictures = results.shapes[shape].pictures;
  const auto label = static_cast<std::size_t>(scores.labels[shape]);
  SegmentationFigure figure{fmt::format("{} ({})", scores.ids[shape], scores.classes[label]), {}};
  if (results.has_people) {
    figure.pictures.push_back({pictures.front(), results.experiment.generator ? "as made" : "a person"});
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

/// Returns the shape of median error of each class.
std::vector<std::size_t> typical_shapes(const SegmentationScores& scores) {
  std::vector<std::vector<std::size_t>> by_class(scores.classes.size());
  for (const std::size_t i : worst_first(scores)) by_class[static_cast<std::size_t>(scores.labels[i])].push_back(i);
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
                        .shapes = results.scores.ids.size(),
                        .classes = results.scores.classes.size(),
                        .errors = {},
                        .moved = moved_table(results),
                        .consistency = consistency_table(results),
                        .failures = {},
                        .typical = {},
                        .shown = {}};
  if (results.has_people) page.errors = page_errors(results);
  for (const LeftOutShape& failure : results.failures) {
    page.failures.emplace_back(failure.id, failure.message);
  }
  if (!results.experiment.pictures) return page;
  for (const std::size_t i : typical_shapes(results.scores)) page.typical.push_back(figure_of(results, i));
  for (const std::size_t i : worst_first(results.scores)) page.shown.push_back(figure_of(results, i));
  return page;
}

}  // namespace shapegauge
