#include "app/progress_line.h"

#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace shapegauge {

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::clear() {
  if (terminal_ && !stage_.empty()) fmt::print(stderr, "\r\x1b[K");
}

void ProgressLine::show(std::string_view stage, std::size_t done, std::size_t total) {
  if (!terminal_) return;
  const auto now = std::chrono::steady_clock::now();
  const bool new_stage = stage != stage_;
  if (new_stage) {
    stage_ = stage;
    stage_start_ = now;
  }
  if (!new_stage && done != total && now - last_drawn_ < std::chrono::milliseconds(200)) return;
  last_drawn_ = now;
  const double seconds = std::chrono::duration<double>(now - stage_start_).count();
  fmt::print(stderr, "\r\x1b[K{}", progress_text(stage, done, total, seconds));
  std::fflush(stderr);
}

std::string progress_text(std::string_view stage, std::size_t done, std::size_t total, double seconds) {
  std::string text = fmt::format("{} {}/{}", stage, done, total);
  if (done == 0 || !(seconds > 0)) return text;
  const double rate = static_cast<double>(done) / seconds;
  const auto left = std::lround(static_cast<double>(total - done) / rate);
  return text + fmt::format("  {:.3g}/s  {}:{:02} left", rate, left / 60, left % 60);
}

}  // namespace shapegauge
