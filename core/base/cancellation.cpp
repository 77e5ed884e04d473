// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/base/cancellation.h"

#include <tbb/parallel_for.h>

#include "shapegauge/core/base/interruption.h"

namespace shapegauge {

/// Context of running work, reachable by cancel() while the object lives.
class Cancellation::Registration {
 public:
  explicit Registration(Cancellation& cancellation) : cancellation_(cancellation) {
    const std::scoped_lock lock(cancellation_.mutex_);
    if (cancellation_.requested_) throw Interrupted();
    cancellation_.running_.push_back(this);
  }
  Registration(const Registration&) = delete;
  Registration& operator=(const Registration&) = delete;
  Registration(Registration&&) = delete;
  Registration& operator=(Registration&&) = delete;
  ~Registration() {
    const std::scoped_lock lock(cancellation_.mutex_);
    std::erase(cancellation_.running_, this);
  }

  // Contexts of loops within the work are bound to this one, which passes its cancellation on to them.
  tbb::task_group_context context{tbb::task_group_context::isolated};

 private:
  Cancellation& cancellation_;
};

void Cancellation::run(const std::function<void()>& work) {
  Registration registration(*this);
  tbb::parallel_for(
      0, 1, [&](int) { work(); }, registration.context);
  if (requested_) throw Interrupted();
}

void Cancellation::cancel() {
  const std::scoped_lock lock(mutex_);
  requested_ = true;
  for (Registration* const work : running_) work->context.cancel_group_execution();
}

}  // namespace shapegauge
