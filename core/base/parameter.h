#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

/// An interval of legal values. An open end does not belong to it; an infinite end is no limit, but infinity itself is
/// never legal, nor is NaN.
struct Bounds {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;
  bool high_open = false;

  [[nodiscard]] bool contains(double value) const;
};

/// The interval in words, to follow "it must be": "from 0 to 1", "above 0 and at most 1", "at least 1".
std::string to_string(const Bounds& bounds);

/// Throws InputError "<what> is <value>; it must be <bounds>" unless the bounds contain the value.
void require_in_bounds(std::string_view what, double value, const Bounds& bounds);

/// A list of at most 16 whole numbers. As an option, the empty list means "auto".
class IntegerList {
 public:
  static constexpr std::size_t most = 16;

  constexpr IntegerList() = default;
  constexpr IntegerList(int value) : IntegerList{std::int64_t{value}} {}  // NOLINT: one number is a list of one
  constexpr IntegerList(std::initializer_list<std::int64_t> values) : IntegerList(std::span(values)) {}

  /// Throws ArgumentError for more than 16.
  constexpr explicit IntegerList(std::span<const std::int64_t> values) : size_(values.size()) {
    if (size_ > most) throw ArgumentError("a list of more than 16 whole numbers");
    std::copy(values.begin(), values.end(), values_.begin());
  }

  [[nodiscard]] constexpr std::span<const std::int64_t> values() const { return {values_.data(), size_}; }
  [[nodiscard]] constexpr bool empty() const { return size_ == 0; }

  friend constexpr bool operator==(const IntegerList&, const IntegerList&) = default;

 private:
  std::array<std::int64_t, most> values_{};
  std::size_t size_ = 0;
};

enum class ParameterKind {
  number,    ///< a finite double within the bounds, or one of the choices where there are any ("auto")
  integer,   ///< a whole number within the bounds
  integers,  ///< whole numbers within the bounds: one, or a list of up to 16; or one of the choices
  boolean,
  choice  ///< one of the choices
};

/// A value of a parameter, or none. A word is one of the parameter's own choices, and lives as long as they do.
using ParameterValue = std::variant<std::monostate, bool, std::int64_t, double, std::string_view, IntegerList>;

/// What there is to know of a setting of an algorithm. Entries of registries list their parameters; configurations, the
/// JSON schema, the command line and the documentation are made from such lists, and the algorithm checks its options
/// against the same bounds.
struct Parameter {
  std::string_view name;
  ParameterKind kind = ParameterKind::number;
  ParameterValue default_value = {};               ///< of the parameter's kind; none: must be given
  Bounds bounds = {};                              ///< of numbers and integers
  std::span<const std::string_view> choices = {};  ///< legal words
  std::string_view description;                    ///< one sentence

  [[nodiscard]] bool required() const { return std::holds_alternative<std::monostate>(default_value); }
};

/// The value as the parameter holds it: a whole number becomes a double where the parameter is a number and a list of
/// one where it takes lists; a word becomes the equal choice, and an empty list the choice "auto". Throws InputError,
/// with the parameter's name, for a value of another kind, out of bounds, or not among the choices.
ParameterValue checked_value(const Parameter& parameter, const ParameterValue& value);

/// The value that a text spells: a number, whole numbers between commas, true or false, or one of the choices. Throws
/// InputError as checked_value().
ParameterValue parse_value(const Parameter& parameter, std::string_view text);

/// The value as parse_value() reads it; empty for none.
std::string to_string(const ParameterValue& value);

/// What the parameter takes, in words: "a number from 0 to 1, or auto".
std::string legal_values(const Parameter& parameter);

/// A value for each parameter of a list. Refers to the list, which must outlive it.
class ParameterValues {
 public:
  /// All defaults.
  explicit ParameterValues(std::span<const Parameter> parameters);

  /// Throws InputError for a name that is not in the list, and what checked_value() throws.
  void set(std::string_view name, const ParameterValue& value);

  /// Throws InputError for the first parameter that has neither a default nor been set.
  void require_complete() const;

  /// The value of a parameter that is in the list and has one; of the type of its kind.
  /// @{
  [[nodiscard]] const ParameterValue& value(std::string_view name) const;
  [[nodiscard]] double number(std::string_view name) const { return std::get<double>(value(name)); }
  [[nodiscard]] std::int64_t integer(std::string_view name) const { return std::get<std::int64_t>(value(name)); }
  [[nodiscard]] bool boolean(std::string_view name) const { return std::get<bool>(value(name)); }
  [[nodiscard]] std::string_view word(std::string_view name) const { return std::get<std::string_view>(value(name)); }
  /// @}

  [[nodiscard]] std::span<const Parameter> parameters() const { return parameters_; }

  /// Equal values of the same list.
  bool operator==(const ParameterValues& other) const {
    return parameters_.data() == other.parameters_.data() && values_ == other.values_;
  }

 private:
  std::span<const Parameter> parameters_;
  std::vector<ParameterValue> values_;
};

}  // namespace shapegauge
