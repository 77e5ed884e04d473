#include "shapegauge/datasets/files/matrix_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <string_view>
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

LabelledTable read_psb(const std::filesystem::path& path, TableShape /*shape*/) {
  return without_ids(parse_psb_matrix(read_plain_bytes(path), path.string()));  // square always
}

LabelledTable read_npy(const std::filesystem::path& path, TableShape shape) {
  return without_ids(parse_npy(read_plain_bytes(path), path.string(), shape));
}

LabelledTable read_npz(const std::filesystem::path& path, TableShape shape) {
  return without_ids(parse_npy(array_in_npz(read_plain_bytes(path), path.string()), path.string(), shape));
}

LabelledTable read_matlab(const std::filesystem::path& path, TableShape shape) {
  LabelledTable table = without_ids(read_mat(path));
  if (shape == TableShape::any || table.numbers.rows() == table.numbers.cols()) return table;
  throw InputError(fmt::format("{}: expected a square distance matrix, found {} x {}", path.string(),
                               table.numbers.rows(), table.numbers.cols()));
}

LabelledTable read_csv(const std::filesystem::path& path, TableShape shape) {
  const auto parse = shape == TableShape::square ? parse_csv_matrix : parse_csv_table;
  return parse(read_plain_bytes(path), path.string());
}

LabelledTable read_text(const std::filesystem::path& path, TableShape shape) {
  return without_ids(parse_text_matrix(read_plain_bytes(path), path.string(), shape));
}

struct Format {
  std::string_view extension;
  LabelledTable (*read)(const std::filesystem::path&, TableShape);
};

constexpr std::array formats = {
    Format{".matrix", read_psb}, Format{".npy", read_npy}, Format{".npz", read_npz},  Format{".mat", read_matlab},
    Format{".csv", read_csv},    Format{".tsv", read_csv}, Format{".txt", read_text}, Format{".dat", read_text},
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

void refuse_nan(const DistanceMatrix& numbers, const MatrixPlace& first, std::string_view what,
                const std::filesystem::path& path) {
  for (Eigen::Index i = 0; i < numbers.size(); ++i) {
    if (!std::isnan(numbers.data()[i])) continue;
    throw InputError(fmt::format("{}: the {} in row {}, column {} (counted from 0) is not a number (NaN)",
                                 path.string(), what, first.row + i / numbers.cols(),
                                 first.column + i % numbers.cols()));
  }
}

LabelledTable read_matrix(const std::filesystem::path& path, TableShape shape) {
  LabelledTable result = format_of(path).read(path, shape);
  refuse_nan(result.numbers, {}, shape == TableShape::square ? "distance" : "number", path);
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
