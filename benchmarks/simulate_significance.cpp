// Simulates comparisons of two methods and prints how often each test is significant at 5 %, as a Markdown table
// (docs/notes/significance.md): queries as units, classes as units, and the t-test of the means of classes.

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

constexpr int trials = 2000;
constexpr int resamples = 999;
constexpr double alpha = 0.05;

/// A population of pairs of methods. The unit of differences is their standard deviation within a class.
struct Setting {
  std::vector<int> sizes;       ///< of the classes
  double class_deviation = 0;   ///< standard deviation of the classes' mean differences
  double difference = 0;        ///< mean over all classes of the population
  bool equal_on_these = false;  ///< the classes' effects are shifted to an average of 0 over the queries
  bool one_hit = false;         ///< differences of hits: 1, 0 or -1
};

double normal(RandomNumbers& random) {
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

Eigen::VectorXd drawn_differences(const Setting& setting, const std::vector<int>& classes, RandomNumbers& random) {
  Eigen::VectorXd effects(std::ssize(setting.sizes));
  for (double& effect : effects) effect = setting.difference + setting.class_deviation * normal(random);
  Eigen::VectorXd differences(std::ssize(classes));
  for (Eigen::Index i = 0; i < differences.size(); ++i) differences[i] = effects[classes[static_cast<std::size_t>(i)]];
  if (setting.equal_on_these) differences.array() -= differences.mean();
  for (double& difference : differences) {
    difference += normal(random);
    if (setting.one_hit) difference = difference > 1 ? 1 : difference < -1 ? -1 : 0;
  }
  return differences;
}

std::string row_of(const Setting& setting, std::uint64_t seed) {
  const std::vector<int> classes = classes_of(setting);
  int of_queries = 0;
  int of_classes = 0;
  int of_means = 0;
  for (int trial = 0; trial < trials; ++trial) {
    RandomNumbers random(seed, static_cast<std::uint64_t>(trial));
    const Eigen::VectorXd differences = drawn_differences(setting, classes, random);
    const ResamplingOptions options{.resamples = resamples, .seed = static_cast<std::uint64_t>(trial)};
    const auto rejects = [&](ResamplingUnit unit) {
      const UnitValues units = units_of(differences, classes, unit, Average::micro);
      return randomisation_p_value(units.values, units.weights, options) <= alpha;
    };
    of_queries += rejects(ResamplingUnit::queries) ? 1 : 0;
    of_classes += rejects(ResamplingUnit::classes) ? 1 : 0;
    of_means += class_p_value(differences, classes) <= alpha ? 1 : 0;
  }
  const bool equal_sizes = setting.sizes.front() == setting.sizes.back();
  const std::string sizes = equal_sizes ? fmt::format("{} of {}", setting.sizes.size(), setting.sizes.front())
                                        : fmt::format("{}", fmt::join(setting.sizes, ", "));
  const auto percent = [](int count) { return 100.0 * count / trials; };
  return fmt::format("| {} | {} | {:g}{} | {:g} | {:.1f} | {:.1f} | {:.1f} |\n", sizes,
                     setting.one_hit ? "hits" : "normal", setting.class_deviation,
                     setting.equal_on_these ? ", equal here" : "", setting.difference, percent(of_queries),
                     percent(of_classes), percent(of_means));
}

std::vector<Setting> settings() {
  std::vector<Setting> all;
  const std::vector<std::vector<int>> sizes{
      std::vector(6, 20), std::vector(10, 20), std::vector(30, 20), {18, 136, 6, 2, 16, 11}};
  for (const bool one_hit : {false, true}) {
    for (const std::vector<int>& size : sizes) {
      const double difference = size.size() == 30 ? 0.125 : 0.25;
      all.push_back({.sizes = size, .one_hit = one_hit});
      for (const double deviation : {0.3, 1.0}) {
        all.push_back({.sizes = size, .class_deviation = deviation, .one_hit = one_hit});
        all.push_back({.sizes = size, .class_deviation = deviation, .equal_on_these = true, .one_hit = one_hit});
      }
      all.push_back({.sizes = size, .difference = difference, .one_hit = one_hit});
      all.push_back({.sizes = size, .class_deviation = 0.3, .difference = 2 * difference, .one_hit = one_hit});
    }
  }
  return all;
}

}  // namespace

}  // namespace shapegauge

int main() {
  fmt::print(
      "| classes | scores | class deviation | difference | queries | classes | means of classes |\n"
      "|---|---|---|--:|--:|--:|--:|\n");
  std::uint64_t seed = 1;
  for (const shapegauge::Setting& setting : shapegauge::settings())
    fmt::print("{}", shapegauge::row_of(setting, seed++));
}
