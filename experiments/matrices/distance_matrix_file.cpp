#include "shapegauge/experiments/matrices/distance_matrix_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <string_view>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/experiments/matrices/csv_matrix.h"
#include "shapegauge/experiments/matrices/npy.h"
#include "shapegauge/experiments/matrices/psb_matrix.h"
#include "shapegauge/experiments/matrices/text_matrix.h"

namespace shapegauge {
namespace {

template <DistanceMatrix (*read)(const std::filesystem::path&)>
LabelledDistances without_ids(const std::filesystem::path& path) {
  return {.distances = read(path), .ids = {}};
}

LabelledTable npy_table(const std::filesystem::path& path) {
  return {.numbers = parse_npy_table(read_file_bytes(path), path.string()), .row_ids = {}, .column_ids = {}};
}

LabelledTable text_table(const std::filesystem::path& path) {
  return {.numbers = parse_text_matrix(read_file_bytes(path), path.string(), TableShape::any),
          .row_ids = {},
          .column_ids = {}};
}

LabelledTable csv_table(const std::filesystem::path& path) {
  return parse_csv_table(read_file_bytes(path), path.string());
}

LabelledTable psb_table(const std::filesystem::path& path) {
  return {.numbers = read_psb_matrix(path), .row_ids = {}, .column_ids = {}};  // knows square ones only
}

struct Format {
  std::string_view extension;
  LabelledDistances (*read)(const std::filesystem::path&);
  LabelledTable (*read_table)(const std::filesystem::path&);
};

constexpr std::array formats = {
    Format{".matrix", without_ids<read_psb_matrix>, psb_table},
    Format{".npy", without_ids<read_npy>, npy_table},
    Format{".csv", read_csv_matrix, csv_table},
    Format{".txt", without_ids<read_text_matrix>, text_table},
    Format{".dat", without_ids<read_text_matrix>, text_table},
};

std::string lower_case(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

const Format& format_of(const std::filesystem::path& path) {
  const auto* const found = std::ranges::find(formats, lower_case(path.extension().string()), &Format::extension);
  if (found != formats.end()) return *found;
  std::string known;
  for (const Format& format : formats) known.append(known.empty() ? "" : ", ").append(format.extension);
  throw InputError(fmt::format("{}: the extension does not tell the format of a distance matrix; known are {}",
                               path.string(), known));
}

void refuse_nan(const DistanceMatrix& numbers, std::string_view what, const std::filesystem::path& path) {
  for (Eigen::Index i = 0; i < numbers.size(); ++i) {
    if (!std::isnan(numbers.data()[i])) continue;
    throw InputError(fmt::format("{}: the {} in row {}, column {} (counted from 0) is not a number (NaN)",
                                 path.string(), what, i / numbers.cols(), i % numbers.cols()));
  }
}

}  // namespace

LabelledDistances read_distance_matrix(const std::filesystem::path& path) {
  LabelledDistances result = format_of(path).read(path);
  refuse_nan(result.distances, "distance", path);
  return result;
}

LabelledTable read_number_table(const std::filesystem::path& path) {
  LabelledTable result = format_of(path).read_table(path);
  refuse_nan(result.numbers, "number", path);
  return result;
}

}  // namespace shapegauge
