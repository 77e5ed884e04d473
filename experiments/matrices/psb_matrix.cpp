#include "shapegauge/experiments/matrices/psb_matrix.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/atomic_file.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/experiments/matrices/matrix_bytes.h"

namespace shapegauge {
namespace {

// N where there are exactly N^2 numbers of that many bytes each, and some.
std::optional<Eigen::Index> size_of_square(std::size_t bytes, std::size_t bytes_per_number) {
  const std::size_t numbers = bytes / bytes_per_number;
  const auto size = static_cast<std::size_t>(std::llround(std::sqrt(static_cast<double>(numbers))));
  if (size == 0 || size * size * bytes_per_number != bytes) return std::nullopt;
  return static_cast<Eigen::Index>(size);
}

}  // namespace

DistanceMatrix parse_psb_matrix(std::string_view bytes, const std::string& source) {
  const auto size = size_of_square(bytes.size(), sizeof(float));
  if (size) return matrix_of_bytes<float>(bytes, *size, *size, std::endian::little, false);
  // 8 N^2 bytes can never be 4 M^2 bytes: the square root of 2 is no fraction.
  if (const auto size_in_doubles = size_of_square(bytes.size(), sizeof(double))) {
    throw InputError(
        fmt::format("{}: {} bytes are no square matrix of float32, which the format has; this looks like "
                    "float64 ({} x {}): convert it, or save it as .npy",
                    source, bytes.size(), *size_in_doubles, *size_in_doubles));
  }
  throw InputError(
      fmt::format("{}: {} bytes are no square matrix of float32 (4 N^2 bytes); the file is cut off or another format",
                  source, bytes.size()));
}

DistanceMatrix read_psb_matrix(const std::filesystem::path& path) {
  return parse_psb_matrix(read_file_bytes(path), path.string());
}

void write_psb_matrix(const std::filesystem::path& path, const DistanceMatrix& matrix) {
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(matrix.size()) * sizeof(float));
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    const double distance = matrix.data()[i];
    if (std::isfinite(distance) && std::abs(distance) > static_cast<double>(std::numeric_limits<float>::max())) {
      throw InputError(
          fmt::format("cannot write {}: the distance in row {}, column {} (counted from 0) is {}, beyond "
                      "float32; write .npy instead",
                      path.string(), i / matrix.cols(), i % matrix.cols(), distance));
    }
    append_number(bytes, static_cast<float>(distance));
  }
  write_file_atomically(path, bytes);
}

}  // namespace shapegauge
