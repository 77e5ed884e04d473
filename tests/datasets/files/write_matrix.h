// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "shapegauge/datasets/files/csv.h"
#include "shapegauge/datasets/files/matrix_files.h"

namespace shapegauge {

/// Writes a matrix as CSV with full precision, and with ids if it has any.
inline void write_csv_matrix(const std::filesystem::path& path, const DistanceMatrix& matrix,
                             const std::vector<std::string>& ids = {}) {
  std::string text;
  if (!ids.empty()) {
    text = "id";
    for (const std::string& id : ids) text += ',' + csv_cell(id);
    text += '\n';
  }
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    if (!ids.empty()) text += csv_cell(ids[static_cast<std::size_t>(row)]) + ',';
    const auto numbers = matrix.row(row);
    fmt::format_to(std::back_inserter(text), "{}\n", fmt::join(numbers.begin(), numbers.end(), ","));
  }
  std::ofstream(path, std::ios::binary) << text;
}

/// Writes Princeton's format on a little-endian machine; distances are rounded to float32.
inline void write_psb_matrix(const std::filesystem::path& path, const DistanceMatrix& matrix) {
  const Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rounded = matrix.cast<float>();
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(rounded.data()),
             static_cast<std::streamsize>(static_cast<std::size_t>(rounded.size()) * sizeof(float)));
}

}  // namespace shapegauge
