// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/base/interruption.h"

#include <tbb/task_group.h>

namespace shapegauge {

bool interruption_requested() { return tbb::is_current_task_group_canceling(); }

void check_interruption() {
  if (interruption_requested()) throw Interrupted();
}

}  // namespace shapegauge
