#include "shapegauge/experiments/runner/with_threads.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

namespace shapegauge {

int available_threads() { return tbb::info::default_concurrency(); }

void with_threads(int threads, const std::function<void()>& work) {
  const int count = threads > 0 ? threads : available_threads();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
  tbb::task_arena arena(count);
  arena.execute(work);
}

}  // namespace shapegauge
