// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <optional>
#include <sys/ioctl.h>
#include <unistd.h>

#include "shapegauge/core/base/environment.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/setting_names.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/datasets/files/table.h"

namespace shapegauge {

namespace {

Verbosity current_verbosity = Verbosity::normal;

bool shows_progress() { return current_verbosity != Verbosity::quiet && isatty(STDERR_FILENO) == 1; }

constexpr const char* wipe = "\r\x1b[K";

int first_output_error = 0;

/// Writes to standard error; failures cannot be reported anywhere.
void write_message(std::string_view text) {
  [[maybe_unused]] const std::size_t written = std::fwrite(text.data(), 1, text.size(), stderr);
}

bool has_colours(int stream) {
  return isatty(stream) == 1 && environment_variable("NO_COLOR").value_or("").empty() &&
         environment_variable("TERM") != "dumb";
}

/// Makes the beginning of a message, with the word in colour (a code of SGR) if possible.
std::string message_start(std::string_view word, int colour) {
  const bool plain = !has_colours(STDERR_FILENO);
  return plain ? fmt::format("shapegauge: {}: ", word)
               : fmt::format("shapegauge: \x1b[1;{}m{}:{} ", colour, word, terminal_plain);
}

std::string for_terminal(std::string_view text) { return with_options(printable(text)); }

}  // namespace

std::string printable_lines(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\n\t\x1b", 1), text.size());
    std::string_view piece = text.substr(0, end);
    for (const std::string_view allowed :
         {std::string_view("\n"), std::string_view("\t"), terminal_bold, terminal_plain}) {
      if (!piece.starts_with(allowed)) continue;
      shown += allowed;
      piece.remove_prefix(allowed.size());
      break;
    }
    shown += printable(piece);
    text.remove_prefix(end);
  }
  return shown;
}

bool output_has_colours() { return has_colours(STDOUT_FILENO); }

void write_output(std::string_view text) {
  static const bool on_terminal = isatty(STDOUT_FILENO) == 1;
  const std::string shown = on_terminal ? printable_lines(text) : "";
  if (on_terminal) text = shown;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written && first_output_error == 0) first_output_error = errno;
}

int output_error() {
  const bool flushed = std::fflush(stdout) == 0;
  if (!flushed && first_output_error == 0) first_output_error = errno;
  return first_output_error;
}

std::size_t terminal_width() {
  constexpr double widest = 100;
  winsize window{};
  const bool is_known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 0;
  const std::optional<double> columns = parse_number(environment_variable("COLUMNS").value_or(""));
  return static_cast<std::size_t>(std::clamp(columns.value_or(is_known ? window.ws_col : widest), 60.0, widest));
}

void set_verbosity(Verbosity verbosity) { current_verbosity = verbosity; }

Verbosity verbosity() { return current_verbosity; }

std::string option_name(std::string_view setting) {
  std::string option = fmt::format("--{}", setting);
  std::ranges::replace(option, '_', '-');
  return option;
}

std::string with_options(std::string_view message) {
  return spell_settings(message, [](std::string_view name, std::string_view value) {
    if (value == "false") return option_name(fmt::format("no_{}", name));
    const bool is_switch = value.empty() || value == "true";
    return option_name(name) + (is_switch ? "" : fmt::format(" {}", value));
  });
}

void note(std::string_view text) {
  if (current_verbosity != Verbosity::quiet) write_message(fmt::format("shapegauge: {}\n", for_terminal(text)));
}

void warn(std::string_view text) {
  constexpr int yellow = 33;
  write_message(fmt::format("{}{}\n", message_start("warning", yellow), for_terminal(text)));
}

void print_error(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  text.erase(text.find_last_not_of(' ') + 1);
  constexpr int red = 31;
  write_message(fmt::format("{}{}\n", message_start("error", red), for_terminal(text)));
}

ProgressLine::ProgressLine() : shown_(shows_progress()) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::clear() {
  if (shown_ && !stage_.empty()) write_message(wipe);
}

void ProgressLine::show(std::string_view stage, std::size_t done, std::size_t total) {
  if (!shown_) return;
  const auto now = std::chrono::steady_clock::now();
  const bool new_stage = stage != stage_;
  if (new_stage) {
    stage_ = stage;
    stage_start_ = now;
  }
  if (!new_stage && done != total && now - last_drawn_ < std::chrono::milliseconds(200)) return;
  last_drawn_ = now;
  const double seconds = std::chrono::duration<double>(now - stage_start_).count();
  write_message(wipe + printable(progress_text(stage, done, total, seconds)));
}

std::string progress_text(std::string_view stage, std::size_t done, std::size_t total, double seconds) {
  std::string text = fmt::format("{} {}/{}", stage, done, total);
  if (done == 0 || !(seconds > 0)) return text;
  const double rate = static_cast<double>(done) / seconds;
  const auto left = std::lround(static_cast<double>(total - done) / rate);
  return text + fmt::format("  {:.3g}/s  {}:{:02} left", rate, left / 60, left % 60);
}

BusyLine::BusyLine(std::string what) {
  if (!shows_progress()) return;
  thread_ = std::thread([this, what = std::move(what)] {
    const auto ended = [this] { return end_; };
    std::unique_lock lock(mutex_);
    if (ended_.wait_for(lock, std::chrono::seconds(2), ended)) return;
    for (int seconds = 2; !end_; ++seconds) {
      write_message(fmt::format("{}{}  {}:{:02}", wipe, printable(what), seconds / 60, seconds % 60));
      ended_.wait_for(lock, std::chrono::seconds(1), ended);
    }
    write_message(wipe);
  });
}

BusyLine::~BusyLine() {
  if (!thread_.joinable()) return;
  {
    const std::scoped_lock lock(mutex_);
    end_ = true;
  }
  ended_.notify_one();
  thread_.join();
}

}  // namespace shapegauge
