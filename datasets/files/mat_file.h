// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// Reads the real matrix named `variable`, or the only matrix if `variable` is empty, in a MATLAB `.mat` file (single,
/// double, or integers of any size) with the library matio. Scalars do not count next to a matrix. Throws InputError if
/// the file cannot be read, does not have exactly one such matrix (the message lists its variables), or an integer is
/// beyond 2^53.
DistanceMatrix read_mat(const std::filesystem::path& path, const std::string& variable = "");

}  // namespace shapegauge
