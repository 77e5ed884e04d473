#include "shapegauge/experiments/matrices/npy.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <fmt/format.h>
#include <span>
#include <string>
#include <string_view>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/atomic_file.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/printable.h"
#include "shapegauge/experiments/matrices/matrix_bytes.h"
#include "shapegauge/experiments/matrices/npy_header.h"
#include "shapegauge/experiments/text/quoted_word.h"

namespace shapegauge {
namespace {

std::string shape_as_text(const NpyHeader& header) {
  return fmt::format("({})", printable(fmt::format("{}", fmt::join(header.shape, ", ")), 60));
}

struct Size {
  Eigen::Index rows = 0;
  Eigen::Index columns = 0;
};

// Checks that the data is a matrix of numbers of that many bytes, and gives its size.
Size checked_size(const NpyHeader& header, std::size_t data_bytes, std::size_t bytes_per_number,
                  const std::string& source) {
  const std::uint64_t rows = header.shape.at(0);
  const std::uint64_t columns = header.shape.size() == 1 ? 1 : header.shape[1];
  // Compared by division: the claimed size may be so large that the product does not fit into a number.
  const bool fits = rows <= data_bytes / bytes_per_number / columns && rows * columns * bytes_per_number == data_bytes;
  if (!fits) {
    throw InputError(
        fmt::format("{}: {} bytes of data follow the header, which is not what an array of shape {} and "
                    "type {} has; the file is cut off or damaged",
                    source, data_bytes, shape_as_text(header), header.type));
  }
  return {static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns)};
}

template <typename Number>
DistanceMatrix decode(std::string_view data, const NpyHeader& header, std::endian order, const std::string& source) {
  const Size size = checked_size(header, data.size(), sizeof(Number), source);
  return matrix_of_bytes<Number>(data, size.rows, size.columns, order, header.column_by_column);
}

DistanceMatrix decode(std::string_view bytes, const NpyHeader& header, const std::string& source) {
  const std::string_view data = bytes.substr(header.data_begin);
  if (header.type == "<f8") return decode<double>(data, header, std::endian::little, source);
  if (header.type == "<f4") return decode<float>(data, header, std::endian::little, source);
  if (header.type == ">f8") return decode<double>(data, header, std::endian::big, source);
  if (header.type == ">f4") return decode<float>(data, header, std::endian::big, source);
  throw InputError(fmt::format("{}: numbers of type {} are not supported; save the array as float32 or float64", source,
                               quoted_word(header.type)));
}

}  // namespace

DistanceMatrix parse_npy(std::string_view bytes, const std::string& source) {
  const NpyHeader header = parse_npy_header(bytes, source);
  if (header.shape.size() != 2 || header.shape[0] != header.shape[1] || header.shape[0] == 0) {
    throw InputError(
        fmt::format("{}: a distance matrix is square, but this array has the shape {}", source, shape_as_text(header)));
  }
  return decode(bytes, header, source);
}

DistanceMatrix parse_npy_table(std::string_view bytes, const std::string& source) {
  const NpyHeader header = parse_npy_header(bytes, source);
  const bool table = header.shape.size() == 1 || header.shape.size() == 2;
  if (!table || std::ranges::find(header.shape, std::uint64_t{0}) != header.shape.end()) {
    throw InputError(fmt::format("{}: expected a matrix of numbers, but this array has the shape {}", source,
                                 shape_as_text(header)));
  }
  return decode(bytes, header, source);
}

DistanceMatrix read_npy(const std::filesystem::path& path) { return parse_npy(read_file_bytes(path), path.string()); }

namespace {

void write_numbers(const std::filesystem::path& path, std::string header, std::span<const double> numbers) {
  header.reserve(header.size() + numbers.size_bytes());
  for (const double number : numbers) append_number(header, number);
  write_file_atomically(path, header);
}

}  // namespace

void write_npy(const std::filesystem::path& path, const DistanceMatrix& matrix) {
  write_numbers(path,
                npy_header_of_matrix(static_cast<std::size_t>(matrix.rows()), static_cast<std::size_t>(matrix.cols())),
                {matrix.data(), static_cast<std::size_t>(matrix.size())});
}

void write_npy_vector(const std::filesystem::path& path, const Eigen::VectorXd& values) {
  const auto size = static_cast<std::size_t>(values.size());
  write_numbers(path, npy_header_of_vector(size), {values.data(), size});
}

}  // namespace shapegauge
