// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

/// Interval of valid values, closed unless an end is marked as open. Infinite ends mean no limit; infinity itself and
/// NaN are never valid.
struct Bounds {
  double low = -std::numeric_limits<double>::infinity();  ///< lower end
  double high = std::numeric_limits<double>::infinity();  ///< upper end
  bool low_open = false;                                  ///< true if the lower end itself is not valid
  bool high_open = false;                                 ///< true if the upper end itself is not valid

  [[nodiscard]] bool contains(double value) const;  ///< returns true if the value is valid
};

/// Formats the interval in words that follow "it must be": "from 0 to 1", "above 0 and at most 1", "at least 1".
std::string to_string(const Bounds& bounds);

/// Throws InputError "<what> is <value>; it must be <bounds>" unless the bounds contain the value.
void require_in_bounds(std::string_view what, double value, const Bounds& bounds);

/// List of at most 16 integers. As an option, the empty list means "auto".
class IntegerList {
 public:
  static constexpr std::size_t most = 16;  ///< maximum number of integers in a list

  constexpr IntegerList() = default;
  constexpr IntegerList(int value) : IntegerList{std::int64_t{value}} {}  // NOLINT: one number is a list of one
  constexpr IntegerList(std::initializer_list<std::int64_t> values) : IntegerList(std::span(values)) {}

  /// Throws ArgumentError for more than 16 values.
  constexpr explicit IntegerList(std::span<const std::int64_t> values) : size_(values.size()) {
    if (size_ > most) throw ArgumentError("a list may have at most 16 whole numbers");
    for (std::size_t i = 0; i < size_; ++i) values_[i] = values[i];
  }

  /// Returns the integers of the list.
  [[nodiscard]] constexpr std::span<const std::int64_t> values() const { return {values_.data(), size_}; }
  [[nodiscard]] constexpr bool empty() const { return size_ == 0; }

  friend constexpr bool operator==(const IntegerList&, const IntegerList&) = default;

 private:
  std::array<std::int64_t, most> values_{};
  std::size_t size_ = 0;
};

/// Type of the values of a parameter.
enum class ParameterKind {
  number,    ///< finite double within the bounds, or one of the choices if there are any ("auto")
  integer,   ///< integer within the bounds
  integers,  ///< list of up to 16 integers within the bounds, or one of the choices
  boolean,   ///< true or false
  choice     ///< one of the words in Parameter::choices
};

/// Value of a parameter, or std::monostate for no value. A word is a view of one of the parameter's choices and is
/// valid as long as they are.
using ParameterValue = std::variant<std::monostate, bool, std::int64_t, double, std::string_view, IntegerList>;

/// Parameter::unit of lengths that are fractions of the bounding-box diagonal.
inline constexpr std::string_view bounding_box_diagonals = "diagonals of the bounding box";

/// Describes one setting of an algorithm. Registry entries list their parameters. Configurations, the JSON schema, the
/// command line and the documentation are generated from these lists, and algorithms validate their options against the
/// same bounds.
struct Parameter {
  std::string_view name;                       ///< name in configurations, such as "bins"
  ParameterKind kind = ParameterKind::number;  ///< type of the values
  ParameterValue default_value = {};           ///< default value, of the parameter's kind; none if mandatory
  Bounds bounds = {};                          ///< valid values of numbers and integers
  /// Valid words of a choice, or words such as "auto" that a number or list may have as its value.
  std::span<const std::string_view> choices = {};
  std::string_view description;  ///< meaning of the parameter in one sentence, for help and documentation
  std::string_view unit = {};    ///< unit of a number, as in "in degrees"; empty for a pure number

  /// Returns true for a mandatory parameter, which has no default.
  [[nodiscard]] bool required() const { return std::holds_alternative<std::monostate>(default_value); }
};

/// Returns the choice of a parameter that equals a word; nothing if there is none. The result outlives `word`.
std::optional<std::string_view> choice_of(const Parameter& parameter, std::string_view word);

/// Validates a value and converts it to the parameter's kind. An integer becomes a double for a number parameter and a
/// list of one for a list parameter; an empty list becomes the choice "auto". Throws InputError, with the parameter's
/// name, for a value of another kind, out of bounds or not among the choices.
ParameterValue validate_value(const Parameter& parameter, const ParameterValue& value);

/// Parses a value from text: a number, integers separated by commas, true or false, or one of the choices. Throws
/// InputError as validate_value() does.
ParameterValue parse_value(const Parameter& parameter, std::string_view text);

/// Formats a value as text that parse_value() reads; empty for no value.
std::string to_string(const ParameterValue& value);

/// Formats the unit of a parameter as text that follows a number: ", in degrees"; empty without a unit.
std::string unit_phrase(const Parameter& parameter);

/// Describes the valid values of a parameter: "a number from 0 to 1, in degrees, or auto".
std::string legal_values(const Parameter& parameter);

/// Values for a list of parameters, such as those of one field. Refers to the list, which must outlive the object.
class ParameterValues {
 public:
  /// Sets all values to their defaults.
  explicit ParameterValues(std::span<const Parameter> parameters);

  /// Sets one value. Throws InputError for a name that is not in the list, and as validate_value() does.
  void set(std::string_view name, const ParameterValue& value);

  /// Throws InputError for the first mandatory parameter without a value.
  void require_complete() const;

  /// Returns the value of a parameter, or std::monostate if it has none; null if the parameter is not in the list.
  [[nodiscard]] const ParameterValue* find(std::string_view name) const;

  /// Returns the value of a parameter in the C++ type of its kind. The parameter must be in the list and have a value.
  /// @{
  [[nodiscard]] const ParameterValue& value(std::string_view name) const;
  [[nodiscard]] double number(std::string_view name) const { return std::get<double>(value(name)); }
  [[nodiscard]] std::int64_t integer(std::string_view name) const { return std::get<std::int64_t>(value(name)); }
  [[nodiscard]] bool boolean(std::string_view name) const { return std::get<bool>(value(name)); }
  [[nodiscard]] std::string_view word(std::string_view name) const { return std::get<std::string_view>(value(name)); }
  /// @}

  [[nodiscard]] std::span<const Parameter> parameters() const { return parameters_; }

  /// Returns true if both objects refer to the same list of parameters and all values are equal.
  bool operator==(const ParameterValues& other) const {
    return parameters_.data() == other.parameters_.data() && values_ == other.values_;
  }

 private:
  std::span<const Parameter> parameters_;  ///< parameters that have values
  std::vector<ParameterValue> values_;     ///< value of each parameter
};

}  // namespace shapegauge
