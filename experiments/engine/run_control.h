#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/interruption.h"
#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/distributed/communicator.h"

namespace shapegauge {

/// Lets the caller of a run watch and stop it.
struct RunControl {
  int threads = 0;                                           ///< 0: as many as the machine has
  std::function<bool()> interrupted = [] { return false; };  ///< asked between shapes; true: stop soon. Any thread.
  Cancellation* cancellation = nullptr;                      ///< stops the shapes that are under way as well
  /// Told what is being done and how far it is; one call at a time.
  std::function<void(std::string_view stage, std::size_t done, std::size_t total)> progress =
      [](std::string_view, std::size_t, std::size_t) {};
};

/// A shape that a run went on without.
struct LeftOutShape {
  std::string id;
  std::string message;
};

/// The number of hardware threads, which 0 stands for.
int available_threads();

/// Runs the work on at most `threads` threads (0: available_threads()), the calling one included.
void with_threads(int threads, const std::function<void()>& work);

/// The same with the threads of a run, and within its cancellation. Throws Interrupted.
void with_threads(const RunControl& control, const std::function<void()>& work);

/// Runs a job for each model, in parallel, in the calling TBB arena. A job that throws makes its model a failure; with
/// stop_at_failure, jobs that have not begun by then are skipped, and only the first failure counts. Models begin in
/// their order. Returns the failures in that order. Throws Interrupted.
std::vector<ModelFailure> for_each_model(std::span<const std::size_t> models, std::string_view stage,
                                         bool stop_at_failure, const RunControl& control,
                                         const std::function<void(std::size_t model)>& job);

/// The same, shared by processes: all of them call it with the same models, and each returns the failures of those jobs
/// that it has done.
std::vector<ModelFailure> for_each_model(std::span<const std::size_t> models, std::string_view stage,
                                         bool stop_at_failure, const RunControl& control, Communicator& ranks,
                                         const std::function<void(std::size_t model)>& job);

/// Collective. The failures of all ranks, in the models' order.
std::vector<ModelFailure> failures_of_all(const std::vector<ModelFailure>& own, Communicator& ranks);

/// Collective. What all ranks took from the cache, on rank 0.
CacheReport report_of(const Cache& cache, Communicator& ranks);

/// Reads every model as a run would, in parallel, and returns those that a run could not use, in order. Throws
/// Interrupted. Runs in the calling TBB arena.
std::vector<ModelFailure> validate_models(const Dataset& dataset, const RunControl& control);

}  // namespace shapegauge
