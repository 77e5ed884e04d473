// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <gtest/gtest.h>
#include <thread>

#include "shapegauge/core/base/cancellation.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/base/parallel_parts.h"

namespace shapegauge {

namespace {

TEST(Cancellation, UncancelledTasksRunAndTheirExceptionsAreRethrown) {
  Cancellation cancellation;
  int done = 0;
  cancellation.run([&] { ++done; });
  cancellation.run([&] { ++done; });
  EXPECT_EQ(done, 2);
  EXPECT_THROW(cancellation.run([] { throw ArgumentError("no"); }), ArgumentError);
  EXPECT_NO_THROW(cancellation.run([] { check_interruption(); }));
}

TEST(Cancellation, PreventsLaterTasksFromStarting) {
  Cancellation cancellation;
  cancellation.cancel();
  EXPECT_TRUE(cancellation.requested());
  EXPECT_THROW(cancellation.run([] { FAIL(); }), Interrupted);
}

TEST(Cancellation, FromAnotherThreadStopsNestedLoops) {
  Cancellation cancellation;
  std::atomic<bool> begun = false;
  std::atomic<bool> after_inner_loop = false;
  std::thread other([&] {
    while (!begun) std::this_thread::yield();
    cancellation.cancel();
  });
  EXPECT_THROW(cancellation.run([&] {
    parallel_for(0, 4, [&](int) {
      // Too long to finish: only cancellation ends it.
      parallel_for(std::int64_t{0}, std::int64_t{1} << 60, [&](std::int64_t) { begun = true; });
      after_inner_loop = true;
    });
  }),
               Interrupted);
  other.join();
  EXPECT_FALSE(after_inner_loop);
}

TEST(Cancellation, StopsASerialLoop) {
  Cancellation cancellation;
  EXPECT_THROW(cancellation.run([&] {
    for_each_index(false, std::int64_t{0}, std::int64_t{1} << 60, [&](std::int64_t i) {
      if (i == 1000) cancellation.cancel();
    });
  }),
               Interrupted);
  EXPECT_THROW(cancellation.run([] {}), Interrupted);
}

TEST(Cancellation, DoesNotStopTasksThatWereNotCancelled) {
  Cancellation cancelled;
  cancelled.cancel();
  Cancellation other;
  std::atomic<int> done = 0;
  other.run([&] { parallel_for(0, 100, [&](int) { ++done; }); });
  EXPECT_EQ(done, 100);
}

TEST(SparseInterruptionCheck, StopsALoopOfShortStepsAfterCancellation) {
  Cancellation cancellation;
  EXPECT_THROW(cancellation.run([&] {
    cancellation.cancel();
    const SparseInterruptionCheck check;
    while (true) check();
  }),
               Interrupted);
}

TEST(ParallelLoops, VisitEachIndexOnceAndReduceResults) {
  std::vector<int> counts(1000, 0);
  parallel_for(std::size_t{0}, counts.size(), [&](std::size_t i) { ++counts[i]; });
  for_each_index(true, std::size_t{0}, counts.size(), [&](std::size_t i) { ++counts[i]; });
  for_each_index(false, std::size_t{0}, counts.size(), [&](std::size_t i) { ++counts[i]; });
  parallel_for(5, 5, [](int) { FAIL(); });
  parallel_for(5, 3, [](int) { FAIL(); });
  const tbb::blocked_range<std::size_t> all(0, counts.size());
  interruptible_parallel_for(all, [&](const auto& part) {
    for (std::size_t i = part.begin(); i < part.end(); ++i) ++counts[i];
  });
  const int sum = interruptible_parallel_reduce(
      all, 0,
      [&](const auto& part, int before) {
        for (std::size_t i = part.begin(); i < part.end(); ++i) before += counts[i];
        return before;
      },
      [](int a, int b) { return a + b; });
  EXPECT_EQ(sum, 4000);
  EXPECT_EQ(counts, std::vector<int>(1000, 4));
}

}  // namespace

}  // namespace shapegauge
