#include "shapegauge/experiments/command_line/interruption.h"

#include <atomic>
#include <csignal>

namespace shapegauge {

namespace {

// A signal handler may touch lock-free atomics only, and has no other way to say something.
std::atomic<bool> was_interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

void remember(int signal) {
  was_interrupted = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_interruption() { std::signal(SIGINT, remember); }

bool interrupted() { return was_interrupted; }

}  // namespace shapegauge
