#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// Serialisation of numbers and texts for another process of the same program on the same kind of machine.

namespace shapegauge {

/// Types that are copied byte by byte.
template <typename Value>
concept Plain = std::is_trivially_copyable_v<Value> && !std::is_array_v<Value> && !std::is_pointer_v<Value>;

/// Serialises values.
class Packer {
 public:
  template <Plain Number>
  Packer& add(const Number& number) {
    return add_bytes(&number, sizeof(number));
  }
  Packer& add(std::string_view text) { return add(text.size()).add_bytes(text.data(), text.size()); }
  template <Plain Number>
  Packer& add(const std::vector<Number>& numbers) {
    return add(numbers.size()).add_bytes(numbers.data(), numbers.size() * sizeof(Number));
  }
  template <typename Number, int rows, int columns, int options>
  Packer& add(const Eigen::Matrix<Number, rows, columns, options>& matrix) {
    add(matrix.rows()).add(matrix.cols());
    return add_bytes(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(Number));
  }
  /// Appends bytes without their count.
  Packer& add_bytes(const void* begin, std::size_t count) {
    if (count > 0) bytes_.append(static_cast<const char*>(begin), count);
    return *this;
  }

  std::string bytes() && { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Deserialises values in the same order.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : rest_(bytes) {}

  template <Plain Number>
  Unpacker& take(Number& number) {
    return take_bytes(&number, sizeof(number));
  }
  Unpacker& take(std::string& text) {
    text.resize(take_value<std::size_t>());
    return take_bytes(text.data(), text.size());
  }
  template <Plain Number>
  Unpacker& take(std::vector<Number>& numbers) {
    numbers.resize(take_value<std::size_t>());
    return take_bytes(numbers.data(), numbers.size() * sizeof(Number));
  }
  template <typename Number, int rows, int columns, int options>
  Unpacker& take(Eigen::Matrix<Number, rows, columns, options>& matrix) {
    const auto row_count = take_value<Eigen::Index>();
    matrix.resize(row_count, take_value<Eigen::Index>());
    return take_bytes(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(Number));
  }
  template <typename Value>
  Value take_value() {
    Value value{};
    take(value);
    return value;
  }
  Unpacker& take_bytes(void* to, std::size_t count) {
    if (count > 0) std::memcpy(to, rest_.substr(0, count).data(), count);
    rest_.remove_prefix(count);
    return *this;
  }
  [[nodiscard]] bool is_at_end() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

}  // namespace shapegauge
