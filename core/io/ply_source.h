#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include "shapegauge/core/io/byte_scanner.h"
#include "shapegauge/core/io/ply_header.h"
#include "shapegauge/core/io/text_scanner.h"

namespace shapegauge {

/// The values of an ASCII PLY file's body, one after the other. Every reading function returns false at the end.
class PlyTextSource {
 public:
  explicit PlyTextSource(const TextScanner& body) : body_(body) {}

  bool read_real(double& value, PlyType /*type*/) { return body_.read_number(value, "a coordinate"); }
  bool read_whole(std::int64_t& value, PlyType /*type*/) { return body_.read_integer(value, "an index or a length"); }
  bool skip(PlyType /*type*/, std::uint64_t count) { return body_.skip_words(count); }
  [[nodiscard]] std::size_t remaining() const { return body_.remaining(); }
  /// Throws InputError about the value read last.
  [[noreturn]] void fail(std::string_view message) const { body_.fail(message); }

 private:
  TextScanner body_;
};

/// The same for a binary body.
class PlyBinarySource {
 public:
  PlyBinarySource(const TextScanner& body, std::endian order) : text_(body), bytes_(body.rest(), order) {}

  bool read_real(double& value, PlyType type) { return read_as(value, type); }
  bool read_whole(std::int64_t& value, PlyType type) { return read_as(value, type); }
  bool skip(PlyType type, std::uint64_t count) {
    return with_type(type, [&](auto example) { return bytes_.skip(sizeof(example) * count); });
  }
  [[nodiscard]] std::size_t remaining() const { return bytes_.remaining(); }
  [[noreturn]] void fail(std::string_view message) const { text_.fail_whole(message); }

 private:
  /// Calls the function with a number of the type.
  template <typename Function>
  static bool with_type(PlyType type, Function function) {
    switch (type) {
      case PlyType::int8:
        return function(std::int8_t{});
      case PlyType::uint8:
        return function(std::uint8_t{});
      case PlyType::int16:
        return function(std::int16_t{});
      case PlyType::uint16:
        return function(std::uint16_t{});
      case PlyType::int32:
        return function(std::int32_t{});
      case PlyType::uint32:
        return function(std::uint32_t{});
      case PlyType::float32:
        return function(float{});
      case PlyType::float64:
        return function(double{});
    }
    return false;
  }

  template <typename Value>
  bool read_as(Value& value, PlyType type) {
    return with_type(type, [&](auto number) {
      if (!bytes_.read(number)) return false;
      value = static_cast<Value>(+number);
      return true;
    });
  }

  TextScanner text_;
  ByteScanner bytes_;
};

}  // namespace shapegauge
