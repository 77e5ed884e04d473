// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/base/parameter.h"
#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/cache/cache.h"

namespace shapegauge {

class Cancellation;

/// Bounds of the number of threads that users can request.
inline constexpr Bounds threads_bounds{.low = 1, .high = 1024};

/// Control of a run by its caller: threads, cancellation, progress.
struct RunControl {
  int threads = 0;  ///< number of threads; 0 for all cores of the machine
  std::function<bool()> interrupted = [] {
    return false;
  };                                     ///< called between shapes, from any thread; returning true stops the run
  Cancellation* cancellation = nullptr;  ///< if not null, also interrupts shapes in progress; not owned
  /// Progress callback: receives the name of the current step and the numbers of finished and of all items, such as
  /// models, of that step. Calls are serialised.
  std::function<void(std::string_view stage, std::size_t done, std::size_t total)> progress =
      [](std::string_view, std::size_t, std::size_t) {};
  bool bold = false;  ///< true to print the best scores of the summary in bold, for a terminal
};

/// Shape that a run omitted, with the reason.
struct LeftOutShape {
  std::string id;                   ///< id of the shape in the data set
  std::string message;              ///< reason why the run omitted the shape
  std::filesystem::path file = {};  ///< file of the shape; empty for a generated shape
};

/// Returns the number of hardware threads of the machine, which is used if 0 threads are requested.
int available_threads();

/// Returns the number of threads of a run.
int thread_count(const RunControl& control);

/// Runs the work on at most `threads` threads (0: available_threads()), including the calling one.
void with_threads(int threads, const std::function<void()>& work);

/// Runs the work with the threads that the control requests; its cancellation stops the work. Throws Interrupted.
void with_threads(const RunControl& control, const std::function<void()>& work);

/// Runs a job for each index in `models`, started in this order, in parallel in the calling TBB arena. Returns the
/// index and the message of each job that throws, in the order of indices. With stop_at_failure, jobs not yet started
/// are skipped, and only the first failure is returned. `stage` names the work in progress reports. Throws Interrupted,
/// and std::bad_alloc, which stops all jobs.
std::vector<ModelFailure> for_each_model(std::span<const std::size_t> models, std::string_view stage,
                                         bool stop_at_failure, const RunControl& control,
                                         const std::function<void(std::size_t model)>& job);

/// Like for_each_model(), but works on one model at a time, in the calling thread: each model has all threads.
std::vector<ModelFailure> for_each_model_in_turn(std::span<const std::size_t> models, std::string_view stage,
                                                 bool stop_at_failure, const RunControl& control,
                                                 const std::function<void(std::size_t model)>& job);

/// Reads the models with these indices in parallel and returns, in order, those that cannot be read or have no surface
/// area, with the reasons. Runs in the calling TBB arena. Throws Interrupted.
std::vector<ModelFailure> validate_models(const Dataset& dataset, std::span<const std::size_t> models,
                                          const RunControl& control);

}  // namespace shapegauge
