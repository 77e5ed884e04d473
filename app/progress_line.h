#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace shapegauge {

/// A line on standard error that says how far a long job is: count, rate, time left. Silent where standard error is not
/// a terminal. Not to be used from several threads at once.
class ProgressLine {
 public:
  ProgressLine();
  /// Wipes the line.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// So much of this stage is done; redraws a few times a second.
  void show(std::string_view stage, std::size_t done, std::size_t total);

  /// Wipes the line, so that a message can be printed.
  void clear();

 private:
  bool terminal_;
  std::string stage_;
  std::chrono::steady_clock::time_point stage_start_;
  std::chrono::steady_clock::time_point last_drawn_;
};

/// The text of the line: "signatures 120/600  3.4/s  2:21 left"; rate and time left once something is done.
std::string progress_text(std::string_view stage, std::size_t done, std::size_t total, double seconds);

}  // namespace shapegauge
