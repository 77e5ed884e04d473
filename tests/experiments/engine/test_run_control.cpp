// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <atomic>
#include <chrono>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>
#include <tbb/task_arena.h>
#include <thread>
#include <vector>

#include "shapegauge/experiments/engine/run_control.h"

namespace shapegauge {

namespace {

constexpr std::array<std::size_t, 2> two_models{0, 1};

/// Runs two jobs that both fail, on two threads, the one of model 0 after that of model 1 where they run side by side.
std::vector<ModelFailure> failures_of_two(bool stop_at_failure) {
  std::atomic<bool> second_is_over = false;
  std::vector<ModelFailure> failures;
  with_threads(2, [&] {
    failures = for_each_model(two_models, "test", stop_at_failure, {}, [&](std::size_t model) {
      if (model == 1) {
        second_is_over = true;
      } else {
        const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(2);
        while (!second_is_over && std::chrono::steady_clock::now() < patience) std::this_thread::yield();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
      }
      throw std::runtime_error("model " + std::to_string(model));
    });
  });
  return failures;
}

TEST(ForEachModel, ReturnsFailuresInTheOrderOfModels) {
  const std::vector<ModelFailure> failures = failures_of_two(false);
  ASSERT_EQ(failures.size(), 2U);
  EXPECT_EQ(failures[0].model, 0U);
  EXPECT_EQ(failures[1].message, "model 1");
}

TEST(ForEachModel, ReportsOnlyTheFirstFailureInModelOrderWhenStopping) {
  const std::vector<ModelFailure> failures = failures_of_two(true);
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_EQ(failures[0].message, "model 0");
}

TEST(ForEachModel, StartsNoMoreModelsAfterAFailure) {
  const std::vector<std::size_t> models{2, 3, 5, 7};
  std::vector<std::size_t> begun;
  with_threads(1, [&] {
    for_each_model(models, "test", true, {}, [&](std::size_t model) {
      begun.push_back(model);
      if (model == 3) throw std::runtime_error("no");
    });
  });
  EXPECT_THAT(begun, testing::ElementsAre(2, 3));
}

TEST(ForEachModel, PropagatesOutOfMemoryErrors) {
  const std::vector<std::size_t> models{0, 1, 2};
  const auto job = [](std::size_t model) {
    if (model == 1) throw std::bad_alloc();
  };
  EXPECT_THROW(for_each_model(models, "models", false, {}, job), std::bad_alloc);
}

TEST(ForEachModelInTurn, ProcessesOneModelAtATimeWithAllThreads) {
  const std::vector<std::size_t> models{2, 3, 5, 7};
  int jobs = 0;
  std::atomic<int> running = 0;
  with_threads(3, [&] {
    const auto failures = for_each_model_in_turn(models, "test", false, {}, [&](std::size_t) {
      EXPECT_EQ(++running, 1);
      EXPECT_EQ(tbb::this_task_arena::max_concurrency(), 3);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      --running;
      ++jobs;
    });
    EXPECT_THAT(failures, testing::IsEmpty());
  });
  EXPECT_EQ(jobs, 4);
}

TEST(ForEachModel, ThrowsIfInterrupted) {
  const RunControl control{.interrupted = [] { return true; }};
  EXPECT_THROW(for_each_model(two_models, "test", false, control, [](std::size_t) {}), Interrupted);
}

}  // namespace

}  // namespace shapegauge
