// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"

/// Binary encoding of values: numbers, texts, containers, Eigen's matrices, and structures with members()
/// (core/base/members.h). The same program restores them bit by bit on the same kind of machine.

namespace shapegauge {

/// Error of bytes that do not encode the requested value.
class DamagedBytes : public InputError {
 public:
  DamagedBytes() : InputError("the bytes of a value are damaged") {}
};

namespace codec {

/// Types that are copied byte by byte.
template <typename Value>
concept Plain = std::is_arithmetic_v<Value> || std::is_enum_v<Value>;

/// True for types of dense Eigen matrices and vectors.
template <typename Value>
inline constexpr bool is_matrix = false;
template <typename Number, int rows, int columns, int options>
inline constexpr bool is_matrix<Eigen::Matrix<Number, rows, columns, options>> = true;

/// Types of dense Eigen matrices and vectors.
template <typename Value>
concept Matrix = is_matrix<Value>;

/// Types with a function members(), which returns references to all members (core/base/members.h).
template <typename Value>
concept Structure = requires(Value& value) {
  members(value);
};

/// Serialises values to a string of bytes. Each add() appends one value; containers are preceded by their size.
class Encoder {
 public:
  /// Appends `count` bytes from the address `begin`.
  void add_bytes(const void* begin, std::size_t count) {
    if (count > 0) bytes_.append(static_cast<const char*>(begin), count);
  }
  template <Plain Number>
  void add(const Number& number) {
    add_bytes(&number, sizeof(number));
  }
  void add(const std::string& text) {
    add(text.size());
    add_bytes(text.data(), text.size());
  }
  template <typename Value>
  void add(const std::vector<Value>& values) {
    add(values.size());
    if constexpr (Plain<Value>) {
      add_bytes(values.data(), values.size() * sizeof(Value));
    } else {
      for (const Value& value : values) add(value);
    }
  }
  template <typename Value>
  void add(const std::optional<Value>& value) {
    add(value.has_value());
    if (value) add(*value);
  }
  template <typename Key, typename Value>
  void add(const std::map<Key, Value>& values) {
    add(values.size());
    for (const auto& [key, value] : values) {
      add(key);
      add(value);
    }
  }
  template <Matrix Value>
  void add(const Value& matrix) {
    add(matrix.rows());
    add(matrix.cols());
    add_bytes(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(typename Value::Scalar));
  }
  template <Structure Value>
  void add(const Value& value) {
    // members() serves both directions; nothing is changed here.
    std::apply([&](const auto&... member) { (add(member), ...); }, members(const_cast<Value&>(value)));
  }
  /// Moves the encoded bytes out of the encoder.
  std::string bytes() && { return std::move(bytes_); }

 private:
  std::string bytes_;  ///< bytes of the values added so far
};

/// Reads values from bytes in the order in which an Encoder added them. Each take() reads one value into its argument
/// and throws DamagedBytes if too few bytes are left.
class Decoder {
 public:
  /// Reads from `bytes`, which must outlive the decoder.
  explicit Decoder(std::string_view bytes) : rest_(bytes) {}

  /// Copies the next `count` bytes to the address `to`.
  void take_bytes(void* to, std::size_t count) {
    if (count > rest_.size()) throw DamagedBytes();
    if (count > 0) std::memcpy(to, rest_.data(), count);
    rest_.remove_prefix(count);
  }
  template <Plain Number>
  void take(Number& number) {
    take_bytes(&number, sizeof(number));
  }
  void take(std::string& text) {
    text.resize(take_count(1));
    take_bytes(text.data(), text.size());
  }
  template <typename Value>
  void take(std::vector<Value>& values) {
    if constexpr (Plain<Value>) {
      values.resize(take_count(sizeof(Value)));
      take_bytes(values.data(), values.size() * sizeof(Value));
    } else {
      values.resize(take_count(1));
      for (Value& value : values) take(value);
    }
  }
  template <typename Value>
  void take(std::optional<Value>& value) {
    value.reset();
    if (take_number<char>() != 0) take(value.emplace());
  }
  template <typename Key, typename Value>
  void take(std::map<Key, Value>& values) {
    values.clear();
    for (std::size_t rest = take_count(1); rest > 0; --rest) {
      Key key;
      take(key);
      take(values[std::move(key)]);
    }
  }
  template <Matrix Value>
  void take(Value& matrix) {
    const auto rows = take_number<Eigen::Index>();
    const auto columns = take_number<Eigen::Index>();
    const auto available = static_cast<Eigen::Index>(rest_.size() / sizeof(typename Value::Scalar));
    if (rows < 0 || columns < 0 || (rows > 0 && columns > available / rows)) throw DamagedBytes();
    matrix.resize(rows, columns);
    take_bytes(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(typename Value::Scalar));
  }
  template <Structure Value>
  void take(Value& value) {
    std::apply([&](auto&... member) { (take(member), ...); }, members(value));
  }
  /// Returns true if all bytes have been read.
  [[nodiscard]] bool is_at_end() const { return rest_.empty(); }

 private:
  /// Reads and returns one number.
  template <Plain Number>
  Number take_number() {
    Number number{};
    take(number);
    return number;
  }
  /// Reads the number of elements of the container that follows. Throws DamagedBytes if the unread bytes are too few
  /// for that many elements of at least `bytes` bytes each.
  std::size_t take_count(std::size_t bytes) {
    const auto count = take_number<std::size_t>();
    if (count > rest_.size() / bytes) throw DamagedBytes();
    return count;
  }

  std::string_view rest_;  ///< bytes not yet read
};

}  // namespace codec

/// Encodes a value as bytes, which decode() restores.
template <typename Value>
std::string encode(const Value& value) {
  codec::Encoder encoder;
  encoder.add(value);
  return std::move(encoder).bytes();
}

/// Decodes a value from the bytes of encode(). Throws DamagedBytes if they do not encode a value of that type.
template <typename Value>
Value decode(std::string_view bytes) {
  Value value{};
  codec::Decoder decoder(bytes);
  decoder.take(value);
  if (!decoder.is_at_end()) throw DamagedBytes();
  return value;
}

}  // namespace shapegauge
