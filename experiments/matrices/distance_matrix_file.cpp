#include "shapegauge/experiments/matrices/distance_matrix_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <string_view>

#include "shapegauge/core/error.h"
#include "shapegauge/experiments/matrices/csv_matrix.h"
#include "shapegauge/experiments/matrices/npy.h"
#include "shapegauge/experiments/matrices/psb_matrix.h"
#include "shapegauge/experiments/matrices/text_matrix.h"

namespace shapegauge {
namespace {

using Reader = LabelledDistances (*)(const std::filesystem::path&);

template <DistanceMatrix (*read)(const std::filesystem::path&)>
LabelledDistances without_ids(const std::filesystem::path& path) {
  return {.distances = read(path), .ids = {}};
}

struct Format {
  std::string_view extension;
  Reader read;
};

constexpr std::array formats = {
    Format{".matrix", without_ids<read_psb_matrix>},
    Format{".npy", without_ids<read_npy>},
    Format{".csv", read_csv_matrix},
    Format{".txt", without_ids<read_text_matrix>},
    Format{".dat", without_ids<read_text_matrix>},
};

std::string lower_case(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

Reader reader_for(const std::filesystem::path& path) {
  const auto* const found = std::ranges::find(formats, lower_case(path.extension().string()), &Format::extension);
  if (found != formats.end()) return found->read;
  std::string known;
  for (const Format& format : formats) known.append(known.empty() ? "" : ", ").append(format.extension);
  throw InputError(fmt::format("{}: the extension does not tell the format of a distance matrix; known are {}",
                               path.string(), known));
}

}  // namespace

LabelledDistances read_distance_matrix(const std::filesystem::path& path) {
  LabelledDistances result = reader_for(path)(path);
  const DistanceMatrix& distances = result.distances;
  for (Eigen::Index i = 0; i < distances.size(); ++i) {
    if (!std::isnan(distances.data()[i])) continue;
    throw InputError(fmt::format("{}: the distance in row {}, column {} (counted from 0) is not a number (NaN)",
                                 path.string(), i / distances.cols(), i % distances.cols()));
  }
  return result;
}

}  // namespace shapegauge
