#pragma once

#include <filesystem>

#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// Reads the only real matrix in a MATLAB `.mat` file (single, double, or integers of any size) with the library matio.
/// Throws InputError if the file cannot be read or does not have exactly one such matrix; the message lists them.
DistanceMatrix read_mat(const std::filesystem::path& path);

}  // namespace shapegauge
