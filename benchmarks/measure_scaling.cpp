// SPDX-License-Identifier: GPL-3.0-or-later
// Distances and measures of a part of the rows of many synthetic signatures on one thread: seconds and memory.
// Results are in docs/notes/scaling.md; scripts/simulate_scaling extrapolates them.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>
#include <sys/resource.h>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/experiments/engine/part.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/retrieval/judge_distances.h"

namespace shapegauge {

namespace {

constexpr int models_of_class = 50;

/// Histograms with a peak that depends on the class, plus noise.
Signatures make_signatures(std::size_t models, int bins) {
  Signatures signatures(static_cast<Eigen::Index>(models), bins);
  for (std::size_t model = 0; model < models; ++model) {
    RandomNumbers random(model);
    RandomNumbers of_class(1'000'000'007 + model / models_of_class);
    const double centre = bins * of_class.uniform(0, 1);
    const double width = bins * (0.02 + 0.1 * of_class.uniform(0, 1));
    auto row = signatures.row(static_cast<Eigen::Index>(model));
    for (int bin = 0; bin < bins; ++bin) {
      const double deviation = (bin - centre) / width;
      row[bin] = static_cast<float>(std::exp(-deviation * deviation / 2) + 0.2 * random.uniform(0, 1));
    }
    row /= row.sum();
  }
  return signatures;
}

struct Usage {
  double processor_seconds = 0;
  double peak_megabytes = 0;
};

Usage usage() {
  rusage all{};
  ::getrusage(RUSAGE_SELF, &all);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return {.processor_seconds = seconds(all.ru_utime) + seconds(all.ru_stime),
          .peak_megabytes = static_cast<double>(all.ru_maxrss) / 1024};
}

void measure(std::size_t models, int bins, const Part& part) {
  constexpr Eigen::Index rows_of_block = 512;
  const Signatures signatures = make_signatures(models, bins);
  std::vector<int> labels;
  for (std::size_t model = 0; model < models; ++model) labels.push_back(static_cast<int>(model / models_of_class));
  const RetrievalTask task = leave_one_out(labels);
  const std::vector<EvaluationOptions> evaluations(1);

  const Usage before = usage();
  const Stopwatch stopwatch;
  double evaluating = 0;
  Eigen::Index rows = 0;
  std::size_t block = 0;
  for (Eigen::Index first = 0; first < signatures.rows(); first += rows_of_block) {
    if (!part.has(block++)) continue;
    const RowRange range{.first = first, .last = std::min(first + rows_of_block, signatures.rows())};
    const auto visit = [&](const RowVisitor& judge) {
      visit_distances(distances().at("l1"), signatures, range, judge);
    };
    (void)evaluate_row_range(task, evaluations, range, visit, evaluating);
    rows += range.last - range.first;
  }
  const nlohmann::ordered_json json{{"models", models},
                                    {"bins", bins},
                                    {"rows", rows},
                                    {"seconds", stopwatch.seconds()},
                                    {"seconds_of_ranking", evaluating},
                                    {"processor_seconds", usage().processor_seconds - before.processor_seconds},
                                    {"peak_megabytes", usage().peak_megabytes}};
  fmt::print("{}\n", json.dump());
}

}  // namespace

}  // namespace shapegauge

int main(int count, char** arguments) try {
  const std::size_t models = count > 1 ? std::stoul(arguments[1]) : 10'000;
  const int bins = count > 2 ? std::stoi(arguments[2]) : 80;
  const shapegauge::Part part = shapegauge::parse_part(count > 3 ? arguments[3] : "1/1");
  shapegauge::with_threads(1, [&] { shapegauge::measure(models, bins, part); });
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "measure_scaling: {}\n", error.what());
  return EXIT_FAILURE;
}
