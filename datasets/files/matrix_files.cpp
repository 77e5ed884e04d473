#include "shapegauge/datasets/files/matrix_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string_view>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/compressed_files.h"
#include "shapegauge/datasets/files/mat_file.h"
#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/datasets/files/table.h"
#include "shapegauge/datasets/files/text_matrices.h"

namespace shapegauge {

namespace {

// Returns N if the size is that of exactly N^2 positive numbers of that many bytes.
std::optional<Eigen::Index> size_of_square(std::size_t bytes, std::size_t bytes_per_number) {
  const std::size_t numbers = bytes / bytes_per_number;
  const auto size = static_cast<std::size_t>(std::llround(std::sqrt(static_cast<double>(numbers))));
  if (size == 0 || size * size * bytes_per_number != bytes) return std::nullopt;
  return static_cast<Eigen::Index>(size);
}

}  // namespace

Eigen::Index psb_matrix_size(std::size_t bytes, const std::string& source) {
  if (const auto size = size_of_square(bytes, sizeof(float))) return *size;
  // 8 N^2 bytes never equal 4 M^2 bytes, since the square root of 2 is irrational.
  if (const auto size_in_doubles = size_of_square(bytes, sizeof(double))) {
    throw InputError(
        fmt::format("{}: {} bytes do not form a square matrix of float32, as the format requires; they match float64 "
                    "({} x {}); convert it, or save it as .npy",
                    source, bytes, *size_in_doubles, *size_in_doubles));
  }
  throw InputError(fmt::format(
      "{}: {} bytes do not form a square matrix of float32 (4 N^2 bytes); the file is truncated or of another format",
      source, bytes));
}

DistanceMatrix parse_psb_matrix(std::string_view bytes, const std::string& source) {
  const Eigen::Index size = psb_matrix_size(bytes.size(), source);
  DistanceMatrix matrix(size, size);
  float32_format().decode(bytes.data(), static_cast<std::size_t>(matrix.size()), matrix.data());
  return matrix;
}

DistanceMatrix read_psb_matrix(const std::filesystem::path& path) {
  return parse_psb_matrix(read_plain_bytes(path), path.string());
}

namespace {

DistanceMatrix read_npy(const std::filesystem::path& path) { return parse_npy(read_plain_bytes(path), path.string()); }

template <DistanceMatrix (*read)(const std::filesystem::path&)>
LabelledDistances without_ids(const std::filesystem::path& path) {
  return {.distances = read(path), .ids = {}};
}

LabelledTable npy_table(const std::filesystem::path& path) {
  return {.numbers = parse_npy_table(read_plain_bytes(path), path.string()), .row_ids = {}, .column_ids = {}};
}

DistanceMatrix read_npz(const std::filesystem::path& path) {
  return parse_npy(array_in_npz(read_plain_bytes(path), path.string()), path.string());
}

LabelledTable npz_table(const std::filesystem::path& path) {
  return {.numbers = parse_npy_table(array_in_npz(read_plain_bytes(path), path.string()), path.string()),
          .row_ids = {},
          .column_ids = {}};
}

DistanceMatrix read_square_mat(const std::filesystem::path& path) {
  DistanceMatrix matrix = read_mat(path);
  if (matrix.rows() == matrix.cols()) return matrix;
  throw InputError(
      fmt::format("{}: expected a square distance matrix, found {} x {}", path.string(), matrix.rows(), matrix.cols()));
}

LabelledTable mat_table(const std::filesystem::path& path) {
  return {.numbers = read_mat(path), .row_ids = {}, .column_ids = {}};
}

LabelledTable text_table(const std::filesystem::path& path) {
  return {.numbers = parse_text_matrix(read_plain_bytes(path), path.string(), TableShape::any),
          .row_ids = {},
          .column_ids = {}};
}

LabelledTable csv_table(const std::filesystem::path& path) {
  return parse_csv_table(read_plain_bytes(path), path.string());
}

LabelledTable psb_table(const std::filesystem::path& path) {
  return {.numbers = read_psb_matrix(path), .row_ids = {}, .column_ids = {}};  // square matrices only
}

struct Format {
  std::string_view extension;
  LabelledDistances (*read)(const std::filesystem::path&);
  LabelledTable (*read_table)(const std::filesystem::path&);
};

constexpr std::array formats = {
    Format{".matrix", without_ids<read_psb_matrix>, psb_table},
    Format{".npy", without_ids<read_npy>, npy_table},
    Format{".npz", without_ids<read_npz>, npz_table},
    Format{".mat", without_ids<read_square_mat>, mat_table},
    Format{".csv", read_csv_matrix, csv_table},
    Format{".tsv", read_csv_matrix, csv_table},
    Format{".txt", without_ids<read_text_matrix>, text_table},
    Format{".dat", without_ids<read_text_matrix>, text_table},
};

const Format& format_of(const std::filesystem::path& path) {
  const auto* const found = std::ranges::find(formats, format_extension(path), &Format::extension);
  if (found != formats.end()) return *found;
  std::string known;
  for (const Format& format : formats) known.append(known.empty() ? "" : ", ").append(format.extension);
  throw InputError(fmt::format("{}: unknown extension of a distance matrix; known are {}", path.string(), known));
}

}  // namespace

void refuse_nan(const DistanceMatrix& numbers, const MatrixPlace& first, std::string_view what,
                const std::filesystem::path& path) {
  for (Eigen::Index i = 0; i < numbers.size(); ++i) {
    if (!std::isnan(numbers.data()[i])) continue;
    throw InputError(fmt::format("{}: the {} in row {}, column {} (counted from 0) is not a number (NaN)",
                                 path.string(), what, first.row + i / numbers.cols(),
                                 first.column + i % numbers.cols()));
  }
}

LabelledDistances read_distance_matrix(const std::filesystem::path& path) {
  LabelledDistances result = format_of(path).read(path);
  refuse_nan(result.distances, {}, "distance", path);
  return result;
}

LabelledTable read_number_table(const std::filesystem::path& path) {
  LabelledTable result = format_of(path).read_table(path);
  refuse_nan(result.numbers, {}, "number", path);
  return result;
}

void write_distance_matrix(const std::filesystem::path& path, const LabelledDistances& matrix) {
  const std::string extension = lower_case(path.extension().string());
  if (extension == ".npy") return write_npy(path, matrix.distances);
  if (extension != ".csv") {
    throw InputError(fmt::format("distances are written as .npy or .csv, not to \"{}\"", path.string()));
  }
  TextTable table{.header = {"id"}, .rows = {}};
  for (Eigen::Index i = 0; i < matrix.distances.rows(); ++i) {
    const std::string id = matrix.ids.empty() ? std::to_string(i) : matrix.ids[static_cast<std::size_t>(i)];
    table.header.push_back(id);
    auto& row = table.rows.emplace_back(std::vector{id});
    for (const double distance : matrix.distances.row(i)) row.push_back(fmt::format("{}", distance));
  }
  write_file_atomically(path, to_csv(table));
}

}  // namespace shapegauge
