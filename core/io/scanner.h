// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace shapegauge {

/// Reads binary numbers sequentially from memory.
class ByteScanner {
 public:
  /// Starts at the first byte. `order` is the byte order of the numbers. The bytes must outlive the scanner.
  ByteScanner(std::string_view bytes, std::endian order) : bytes_(bytes), swap_(order != std::endian::native) {}

  /// Returns the number of unread bytes.
  [[nodiscard]] std::size_t remaining() const { return bytes_.size(); }

  /// Reads a number. Returns false, without moving, if too few bytes remain.
  template <typename Number>
  bool read(Number& value) {
    if (bytes_.size() < sizeof(Number)) return false;
    std::array<char, sizeof(Number)> raw;
    std::memcpy(raw.data(), bytes_.data(), raw.size());
    if (swap_) std::reverse(raw.begin(), raw.end());
    value = std::bit_cast<Number>(raw);
    bytes_.remove_prefix(sizeof(Number));
    return true;
  }

  /// Skips `count` bytes. Returns false, without moving, if too few remain.
  bool skip(std::uint64_t count) {
    if (bytes_.size() < count) return false;
    bytes_.remove_prefix(count);
    return true;
  }

 private:
  std::string_view bytes_;  ///< unread bytes
  bool swap_;               ///< true if the byte order is not that of this machine
};

/// Reads words and numbers sequentially from a text in memory. Words are separated by white space; `#` begins a comment
/// up to the end of the line; lines end with LF, CR LF or CR. A leading byte order mark is skipped. Errors are
/// InputErrors with the file's name and the line; lines are counted only for errors.
class TextScanner {
 public:
  /// Starts at the beginning of `text`. Both arguments must outlive the scanner. `name` prefixes error messages.
  TextScanner(const std::string& text, const std::string& name)
      : begin_(text.data()), end_(text.data() + text.size()), position_(begin_), word_(begin_), name_(&name) {
    if (text.starts_with("\xEF\xBB\xBF")) position_ += 3;
  }

  /// Skips white space, line ends and comments. Returns true at the end of the text.
  bool at_end() {
    while (true) {
      while (is_space(*position_)) ++position_;
      if (*position_ != '#') return position_ == end_;
      skip_line();
    }
  }

  /// Skips white space within the line. Returns true if nothing but a comment is left on the line.
  bool at_line_end() {
    while (is_space(*position_) && !is_line_end(*position_)) ++position_;
    return position_ == end_ || *position_ == '#' || is_line_end(*position_);
  }

  /// Skips to the end of the current line.
  void skip_line() {
    while (position_ != end_ && !is_line_end(*position_)) ++position_;
  }

  /// Reads a finite number. Returns false at the end of the text; throws InputError for any other word. `role` names
  /// the number in errors: "a coordinate".
  bool read_number(double& value, std::string_view role);

  /// Reads an integer. Returns false at the end of the text; throws InputError for any other word. `role` names the
  /// integer in errors: "an index".
  bool read_integer(std::int64_t& value, std::string_view role);

  /// Returns the next word; empty at the end of the text.
  std::string_view read_word();

  /// Skips `count` words. Returns false if fewer are left.
  bool skip_words(std::size_t count);

  /// Returns the unread text.
  [[nodiscard]] std::string_view rest() const { return {position_, remaining()}; }
  [[nodiscard]] std::size_t remaining() const { return static_cast<std::size_t>(end_ - position_); }

  /// Skips `count` bytes of rest(). A subsequent fail() names the line of the first skipped byte.
  void advance(std::size_t count) {
    word_ = position_;
    position_ += count;
  }

  /// Returns the offset, in bytes from the beginning of the text, of the last word or number read, for fail_at().
  [[nodiscard]] std::size_t word_offset() const { return static_cast<std::size_t>(word_ - begin_); }

  /// Throws InputError "<name>:<line>: <message>" for the line of the last word or number.
  [[noreturn]] void fail(std::string_view message) const { fail_at(word_offset(), message); }
  /// Throws InputError "<name>:<line>: <message>" for the line at an offset in bytes (word_offset()).
  [[noreturn]] void fail_at(std::size_t offset, std::string_view message) const;

  /// Throws InputError "<name>: <message>" without a line, for faults of the text as a whole.
  [[noreturn]] void fail_whole(std::string_view message) const;

 private:
  // The text ends with '\0', which is neither white space nor part of a number: no bounds need checking.
  static bool is_space(char c) { return static_cast<unsigned char>(c - 1) < 32; }
  static bool is_line_end(char c) { return c == '\n' || c == '\r'; }
  // "1.#QNAN", as printed by some compilers, is one word and not a number followed by a comment.
  [[nodiscard]] bool ends_number(const char* p) const {
    return is_space(*p) || p == end_ || (*p == '#' && p[-1] != '.');
  }
  [[nodiscard]] std::string_view current_word() const;

  const char* begin_;
  const char* end_;
  const char* position_;  ///< first unread byte
  const char* word_;      ///< beginning of the last word or number read
  const std::string* name_;
};

}  // namespace shapegauge
