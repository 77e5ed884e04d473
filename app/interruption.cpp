// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <csignal>

#include "app/commands.h"

namespace shapegauge {

namespace {

// A signal handler may touch lock-free atomics only, and has no other way to say something.
std::atomic<int> received_signal = 0;
static_assert(std::atomic<int>::is_always_lock_free);

void remember(int signal) {
  received_signal = signal;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_interruption() {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, remember);
  if (std::signal(SIGHUP, remember) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // nohup
}

bool interrupted() { return received_signal != 0; }

int interruption_status() { return 128 + received_signal; }

}  // namespace shapegauge
