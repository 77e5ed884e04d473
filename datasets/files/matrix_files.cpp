// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/files/matrix_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <utility>

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

namespace {

LabelledTable without_ids(DistanceMatrix numbers) {
  return {.numbers = std::move(numbers), .row_ids = {}, .column_ids = {}};
}

// Returns the size of the matrix with that many entries above its diagonal, if there is one.
std::optional<Eigen::Index> size_of_condensed(Eigen::Index entries) {
  constexpr Eigen::Index max_entries = Eigen::Index{1} << 60;  // headers of damaged files have more
  if (entries <= 0 || entries > max_entries) return std::nullopt;
  const auto size = static_cast<Eigen::Index>(std::llround((1 + std::sqrt(1 + 8 * static_cast<double>(entries))) / 2));
  return size * (size - 1) / 2 == entries ? std::optional(size) : std::nullopt;
}

// Expands condensed distances.
DistanceMatrix expanded(const DistanceMatrix& vector) {
  const Eigen::Index size = size_of_condensed(vector.size()).value();
  DistanceMatrix matrix = DistanceMatrix::Zero(size, size);
  Eigen::Index next = 0;
  for (Eigen::Index row = 0; row < size; ++row) {
    for (Eigen::Index column = row + 1; column < size; ++column) {
      matrix(row, column) = matrix(column, row) = vector.data()[next++];
    }
  }
  return matrix;
}

bool is_condensed(const DistanceMatrix& table) {
  const std::array sizes{static_cast<std::uint64_t>(table.rows()), static_cast<std::uint64_t>(table.cols())};
  return is_condensed_shape(sizes);
}

// A file with the variable to read.
struct Source {
  const std::filesystem::path& path;
  const std::string& variable;
};

LabelledTable read_psb(const Source& source, TableShape /*shape*/) {
  return without_ids(parse_psb_matrix(read_plain_bytes(source.path), source.path.string()));  // square always
}

LabelledTable npy_table(const std::string& bytes, const std::string& source, TableShape shape) {
  if (shape == TableShape::square && is_condensed_shape(parse_npy_header(bytes, source).shape))
    return without_ids(expanded(parse_npy(bytes, source, TableShape::any)));
  return without_ids(parse_npy(bytes, source, shape));
}

LabelledTable read_npy(const Source& source, TableShape shape) {
  return npy_table(read_plain_bytes(source.path), source.path.string(), shape);
}

LabelledTable read_npz(const Source& source, TableShape shape) {
  const std::string name = source.path.string();
  return npy_table(extract_npz_array(read_plain_bytes(source.path), name, source.variable), name, shape);
}

LabelledTable read_matlab(const Source& source, TableShape shape) {
  LabelledTable table = without_ids(read_mat(source.path, source.variable));
  if (shape == TableShape::any || table.numbers.rows() == table.numbers.cols()) return table;
  if (is_condensed(table.numbers)) return without_ids(expanded(table.numbers));
  throw InputError(fmt::format("{}: expected a square distance matrix, found {} x {}", source.path.string(),
                               table.numbers.rows(), table.numbers.cols()));
}

LabelledTable read_csv(const Source& source, TableShape shape) {
  const auto parse = shape == TableShape::square ? parse_csv_matrix : parse_csv_table;
  return parse(read_plain_text(source.path), source.path.string());
}

LabelledTable read_text(const Source& source, TableShape shape) {
  const std::string text = read_plain_text(source.path);
  if (shape == TableShape::square && is_vector(text)) {
    const DistanceMatrix vector = parse_text_matrix(text, source.path.string(), TableShape::any);
    if (is_condensed(vector)) return without_ids(expanded(vector));
  }
  return without_ids(parse_text_matrix(text, source.path.string(), shape));
}

struct Format {
  std::string_view extension;
  LabelledTable (*read)(const Source&, TableShape);
  bool has_variables = false;
};

constexpr std::array formats = {
    Format{".matrix", read_psb},       Format{".npy", read_npy},  Format{".npz", read_npz, true},
    Format{".mat", read_matlab, true}, Format{".csv", read_csv},  Format{".tsv", read_csv},
    Format{".txt", read_text},         Format{".dat", read_text},
};

constexpr auto extensions = [] {
  std::array<std::string_view, formats.size()> all{};
  std::ranges::transform(formats, all.begin(), &Format::extension);
  return all;
}();

const Format& format_of(const std::filesystem::path& path) {
  const auto* const found = std::ranges::find(formats, format_extension(path), &Format::extension);
  if (found != formats.end()) return *found;
  throw InputError(fmt::format("{}: unknown extension of a distance matrix; known are {}", path.string(),
                               fmt::join(extensions, ", ")));
}

}  // namespace

std::span<const std::string_view> matrix_extensions() { return extensions; }

bool is_condensed_shape(std::span<const std::uint64_t> shape) {
  if (shape.empty() || shape.size() > 2) return false;
  if (shape.size() == 2 && (shape[0] == 1) == (shape[1] == 1)) return false;
  const std::uint64_t length = shape.size() == 1 ? shape[0] : std::max(shape[0], shape[1]);
  return size_of_condensed(static_cast<Eigen::Index>(length)).has_value();
}

void replace_or_refuse_nan(DistanceMatrix& numbers, const MatrixPosition& first, TableShape shape,
                           const std::filesystem::path& path) {
  const bool square = shape == TableShape::square;
  for (Eigen::Index i = 0; i < numbers.size(); ++i) {
    if (!std::isnan(numbers.data()[i])) continue;
    const Eigen::Index row = first.row + i / numbers.cols();
    const Eigen::Index column = first.column + i % numbers.cols();
    if (!square || row != column) {
      throw InputError(fmt::format("{}: the {} in row {}, column {} (counted from 0) is not a number (NaN)",
                                   path.string(), square ? "distance" : "number", row, column));
    }
    numbers.data()[i] = 0;
  }
}

LabelledTable read_matrix(const std::filesystem::path& path, TableShape shape, const std::string& variable) {
  const Format& format = format_of(path);
  if (!variable.empty() && !format.has_variables) {
    throw InputError(fmt::format("{}: `variable` applies to .npz and .mat files only", path.string()));
  }
  LabelledTable result = format.read({.path = path, .variable = variable}, shape);
  replace_or_refuse_nan(result.numbers, {}, shape, path);
  return result;
}

void write_distance_matrix(const std::filesystem::path& path, const DistanceMatrix& distances,
                           const std::vector<std::string>& ids) {
  const std::string extension = lower_case(path.extension().string());
  if (extension == ".npy") return write_npy(path, distances);
  if (extension != ".csv") {
    throw InputError(fmt::format("distances are written as .npy or .csv, not to \"{}\"", path.string()));
  }
  TextTable table{.header = {"id"}, .rows = {}};
  for (Eigen::Index i = 0; i < distances.rows(); ++i) {
    const std::string id = ids.empty() ? std::to_string(i) : ids[static_cast<std::size_t>(i)];
    table.header.push_back(id);
    auto& row = table.rows.emplace_back(std::vector{id});
    for (const double distance : distances.row(i)) row.push_back(fmt::format("{}", distance));
  }
  write_file_atomically(path, to_csv(table));
}

}  // namespace shapegauge
