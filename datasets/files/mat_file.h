#pragma once

#include <filesystem>

#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// Reads the only matrix of real numbers in a MATLAB `.mat` file: single, double, or integers of any size, by the
/// library matio. Throws InputError where it cannot be read or has another number of such matrices than one, which are
/// then named.
DistanceMatrix read_mat(const std::filesystem::path& path);

}  // namespace shapegauge
