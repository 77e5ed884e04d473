// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// Length as written by a user: 2, 2mm or 0.1 in.
struct Length {
  double value = 0;  ///< length as a multiple of `unit`, or of the unit of the file's coordinates if `unit` is empty
  std::string unit = {};  ///< name of the unit, one of length_unit_names(); empty if the user gave none
};

/// Returns the names of the supported units: um, mm, cm, m, km, in, ft.
std::vector<std::string> length_unit_names();

/// Returns the length of a unit in metres. Throws InputError for an unknown name; the message lists the known ones.
double metres_of(std::string_view unit);

/// Parses a finite number with an optional unit name. Returns nothing for other text.
std::optional<Length> parse_length(std::string_view text);

/// Converts a length to the unit of a file's coordinates, `file_unit`. Returns a length without a unit unchanged.
/// Throws InputError for a length with a unit if `file_unit` is empty (unknown); `what` names the setting in the
/// message.
double in_file_units(std::string_view what, const Length& length, std::string_view file_unit);

}  // namespace shapegauge
