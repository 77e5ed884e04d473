// SPDX-License-Identifier: GPL-3.0-or-later
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

/// Output, messages and progress. Functions never throw if a stream cannot be written (full or closed): results must
/// not be lost because standard error is closed.

namespace shapegauge {

/// Level of detail of the messages on standard error.
enum class Verbosity {
  quiet,   ///< warnings and errors only (-q)
  normal,  ///< warnings, errors, notes and progress
  verbose  ///< all messages, and the run times of the steps (-v)
};

/// Sanitises text of several lines for a terminal like printable(), but keeps ends of lines, tabs and the escape
/// sequences of bold cells (to_plain_text()).
std::string printable_lines(std::string_view text);

/// Returns true if standard output is a terminal that shows bold text and colours: not "dumb", and without $NO_COLOR.
bool output_has_colours();

/// Writes the text to standard output, on a terminal sanitised by printable_lines(); output_error() reports failures.
void write_output(std::string_view text);

/// Flushes standard output. Returns the error (errno) of the first failed write, or 0.
int output_error();

/// Returns the line width for standard output in characters: $COLUMNS or the width of the terminal, clamped to 60 to
/// 100; 100 if unknown.
std::size_t terminal_width();

/// Sets which messages are printed; Verbosity::normal by default.
void set_verbosity(Verbosity verbosity);
Verbosity verbosity();  ///< returns which messages are printed

/// Writes formatted text to standard output; output_error() reports failures.
template <typename... Values>
void print_output(fmt::format_string<Values...> format, Values&&... values) {
  write_output(fmt::format(format, std::forward<Values>(values)...));
}

/// Returns the command-line option for a setting of a configuration, such as "--on-error" for "on_error".
std::string option_name(std::string_view setting);

/// Replaces settings in backquotes in a message, such as `replace=true`, by options, such as --replace.
std::string with_options(std::string_view message);

/// Prints "shapegauge: error: <text>" on standard error, always as one line, with settings spelled by with_options().
void print_error(std::string text);

/// Prints "shapegauge: <text>" on standard error unless the verbosity is quiet.
void note(std::string_view text);

/// Prints "shapegauge: warning: <text>" on standard error.
void warn(std::string_view text);

/// Progress line on a terminal: count, rate, remaining time. Silent if standard error is not a terminal or the program
/// is quiet. Not thread-safe.
class ProgressLine {
 public:
  ProgressLine();
  /// Clears the line.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows that `done` of `total` items of a stage of the work, such as "signatures", are complete; redraws a few times
  /// a second.
  void show(std::string_view stage, std::size_t done, std::size_t total);

  /// Returns a progress callback that calls show() of this line, which must outlive the callback.
  [[nodiscard]] auto receiver() {
    return [this](std::string_view stage, std::size_t done, std::size_t total) { show(stage, done, total); };
  }
  /// Clears the line before a message is printed.
  void clear();

 private:
  bool shown_;                                         ///< true if standard error shows progress
  std::string stage_;                                  ///< name of the current stage; empty before the first
  std::chrono::steady_clock::time_point stage_start_;  ///< time when the current stage began
  std::chrono::steady_clock::time_point last_drawn_;   ///< time when the line was last drawn
};

/// Formats a progress line for `done` of `total` items: "signatures 120/600  3.4/s  2:21 left". `seconds` is the time
/// since the stage began. Rate and remaining time appear once an item is done.
std::string progress_text(std::string_view stage, std::size_t done, std::size_t total, double seconds);

/// Activity line on a terminal for a job without countable parts: its name and elapsed time, from two seconds on.
/// Cleared on destruction.
class BusyLine {
 public:
  explicit BusyLine(std::string what);  ///< starts the line of the job named `what`
  ~BusyLine();
  BusyLine(const BusyLine&) = delete;
  BusyLine& operator=(const BusyLine&) = delete;
  BusyLine(BusyLine&&) = delete;
  BusyLine& operator=(BusyLine&&) = delete;

 private:
  std::mutex mutex_;               ///< guards end_
  std::condition_variable ended_;  ///< signalled when end_ becomes true
  bool end_ = false;               ///< true when the line is to be cleared
  std::thread thread_;             ///< draws the line; not started if standard error is not a terminal
};

}  // namespace shapegauge
