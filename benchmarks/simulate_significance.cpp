// SPDX-License-Identifier: GPL-3.0-or-later
// Simulates comparisons of two methods and prints how often each test is significant at 5 %, as a Markdown table
// (docs/notes/significance.md): over queries, over class means by exchange, and the t-test of class means.

#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/metrics/method_comparison.h"

namespace shapegauge {

namespace {

constexpr int trials = 6000;
constexpr int resamples = 199;
constexpr double alpha = 0.05;

/// Pair of methods. Differences vary within a class with standard deviation 1.
struct Setting {
  std::vector<int> sizes;       ///< of the classes
  double class_deviation = 0;   ///< standard deviation of the mean differences of classes
  double difference = 0;        ///< mean over all classes of the population
  bool equal_on_these = false;  ///< class effects are shifted to a mean of 0 over the queries
};

double standard_normal(RandomNumbers& random) {
  constexpr double two_pi = 6.283185307179586;
  return std::sqrt(-2 * std::log(1 - random.uniform(0, 1))) * std::cos(two_pi * random.uniform(0, 1));
}

std::vector<int> classes_of(const Setting& setting) {
  std::vector<int> classes;
  for (std::size_t c = 0; c < setting.sizes.size(); ++c) {
    classes.insert(classes.end(), static_cast<std::size_t>(setting.sizes[c]), static_cast<int>(c));
  }
  return classes;
}

Eigen::VectorXd draw_differences(const Setting& setting, const std::vector<int>& classes, RandomNumbers& random) {
  Eigen::VectorXd effects(std::ssize(setting.sizes));
  for (double& effect : effects) effect = setting.difference + setting.class_deviation * standard_normal(random);
  Eigen::VectorXd differences = effects(classes);
  if (setting.equal_on_these) differences.array() -= differences.mean();
  for (double& difference : differences) difference += standard_normal(random);
  return differences;
}

// Returns a row of the table. The seed makes rows independent.
std::string row_of(const Setting& setting, std::uint64_t seed) {
  const std::vector<int> classes = classes_of(setting);
  int over_queries = 0;
  int over_classes = 0;
  int class_means = 0;
  for (int trial = 0; trial < trials; ++trial) {
    RandomNumbers random(seed, static_cast<std::uint64_t>(trial));
    const Eigen::VectorXd differences = draw_differences(setting, classes, random);
    const ResamplingOptions options{.resamples = resamples, .seed = random.next()};
    const auto is_significant = [&](ResamplingUnit unit, Average average) {
      const UnitValues units = unit_values_of(differences, classes, unit, average);
      return randomisation_p_value(units.values, units.weights, options) <= alpha;
    };
    over_queries += is_significant(ResamplingUnit::queries, Average::micro) ? 1 : 0;
    over_classes += is_significant(ResamplingUnit::classes, Average::macro) ? 1 : 0;
    class_means += class_p_value(differences, classes) <= alpha ? 1 : 0;
  }
  const bool equal_sizes = setting.sizes.front() == setting.sizes.back();
  const std::string sizes = equal_sizes ? fmt::format("{} of {}", setting.sizes.size(), setting.sizes.front())
                                        : fmt::format("{}", fmt::join(setting.sizes, ", "));
  const auto percent = [](int count) { return 100.0 * count / trials; };
  return fmt::format("| {} | {:g}{} | {:g} | {:.1f} | {:.1f} | {:.1f} |\n", sizes, setting.class_deviation,
                     setting.equal_on_these ? ", mean 0 on these" : "", setting.difference, percent(over_queries),
                     percent(over_classes), percent(class_means));
}

std::vector<Setting> simulated_settings() {
  std::vector<Setting> all;
  const std::vector<std::vector<int>> sizes{
      std::vector(6, 20), std::vector(10, 20), std::vector(30, 20), {18, 136, 6, 2, 16, 11}};
  for (const std::vector<int>& size : sizes) {
    const double difference = size.size() == 30 ? 0.125 : 0.25;
    all.push_back({.sizes = size});
    all.push_back({.sizes = size, .class_deviation = 0.6});
    all.push_back({.sizes = size, .class_deviation = 0.6, .equal_on_these = true});
    all.push_back({.sizes = size, .difference = difference});
    all.push_back({.sizes = size, .class_deviation = 0.6, .difference = 0.6});
  }
  return all;
}

}  // namespace

}  // namespace shapegauge

int main() {
  fmt::print(
      "| class sizes | deviation of classes | difference | queries | class means, exchanged | class means, t |\n"
      "|---|---|--:|--:|--:|--:|\n");
  std::uint64_t seed = 1;
  for (const shapegauge::Setting& setting : shapegauge::simulated_settings())
    fmt::print("{}", shapegauge::row_of(setting, seed++));
}
