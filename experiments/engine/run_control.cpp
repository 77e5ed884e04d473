// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/engine/run_control.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <new>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <utility>

#include "shapegauge/core/base/cancellation.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/preparation/prepare_shape.h"

namespace shapegauge {

int available_threads() { return tbb::info::default_concurrency(); }

int thread_count(const RunControl& control) { return control.threads > 0 ? control.threads : available_threads(); }

void with_threads(int threads, const std::function<void()>& work) {
  const int count = threads > 0 ? threads : available_threads();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
  tbb::task_arena arena(count);
  arena.execute(work);
}

void with_threads(const RunControl& control, const std::function<void()>& work) {
  with_threads(control.threads, [&] {
    if (control.cancellation == nullptr) return work();
    control.cancellation->run(work);
  });
}

namespace {

/// Returns the failures in the order of the models: only the first if it stopped the rest.
std::vector<ModelFailure> sort_failures(std::vector<ModelFailure> failures, bool stop_at_failure) {
  std::ranges::sort(failures, {}, &ModelFailure::model);
  if (stop_at_failure && failures.size() > 1) failures.resize(1);
  return failures;
}

/// Runs the jobs. `run_workers` calls a function as often as models are worked on at the same time.
std::vector<ModelFailure> run_jobs(std::span<const std::size_t> models, std::string_view stage, bool stop_at_failure,
                                   const RunControl& control, const std::function<void(std::size_t model)>& job,
                                   const std::function<void(const std::function<void()>&)>& run_workers) {
  std::vector<ModelFailure> failures;
  std::mutex mutex;
  std::size_t done = 0;
  std::atomic<bool> stopped = false;
  std::atomic<bool> out_of_memory = false;  // says nothing about the model
  const auto attempt = [&](std::size_t model) {
    try {
      // Isolated: a thread waiting for its own shape's samples must not start another shape.
      tbb::this_task_arena::isolate([&] { job(model); });
    } catch (const std::bad_alloc&) {
      out_of_memory = true;
      stopped = true;
    } catch (const std::exception& error) {
      const std::scoped_lock lock(mutex);
      failures.push_back({.model = model, .message = error.what()});
      // Cancelling the group would also interrupt the shapes in progress, which would count as failures.
      if (stop_at_failure) stopped = true;
    }
    const std::scoped_lock lock(mutex);
    control.progress(stage, ++done, models.size());
  };
  control.progress(stage, 0, models.size());
  // Models start in order. All models before the first failure have therefore been tried when it stops the rest, and
  // the first failure is the same on any number of threads.
  std::atomic<std::size_t> next = 0;
  run_workers([&] {
    while (!control.interrupted() && !stopped) {
      const std::size_t i = next++;
      if (i >= models.size()) break;
      attempt(models[i]);
    }
  });
  if (control.interrupted() || interruption_requested()) throw Interrupted();
  if (out_of_memory) throw std::bad_alloc();
  return sort_failures(std::move(failures), stop_at_failure);
}

}  // namespace

std::vector<ModelFailure> for_each_model(std::span<const std::size_t> models, std::string_view stage,
                                         bool stop_at_failure, const RunControl& control,
                                         const std::function<void(std::size_t model)>& job) {
  return run_jobs(models, stage, stop_at_failure, control, job, [](const std::function<void()>& worker) {
    tbb::parallel_for(
        0, tbb::this_task_arena::max_concurrency(), 1, [&](int) { worker(); }, tbb::simple_partitioner());
  });
}

std::vector<ModelFailure> for_each_model_in_turn(std::span<const std::size_t> models, std::string_view stage,
                                                 bool stop_at_failure, const RunControl& control,
                                                 const std::function<void(std::size_t model)>& job) {
  return run_jobs(models, stage, stop_at_failure, control, job, [](const std::function<void()>& worker) { worker(); });
}

std::vector<ModelFailure> validate_models(const Dataset& dataset, std::span<const std::size_t> models,
                                          const RunControl& control) {
  return for_each_model(models, "models", false, control,
                        [&](std::size_t model) { positive_area(read_shape(dataset.models[model].file)); });
}

}  // namespace shapegauge
