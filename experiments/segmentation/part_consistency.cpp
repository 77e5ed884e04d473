// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/segmentation/part_consistency.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "shapegauge/core/base/median.h"

namespace shapegauge {

namespace {

/// Fraction of the area below which parts are not counted.
constexpr double min_size = 0.01;

using Sizes = std::vector<double>;

std::string cell(double value) { return std::isnan(value) ? "-" : fmt::format("{:.3f}", value); }

std::size_t count_text(const Sizes& sizes) {
  return static_cast<std::size_t>(std::ranges::count_if(sizes, [](double size) { return size >= min_size; }));
}

double difference(const Sizes& a, const Sizes& b) {
  double sum = 0;
  for (std::size_t k = 0; k < std::max(a.size(), b.size()); ++k) {
    sum += std::abs((k < a.size() ? a[k] : 0) - (k < b.size() ? b[k] : 0));
  }
  return sum / 2;
}

/// Running mean; NaN if empty.
struct Mean {
  double sum = 0;
  int count = 0;

  void add(double value) {
    sum += value;
    ++count;
  }
  [[nodiscard]] double value() const { return count > 0 ? sum / count : std::nan(""); }
};

double median(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  std::ranges::sort(values);
  return sorted_median(values);
}

struct ClassConsistency {
  double parts = 0;
  double same_number = 0;
  double sizes = 0;
  double other_sizes = 0;
};

ClassConsistency consistency(const SegmentationResults& results, std::size_t method, int label) {
  Mean same_number;
  Mean sizes;
  Mean other_sizes;
  std::vector<double> numbers;
  for (std::size_t i = 0; i < results.shapes.size(); ++i) {
    if (results.scores.labels[i] != label) continue;
    const Sizes& one = results.shapes[i].part_sizes[method];
    numbers.push_back(static_cast<double>(count_text(one)));
    for (std::size_t k = 0; k < results.shapes.size(); ++k) {
      const Sizes& other = results.shapes[k].part_sizes[method];
      if (results.scores.labels[k] != label) {
        other_sizes.add(difference(one, other));
      } else if (k > i) {
        same_number.add(count_text(one) == count_text(other) ? 1 : 0);
        sizes.add(difference(one, other));
      }
    }
  }
  return {median(std::move(numbers)), same_number.value(), sizes.value(), other_sizes.value()};
}

std::vector<std::string> consistency_row(const std::string& method, const std::string& name,
                                         const ClassConsistency& values) {
  return {method, name, cell(values.parts), cell(values.same_number), cell(values.sizes), cell(values.other_sizes)};
}

double mean_of(const std::vector<ClassConsistency>& all, double ClassConsistency::*value) {
  Mean mean;
  for (const ClassConsistency& one : all) {
    if (!std::isnan(one.*value)) mean.add(one.*value);
  }
  return mean.value();
}

}  // namespace

TextTable consistency_table(const SegmentationResults& results) {
  TextTable table;
  table.header = {"method", "class", "parts", "same number", "sizes", "sizes, others"};
  table.text_columns = 2;
  for (std::size_t m = 0; m < results.experiment.methods.size(); ++m) {
    const std::string& method = results.experiment.methods[m].name;
    std::vector<ClassConsistency> all;
    for (std::size_t c = 0; c < results.scores.classes.size(); ++c) {
      all.push_back(consistency(results, m, static_cast<int>(c)));
      table.rows.push_back(consistency_row(method, results.scores.classes[c], all.back()));
    }
    table.rows.push_back(
        consistency_row(method, "mean",
                        {mean_of(all, &ClassConsistency::parts), mean_of(all, &ClassConsistency::same_number),
                         mean_of(all, &ClassConsistency::sizes), mean_of(all, &ClassConsistency::other_sizes)}));
  }
  return table;
}

TextTable perturbation_effect_table(const SegmentationResults& results) {
  TextTable table;
  table.header = {"Rand from undamaged", "median", "mean", "greatest"};
  for (std::size_t m = 0; m < results.experiment.methods.size(); ++m) {
    if (results.experiment.methods[m].perturbations.empty()) continue;
    std::vector<double> values;
    Mean mean;
    for (const SegmentedShape& shape : results.shapes) {
      values.push_back(shape.perturbation_errors[m]);
      mean.add(shape.perturbation_errors[m]);
    }
    table.rows.push_back({results.experiment.methods[m].name, cell(median(values)), cell(mean.value()),
                          cell(*std::ranges::max_element(values))});
  }
  return table;
}

}  // namespace shapegauge
