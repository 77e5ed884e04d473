#include "shapegauge/core/base/interruption.h"

#include <tbb/parallel_for.h>

namespace shapegauge {

/// Makes a context reachable by cancel() while the object lives.
class Cancellation::Registration {
 public:
  Registration(Cancellation& cancellation, tbb::task_group_context& context)
      : cancellation_(cancellation), context_(context) {
    const std::scoped_lock lock(cancellation_.mutex_);
    if (cancellation_.requested_) throw Interrupted();
    cancellation_.running_.push_back(&context_);
  }
  Registration(const Registration&) = delete;
  Registration& operator=(const Registration&) = delete;
  Registration(Registration&&) = delete;
  Registration& operator=(Registration&&) = delete;
  ~Registration() {
    const std::scoped_lock lock(cancellation_.mutex_);
    std::erase(cancellation_.running_, &context_);
  }

 private:
  Cancellation& cancellation_;
  tbb::task_group_context& context_;
};

void Cancellation::run(const std::function<void()>& work) {
  // Contexts of loops within the work are bound to this one, which passes its cancellation on to them.
  tbb::task_group_context context(tbb::task_group_context::isolated);
  const Registration registration(*this, context);
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
