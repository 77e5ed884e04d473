// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// Length as written by a user: 2, 2mm or 0.1 in.
struct Length {
  double value = 0;
  std::string unit = {};  ///< name of the unit, one of length_unit_names(); empty if the user gave none
};

/// Returns the names of the supported units: um, mm, cm, m, km, in, ft.
std::vector<std::string> length_unit_names();

/// Returns the length of a unit in metres. Throws InputError for an unknown name; the message lists the known ones.
double metres_of(std::string_view unit);

/// Parses a finite number with an optional unit name. Returns nothing for other text.
std::optional<Length> parse_length(std::string_view text);

/// Converts a length to the units of a file. Returns a length without a unit unchanged. Throws InputError, prefixed by
/// `what`, for a length with a unit if the file's unit is unknown (empty).
double in_file_units(std::string_view what, const Length& length, std::string_view file_unit);

}  // namespace shapegauge
