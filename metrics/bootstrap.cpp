// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/metrics/bootstrap.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"

namespace shapegauge {

double significance_level(double confidence) {
  constexpr double steps = 1e12;
  return std::round((1 - confidence) * steps) / steps;
}

namespace {

std::map<int, double> sizes_of(std::span<const int> classes) {
  std::map<int, double> sizes;
  for (const int label : classes) sizes[label] += 1;
  return sizes;
}

UnitValues query_units(const Eigen::MatrixXd& per_query, std::span<const int> classes, Average average) {
  const std::map<int, double> sizes = sizes_of(classes);
  UnitValues units{per_query, Eigen::VectorXd(per_query.rows())};
  for (Eigen::Index row = 0; row < per_query.rows(); ++row) {
    const double size = sizes.at(classes[static_cast<std::size_t>(row)]);
    units.weights[row] = average == Average::micro ? 1.0 : 1.0 / size;
  }
  return units;
}

UnitValues class_units(const Eigen::MatrixXd& per_query, std::span<const int> classes, Average average) {
  const std::map<int, double> sizes = sizes_of(classes);
  std::map<int, Eigen::Index> unit_of_class;
  for (const int label : classes) unit_of_class.emplace(label, static_cast<Eigen::Index>(unit_of_class.size()));
  const auto count = static_cast<Eigen::Index>(sizes.size());
  UnitValues units{Eigen::MatrixXd::Zero(count, per_query.cols()), Eigen::VectorXd(count)};
  for (Eigen::Index row = 0; row < per_query.rows(); ++row) {
    units.values.row(unit_of_class.at(classes[static_cast<std::size_t>(row)])) += per_query.row(row);
  }
  for (const auto& [label, size] : sizes) {
    const Eigen::Index unit = unit_of_class.at(label);
    units.values.row(unit) /= size;
    units.weights[unit] = average == Average::micro ? size : 1.0;
  }
  return units;
}

}  // namespace

UnitValues unit_values_of(const Eigen::MatrixXd& per_query, std::span<const int> classes, ResamplingUnit unit,
                          Average average) {
  if (per_query.rows() == 0) throw ArgumentError("statistics need at least one query, and there is none");
  if (static_cast<std::size_t>(per_query.rows()) != classes.size()) {
    throw ArgumentError("values of " + std::to_string(per_query.rows()) + " queries, but classes of " +
                        std::to_string(classes.size()));
  }
  UnitValues units = unit == ResamplingUnit::queries ? query_units(per_query, classes, average)
                                                     : class_units(per_query, classes, average);
  units.weights /= units.weights.sum();
  return units;
}

Eigen::VectorXd averages_of(const UnitValues& units) { return units.values.transpose() * units.weights; }

Eigen::VectorXd contributions(const Eigen::VectorXd& differences, const Eigen::VectorXd& weights) {
  return static_cast<double>(differences.size()) * differences.cwiseProduct(weights);
}

namespace {

// Returns the fraction of the resampled averages to cut off on each side.
double tail_of(double confidence, Eigen::Index units) {
  const auto n = static_cast<double>(units);
  const boost::math::students_t student(n - 1);
  const double t = boost::math::quantile(boost::math::complement(student, (1 - confidence) / 2));
  return boost::math::cdf(boost::math::normal(), -std::sqrt(n / (n - 1)) * t);
}

// Interpolates linearly between order statistics; the i-th of B is the quantile i / (B + 1). Reorders the values.
double quantile(Eigen::VectorXd& values, double fraction) {
  const auto count = static_cast<double>(values.size());
  const double position = std::clamp(fraction * (count + 1) - 1, 0.0, count - 1);
  const auto below = values.begin() + static_cast<Eigen::Index>(position);
  std::nth_element(values.begin(), below, values.end());
  const auto above = below + 1 == values.end() ? below : std::min_element(below + 1, values.end());
  return *below + (position - std::floor(position)) * (*above - *below);
}

}  // namespace

Eigen::MatrixXd bootstrap_averages(const UnitValues& units, const ResamplingOptions& options) {
  check_options("bootstrap", resampling_table, options);
  const auto count = static_cast<std::uint64_t>(units.values.rows());
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const RowMajor weighted = units.weights.asDiagonal() * units.values;
  Eigen::MatrixXd averages(options.resamples, units.values.cols());
  parallel_for(0, options.resamples, [&](int resample) {
    RandomNumbers random(options.seed, static_cast<std::uint64_t>(resample));
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(units.values.cols());
    double weight = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto drawn = static_cast<Eigen::Index>(random.below(count));
      sum += weighted.row(drawn);
      weight += units.weights[drawn];
    }
    averages.row(resample) = sum / weight;
  });
  return averages;
}

std::vector<ConfidenceInterval> percentile_intervals(const Eigen::MatrixXd& resampled, Eigen::Index units,
                                                     double confidence) {
  if (units < 2) {
    throw ArgumentError("a confidence interval needs at least two classes or queries to draw from, there is " +
                        std::to_string(units));
  }
  if (!confidence_bounds.contains(confidence)) {
    throw ArgumentError("the confidence must be " + to_string(confidence_bounds) + ", not " +
                        std::to_string(confidence));
  }
  const double tail = tail_of(confidence, units);
  std::vector<ConfidenceInterval> intervals;
  for (Eigen::Index method = 0; method < resampled.cols(); ++method) {
    Eigen::VectorXd values = resampled.col(method);
    const double low = quantile(values, tail);
    intervals.push_back({low, quantile(values, 1 - tail)});
  }
  return intervals;
}

std::vector<ConfidenceInterval> bootstrap_intervals(const UnitValues& units, double confidence,
                                                    const ResamplingOptions& options) {
  return percentile_intervals(bootstrap_averages(units, options), units.values.rows(), confidence);
}

}  // namespace shapegauge
