#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "shapegauge/experiments/matrices/number_rows.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// Reads a square matrix of numbers between blanks, one row a line, as numpy.savetxt writes it. Empty lines and lines
/// that begin with `#` are passed over; `inf` is a number. Throws InputError: absent or unreadable file, something that
/// is not a number, a row of another length, not as many rows as columns.
DistanceMatrix read_text_matrix(const std::filesystem::path& path);

/// The same for the text of a file; `source` stands in front of messages. With TableShape::any the rows need only be of
/// equal length.
DistanceMatrix parse_text_matrix(std::string_view text, const std::string& source,
                                 TableShape shape = TableShape::square);

}  // namespace shapegauge
