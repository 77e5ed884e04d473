#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
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

}  // namespace shapegauge
