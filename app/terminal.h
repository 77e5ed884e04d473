#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <fmt/format.h>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

/// Output, messages and progress. Nothing here throws where a stream cannot be written to (full or closed), so that no
/// results are lost for want of a reader.

namespace shapegauge {

enum class Verbosity {
  quiet,   ///< -q: warnings and errors only
  normal,  ///< notes and progress, too
  verbose  ///< -v: what is done and how long it takes, too
};

/// Writes the text to standard output; failures are remembered for output_error().
void write_output(std::string_view text);

/// Flushes standard output. Returns the error (errno) that kept output of the program from being written, or 0.
int output_error();

/// Applies to everything below from now on; normal before.
void set_verbosity(Verbosity verbosity);
Verbosity verbosity();

/// Writes formatted text to standard output; failures are remembered for output_error().
template <typename... Values>
void print_output(fmt::format_string<Values...> format, Values&&... values) {
  write_output(fmt::format(format, std::forward<Values>(values)...));
}

/// Prints "shapegauge: error: <text>", on one line whatever the text.
void print_error(std::string text);

/// Prints "shapegauge: <text>" unless quiet.
void note(std::string_view text);

/// Prints "shapegauge: warning: <text>".
void warn(std::string_view text);

/// A line on a terminal that says how far a long job is: count, rate, time left. Nothing where standard error is not a
/// terminal or the program is quiet. Not to be used from several threads at once.
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
  bool shown_;
  std::string stage_;
  std::chrono::steady_clock::time_point stage_start_;
  std::chrono::steady_clock::time_point last_drawn_;
};

/// The text of the line: "signatures 120/600  3.4/s  2:21 left"; rate and time left once something is done.
std::string progress_text(std::string_view stage, std::size_t done, std::size_t total, double seconds);

/// A line on a terminal for a job without parts to count, while the object lives: what is done and for how long, from
/// two seconds on. Wiped at the end.
class BusyLine {
 public:
  explicit BusyLine(std::string what);
  ~BusyLine();
  BusyLine(const BusyLine&) = delete;
  BusyLine& operator=(const BusyLine&) = delete;
  BusyLine(BusyLine&&) = delete;
  BusyLine& operator=(BusyLine&&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable ended_;
  bool end_ = false;
  std::thread thread_;  ///< draws; none where nothing is shown
};

}  // namespace shapegauge
