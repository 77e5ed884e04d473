#pragma once

#include <filesystem>

#include "shapegauge/experiments/matrices/labelled_distances.h"

namespace shapegauge {

/// Reads a square distance matrix in the format that the name's extension tells (any case): `.matrix` (Princeton Shape
/// Benchmark), `.npy` (NumPy), `.csv`, `.txt` or `.dat` (numbers between white space). Only CSV carries ids. Distances
/// may be infinite. Throws InputError: absent or unreadable file, another extension, anything that the reader of the
/// format refuses, a distance that is NaN.
LabelledDistances read_distance_matrix(const std::filesystem::path& path);

/// Reads any table of numbers in the same way: distances between two sets of models, or features. The ids of rows and
/// columns come with CSV (csv_matrix.h). Throws InputError as read_distance_matrix, but for the shape.
LabelledTable read_number_table(const std::filesystem::path& path);

}  // namespace shapegauge
