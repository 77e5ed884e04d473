#include "shapegauge/core/base/interruption.h"

#include <memory>
#include <tbb/parallel_for.h>

namespace shapegauge {

void Cancellation::run(const std::function<void()>& work) {
  // Contexts of loops within the work are bound to this one, which hands the cancellation down to all of them.
  tbb::task_group_context context(tbb::task_group_context::isolated);
  {
    const std::scoped_lock lock(mutex_);
    if (requested_) throw Interrupted();
    running_.push_back(&context);
  }
  const auto forget = [&](const Cancellation*) {
    const std::scoped_lock lock(mutex_);
    std::erase(running_, &context);
  };
  const std::unique_ptr<Cancellation, decltype(forget)> at_the_end(this, forget);
  tbb::parallel_for(
      0, 1, [&](int) { work(); }, context);
  if (requested_) throw Interrupted();
}

void Cancellation::cancel() {
  const std::scoped_lock lock(mutex_);
  requested_ = true;
  for (tbb::task_group_context* context : running_) context->cancel_group_execution();
}

}  // namespace shapegauge
