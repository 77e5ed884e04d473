// Distances and measures of many synthetic signatures, in one process or, under mpirun, on several:
// seconds, memory, traffic. Results are in docs/notes/scaling.md; scripts/simulate_scaling extrapolates
// them.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>
#include <sys/resource.h>
#include <utility>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/experiments/distributed/communicator.h"
#include "shapegauge/experiments/distributed/packing.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/retrieval/judge_distances.h"

namespace shapegauge {

namespace {

constexpr int models_of_class = 50;

/// Histograms with a peak that depends on the class, plus noise; identical on all ranks.
Signatures make_signatures(const RankRange& models, int bins) {
  Signatures signatures(static_cast<Eigen::Index>(models.size()), bins);
  for (std::size_t model = models.first; model < models.last; ++model) {
    RandomNumbers random(model);
    RandomNumbers of_class(1'000'000'007 + model / models_of_class);
    const double centre = bins * of_class.uniform(0, 1);
    const double width = bins * (0.02 + 0.1 * of_class.uniform(0, 1));
    auto row = signatures.row(static_cast<Eigen::Index>(model - models.first));
    for (int bin = 0; bin < bins; ++bin) {
      const double place = (bin - centre) / width;
      row[bin] = static_cast<float>(std::exp(-place * place / 2) + 0.2 * random.uniform(0, 1));
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

/// Seconds for distributing empty jobs from the first rank to all others.
double hand_out(std::size_t jobs, Communicator& ranks) {
  const Stopwatch stopwatch;
  ranks.share_jobs(jobs, [&](Jobs& shared) {
    while ((ranks.size() == 1 || ranks.rank() > 0) && shared.next()) continue;
  });
  return stopwatch.seconds();
}

void measure(std::size_t models, int bins, Communicator& ranks) {
  constexpr std::size_t jobs = 10'000;
  const double handed_out = hand_out(jobs, ranks);
  const RankRange own = part_of_rank(models, ranks.rank(), ranks.size());
  const Signatures signatures = make_signatures(own, bins);
  std::vector<int> labels;
  for (std::size_t model = 0; model < models; ++model) labels.push_back(static_cast<int>(model / models_of_class));

  const Usage before = usage();
  const Stopwatch stopwatch;
  DistanceJudge judge(labels, own, {.evaluations = {{}}, .overview = false, .largest = 0, .file = {}}, ranks);
  visit_distances(distances().at("l1"), {.rows = signatures, .all = models}, ranks,
                  [&](Eigen::Index first, const DistanceTable& rows) { judge.add(first, rows); });
  const double own_seconds = stopwatch.seconds();
  const Judgement judgement = judge.finish();
  const double seconds = stopwatch.seconds();

  Usage after = usage();
  after.processor_seconds -= before.processor_seconds;
  const std::vector<std::string> all =
      ranks.gather(std::move(Packer().add(after).add(own_seconds).add(judge.seconds())).bytes());
  if (ranks.rank() != 0) return;
  nlohmann::ordered_json json{{"models", models},
                              {"bins", bins},
                              {"ranks", ranks.size()},
                              {"seconds", seconds},
                              {"micro_seconds_to_hand_out", 1e6 * handed_out / jobs},
                              {"FT", judgement.evaluations.front().micro[1]}};
  for (const std::string& one : all) {
    Unpacker unpacker(one);
    const auto of_rank = unpacker.take_value<Usage>();
    json["processor_seconds"].push_back(of_rank.processor_seconds);
    json["peak_megabytes"].push_back(of_rank.peak_megabytes);
    json["seconds_of_rank"].push_back(unpacker.take_value<double>());
    json["seconds_of_ranking"].push_back(unpacker.take_value<double>());
  }
  fmt::print("{}\n", json.dump());
}

}  // namespace

}  // namespace shapegauge

int main(int count, char** arguments) try {
  const std::size_t models = count > 1 ? std::stoul(arguments[1]) : 10'000;
  const int bins = count > 2 ? std::stoi(arguments[2]) : 80;
  const auto ranks = shapegauge::started_processes();
  shapegauge::with_threads(1, [&] { shapegauge::measure(models, bins, *ranks); });
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "measure_scaling: {}\n", error.what());
  return EXIT_FAILURE;
}
