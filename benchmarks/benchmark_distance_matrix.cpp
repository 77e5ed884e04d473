// SPDX-License-Identifier: GPL-3.0-or-later
// L1 distances between signatures of 240 entries, on one thread: a plain double loop, ours, and ours row by row without
// keeping the matrix. The argument is the number of signatures; the counter, seconds a pair. Also measured are bounds:
// the distances of equally many pairs of cached signatures, and writing the matrix alone.

#include <benchmark/benchmark.h>
#include <cmath>
#include <span>
#include <tbb/task_arena.h>
#include <vector>

#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/retrieval/l1_distance.h"

namespace {

using namespace shapegauge;

Signatures random_signatures(Eigen::Index count) {
  std::srand(1);
  return Signatures::Random(count, 240).cwiseAbs();
}

void count_pairs(benchmark::State& state, double pairs) {
  state.counters["seconds a pair"] =
      benchmark::Counter(pairs, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void plain(benchmark::State& state) {
  const Signatures signatures = random_signatures(state.range(0));
  const Eigen::Index count = signatures.rows();
  for ([[maybe_unused]] const auto iteration : state) {
    DistanceMatrix matrix = DistanceMatrix::Zero(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
      for (Eigen::Index j = i + 1; j < count; ++j) {
        double sum = 0;
        for (Eigen::Index k = 0; k < signatures.cols(); ++k) {
          sum += std::abs(static_cast<double>(signatures(i, k)) - static_cast<double>(signatures(j, k)));
        }
        matrix(i, j) = matrix(j, i) = sum;
      }
    }
    benchmark::DoNotOptimize(matrix.data());
  }
  count_pairs(state, static_cast<double>(count * (count - 1)) / 2);
}

void ours(benchmark::State& state) {
  const Signatures signatures = random_signatures(state.range(0));
  const Eigen::Index count = signatures.rows();
  tbb::task_arena one_thread(1);
  for ([[maybe_unused]] const auto iteration : state) {
    one_thread.execute([&] { benchmark::DoNotOptimize(distance_matrix(signatures)); });
  }
  count_pairs(state, static_cast<double>(count * (count - 1)) / 2);
}

void rows(benchmark::State& state) {
  const Signatures signatures = random_signatures(state.range(0));
  constexpr Eigen::Index together = 100;
  tbb::task_arena one_thread(1);
  for ([[maybe_unused]] const auto iteration : state) {
    for (Eigen::Index first = 0; first < signatures.rows(); first += together) {
      one_thread.execute(
          [&] { benchmark::DoNotOptimize(distance_rows(signatures, first, together, distances().at("l1"))); });
    }
  }
  count_pairs(state, static_cast<double>(signatures.rows() * signatures.rows()));
}

/// Equally many pairs of the same few signatures.
void arithmetic(benchmark::State& state) {
  constexpr Eigen::Index few = 32;
  const Signatures signatures = random_signatures(few);
  const std::span<const float> entries(signatures.data(), static_cast<std::size_t>(signatures.size()));
  std::vector<double> distances(few * few);
  const Eigen::Index pairs = state.range(0) * (state.range(0) - 1) / 2;
  for ([[maybe_unused]] const auto iteration : state) {
    for (Eigen::Index done = 0; done < pairs; done += few * few) {
      l1_distances(entries, entries, static_cast<std::size_t>(signatures.cols()), distances);
      benchmark::DoNotOptimize(distances.data());
    }
  }
  count_pairs(state, static_cast<double>(pairs));
}

/// Only writes a matrix of that size.
void memory(benchmark::State& state) {
  const Eigen::Index count = state.range(0);
  for ([[maybe_unused]] const auto iteration : state) {
    DistanceMatrix matrix = DistanceMatrix::Constant(count, count, 1);
    benchmark::DoNotOptimize(matrix.data());
  }
  count_pairs(state, static_cast<double>(count * (count - 1)) / 2);
}

BENCHMARK(plain)->Arg(2'000)->Arg(20'000)->Unit(benchmark::kMillisecond);
BENCHMARK(ours)->Arg(2'000)->Arg(20'000)->Unit(benchmark::kMillisecond);
BENCHMARK(rows)->Arg(2'000)->Arg(20'000)->Unit(benchmark::kMillisecond);
BENCHMARK(arithmetic)->Arg(2'000)->Arg(20'000)->Unit(benchmark::kMillisecond);
BENCHMARK(memory)->Arg(2'000)->Arg(20'000)->Unit(benchmark::kMillisecond);

}  // namespace
