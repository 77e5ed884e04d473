#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// A length as a user writes it: 2, 2mm or 0.1 in.
struct Length {
  double value = 0;
  std::string unit = {};  ///< a name of length_unit_names(); empty: none is said
};

/// The units of length by name: um, mm, cm, m, km, in, ft.
std::vector<std::string> length_unit_names();

/// A unit in metres. Throws InputError for an unknown name, with those that are known.
double metres_of(std::string_view unit);

/// The length in a text; nothing where the text is no finite number, alone or before the name of a unit.
std::optional<Length> parse_length(std::string_view text);

/// The length in units of a file. A length without a unit is in these already. Throws InputError, beginning with
/// `what`, where the length has a unit and the file's is not known (empty).
double in_file_units(std::string_view what, const Length& length, std::string_view file_unit);

}  // namespace shapegauge
