#include "shapegauge/experiments/engine/run_control.h"

#include <algorithm>
#include <mutex>
#include <numeric>
#include <optional>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "shapegauge/core/base/cancellation.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/experiments/distributed/packing.h"

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

std::vector<ModelFailure> for_each_model(std::span<const std::size_t> models, std::string_view stage,
                                         bool stop_at_failure, const RunControl& control,
                                         const std::function<void(std::size_t model)>& job) {
  return for_each_model(models, stage, stop_at_failure, control, *single_process(), job);
}

namespace {

/// Runs the jobs on all ranks. `run_workers` calls a function as often as a rank works on models at the same time.
std::vector<ModelFailure> share_models(std::span<const std::size_t> models, std::string_view stage,
                                       bool stop_at_failure, const RunControl& control, Communicator& ranks,
                                       const std::function<void(std::size_t model)>& job,
                                       const std::function<void(const std::function<void()>&)>& run_workers) {
  std::vector<ModelFailure> failures;
  std::mutex mutex;
  std::size_t done = 0;
  const auto attempt = [&](std::size_t model, Jobs& jobs) {
    try {
      // Isolated: a thread waiting for its own shape's samples must not start another shape.
      tbb::this_task_arena::isolate([&] { job(model); });
    } catch (const std::exception& error) {
      const std::scoped_lock lock(mutex);
      failures.push_back({.model = model, .message = error.what()});
      // Cancelling the group would also interrupt the shapes in progress, which would count as failures.
      if (stop_at_failure) jobs.stop();
    }
    const std::scoped_lock lock(mutex);
    ++done;
    control.progress(stage, ranks.size() == 1 ? done : jobs.handed_out(), models.size());
  };
  control.progress(stage, 0, models.size());
  // Models start in order. All models before the first failure have therefore been tried when it stops the rest, and
  // the first failure is the same on any number of threads.
  ranks.share_jobs(models.size(), [&](Jobs& jobs) {
    run_workers([&] {
      while (!control.interrupted()) {
        const std::optional<std::size_t> next = jobs.next();
        if (!next) break;
        attempt(models[*next], jobs);
      }
    });
  });
  if (control.interrupted() || interruption_requested()) throw Interrupted();
  std::ranges::sort(failures, {}, &ModelFailure::model);
  if (stop_at_failure && failures.size() > 1) failures.resize(1);
  return failures;
}

}  // namespace

std::vector<ModelFailure> for_each_model(std::span<const std::size_t> models, std::string_view stage,
                                         bool stop_at_failure, const RunControl& control, Communicator& ranks,
                                         const std::function<void(std::size_t model)>& job) {
  return share_models(models, stage, stop_at_failure, control, ranks, job, [](const std::function<void()>& worker) {
    tbb::parallel_for(
        0, tbb::this_task_arena::max_concurrency(), 1, [&](int) { worker(); }, tbb::simple_partitioner());
  });
}

std::vector<ModelFailure> for_each_model_in_turn(std::span<const std::size_t> models, std::string_view stage,
                                                 bool stop_at_failure, const RunControl& control, Communicator& ranks,
                                                 const std::function<void(std::size_t model)>& job) {
  return share_models(models, stage, stop_at_failure, control, ranks, job,
                      [](const std::function<void()>& worker) { worker(); });
}

std::vector<ModelFailure> failures_of_all(const std::vector<ModelFailure>& own, Communicator& ranks) {
  Packer packer;
  for (const ModelFailure& failure : own) packer.add(failure.model).add(failure.message);
  Packer together;
  for (const std::string& part : ranks.gather(std::move(packer).bytes())) together.add_bytes(part.data(), part.size());
  const std::string bytes = ranks.broadcast(std::move(together).bytes());
  std::vector<ModelFailure> all;
  for (Unpacker unpacker(bytes); !unpacker.is_at_end();) {
    ModelFailure& failure = all.emplace_back();
    unpacker.take(failure.model).take(failure.message);
  }
  std::ranges::sort(all, {}, &ModelFailure::model);
  return all;
}

CacheReport cache_report(const Cache& cache, Communicator& ranks) {
  CacheReport report = cache.report();
  const std::vector<std::string> parts = ranks.gather(std::move(Packer().add(report.uses)).bytes());
  if (parts.empty()) return report;
  report.uses = {};
  for (const std::string& part : parts) {
    const auto uses = Unpacker(part).take_value<decltype(report.uses)>();
    for (std::size_t kind = 0; kind < uses.size(); ++kind) {
      report.uses.at(kind).hits += uses.at(kind).hits;
      report.uses.at(kind).computed += uses.at(kind).computed;
    }
  }
  return report;
}

std::vector<ModelFailure> validate_models(const Dataset& dataset, const RunControl& control) {
  std::vector<std::size_t> all(dataset.models.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return for_each_model(all, "models", false, control,
                        [&](std::size_t model) { positive_area(read_shape(dataset.models[model].file)); });
}

}  // namespace shapegauge
