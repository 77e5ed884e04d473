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

/// Reads binary numbers one after the other from bytes in memory.
class ByteScanner {
 public:
  /// The bytes must outlive the scanner.
  ByteScanner(std::string_view bytes, std::endian order) : bytes_(bytes), swap_(order != std::endian::native) {}

  [[nodiscard]] std::size_t remaining() const { return bytes_.size(); }

  /// Reads a number; false, without moving, where the bytes end before.
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

  /// Moves past so many bytes; false, without moving, where there are fewer.
  bool skip(std::uint64_t count) {
    if (bytes_.size() < count) return false;
    bytes_.remove_prefix(count);
    return true;
  }

 private:
  std::string_view bytes_;
  bool swap_;
};

/// Reads words and numbers one after the other from a text in memory. Words are separated by white space; `#` begins a
/// comment that ends with its line; lines end with LF, CR LF or CR. A
/// byte order mark in front is passed over. Anything that cannot be read is an InputError with
/// the file's name and the line, which is counted only then.
class TextScanner {
 public:
  /// Both must outlive the scanner. `name` stands in front of error messages.
  TextScanner(const std::string& text, const std::string& name)
      : begin_(text.data()), end_(text.data() + text.size()), position_(begin_), word_(begin_), name_(&name) {
    if (text.starts_with("\xEF\xBB\xBF")) position_ += 3;
  }

  /// Moves past white space, line ends and comments. True where nothing follows.
  bool at_end() {
    while (true) {
      while (is_space(*position_)) ++position_;
      if (*position_ != '#') return position_ == end_;
      skip_line();
    }
  }

  /// Moves past white space within the line. True where the rest of the line holds nothing but a comment.
  bool at_line_end() {
    while (is_space(*position_) && !is_line_end(*position_)) ++position_;
    return position_ == end_ || *position_ == '#' || is_line_end(*position_);
  }

  /// Moves to the end of the line.
  void skip_line() {
    while (position_ != end_ && !is_line_end(*position_)) ++position_;
  }

  /// Reads a finite number; false at the end of the text. `role` names it in an error: "a coordinate".
  bool read_number(double& value, std::string_view role);

  /// Reads a whole number; false at the end of the text.
  bool read_integer(std::int64_t& value, std::string_view role);

  /// The next word; empty at the end of the text.
  std::string_view read_word();

  /// Moves past so many words; false where the text ends before.
  bool skip_words(std::size_t count);

  /// What has not been read yet.
  [[nodiscard]] std::string_view rest() const { return {position_, remaining()}; }
  [[nodiscard]] std::size_t remaining() const { return static_cast<std::size_t>(end_ - position_); }

  /// Moves on by so many characters of rest(); an error then points to the first of them.
  void advance(std::size_t count) {
    word_ = position_;
    position_ += count;
  }

  /// Where the last word or number began: for fail_at().
  [[nodiscard]] std::size_t word_offset() const { return static_cast<std::size_t>(word_ - begin_); }

  /// Throws InputError "<name>:<line>: <message>" for the line of the last word or number.
  [[noreturn]] void fail(std::string_view message) const { fail_at(word_offset(), message); }
  [[noreturn]] void fail_at(std::size_t offset, std::string_view message) const;

  /// Throws InputError "<name>: <message>": what is wrong with the text as a whole.
  [[noreturn]] void fail_whole(std::string_view message) const;

 private:
  // The text ends with '\0', which is neither white space nor part of a number: no bounds need checking.
  static bool is_space(char c) { return static_cast<unsigned char>(c - 1) < 32; }
  static bool is_line_end(char c) { return c == '\n' || c == '\r'; }
  // "1.#QNAN", as some compilers print it, is no number with a comment behind it.
  [[nodiscard]] bool ends_number(const char* p) const {
    return is_space(*p) || p == end_ || (*p == '#' && p[-1] != '.');
  }
  [[nodiscard]] std::string_view current_word() const;

  const char* begin_;
  const char* end_;
  const char* position_;
  const char* word_;
  const std::string* name_;
};

}  // namespace shapegauge
