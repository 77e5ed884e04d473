#pragma once

#include <filesystem>

#include "shapegauge/experiments/matrices/labelled_distances.h"

namespace shapegauge {

/// Reads a square distance matrix in the format that the name's extension tells (any case): `.matrix` (Princeton Shape
/// Benchmark), `.npy` (NumPy), `.csv`, `.txt` or `.dat` (numbers between white space). Only CSV carries ids. Distances
/// may be infinite. Throws InputError: absent or unreadable file, another extension, anything that the reader of the
/// format refuses, a distance that is NaN.
LabelledDistances read_distance_matrix(const std::filesystem::path& path);

}  // namespace shapegauge
