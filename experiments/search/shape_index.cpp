#include "shapegauge/experiments/search/shape_index.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/experiments/distributed/packing.h"

namespace shapegauge {

namespace {

constexpr std::string_view format_line = "shapegauge search index 1\n";
constexpr std::size_t digits_of_sha256 = 64;

using ByteTable = Eigen::Matrix<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

void add(Packer& packer, const std::vector<IndexedFile>& files) {
  packer.add(files.size());
  for (const IndexedFile& file : files) {
    packer.add(std::string_view(file.id)).add(std::string_view(file.path)).add(file.bytes).add(file.modified);
    packer.add(std::string_view(file.sha256)).add(std::string_view(file.failure));
  }
}

void take(Unpacker& unpacker, std::vector<IndexedFile>& files) {
  files.resize(unpacker.take_value<std::size_t>());
  for (IndexedFile& file : files) {
    unpacker.take(file.id).take(file.path).take(file.bytes).take(file.modified).take(file.sha256).take(file.failure);
  }
}

template <typename Matrix>
void add(Packer& packer, const std::vector<Matrix>& matrices) {
  packer.add(matrices.size());
  for (const Matrix& matrix : matrices) packer.add(matrix);
}

template <typename Matrix>
void take(Unpacker& unpacker, std::vector<Matrix>& matrices) {
  matrices.resize(unpacker.take_value<std::size_t>());
  for (Matrix& matrix : matrices) unpacker.take(matrix);
}

constexpr float largest_byte = 255;

/// Returns true for a table of integers from 0 to 255, which then take a byte each.
bool fits_bytes(const Signatures& table) {
  return std::all_of(table.data(), table.data() + table.size(), [](float number) {
    return number >= 0 && number <= largest_byte && number == std::floor(number) && !std::signbit(number);
  });
}

void add_tables(Packer& packer, const std::vector<Signatures>& tables) {
  packer.add(tables.size());
  for (const Signatures& table : tables) {
    const bool bytes = fits_bytes(table);
    packer.add(bytes);
    if (bytes) {
      packer.add(ByteTable(table.cast<std::uint8_t>()));
    } else {
      packer.add(table);
    }
  }
}

void take_tables(Unpacker& unpacker, std::vector<Signatures>& tables) {
  tables.resize(unpacker.take_value<std::size_t>());
  for (Signatures& table : tables) {
    if (unpacker.take_value<bool>()) {
      table = unpacker.take_value<ByteTable>().cast<float>();
    } else {
      unpacker.take(table);
    }
  }
}

void add(Packer& packer, const NearestModels& nearest) {
  packer.add(nearest.indices).add(nearest.distances).add(nearest.largest);
}

void take(Unpacker& unpacker, NearestModels& nearest) {
  unpacker.take(nearest.indices).take(nearest.distances).take(nearest.largest);
}

void add(Packer& packer, const CollectionSum& sum) {
  packer.add(sum.scale).add(sum.weights).add(sum.units).add(sum.local_scales.size());
  for (const LocalScales& scales : sum.local_scales) packer.add(scales.roots).add(scales.least);
  packer.add(sum.nearest.size());
  for (const NearestModels& nearest : sum.nearest) add(packer, nearest);
  add(packer, sum.means);
}

void take(Unpacker& unpacker, CollectionSum& sum) {
  unpacker.take(sum.scale).take(sum.weights).take(sum.units);
  sum.local_scales.resize(unpacker.take_value<std::size_t>());
  for (LocalScales& scales : sum.local_scales) unpacker.take(scales.roots).take(scales.least);
  sum.nearest.resize(unpacker.take_value<std::size_t>());
  for (NearestModels& nearest : sum.nearest) take(unpacker, nearest);
  take(unpacker, sum.means);
}

}  // namespace

std::string encode_index(const ShapeIndex& index, const std::string& key) {
  Packer packer;
  packer.add_bytes(key.data(), key.size());
  add(packer, index.models);
  add(packer, index.failures);
  add_tables(packer, index.tables);
  add(packer, index.learnt);
  packer.add(index.field_ranges);
  add(packer, index.sum);
  add(packer, index.nearest);
  const std::string content = std::move(packer).bytes();
  return fmt::format("{}{}\n{}", format_line, sha256(content), content);
}

std::optional<ShapeIndex> decode_index(std::string_view bytes, const std::string& key, IndexFault& fault) {
  fault = IndexFault::damaged;
  const std::size_t begin = format_line.size() + digits_of_sha256 + 1;
  if (!bytes.starts_with(format_line) || bytes.size() < begin) return std::nullopt;
  const std::string_view content = bytes.substr(begin);
  if (bytes.substr(format_line.size(), digits_of_sha256) != sha256(content)) return std::nullopt;
  fault = IndexFault::other_method;
  if (!content.starts_with(key)) return std::nullopt;
  Unpacker unpacker(content.substr(key.size()));
  ShapeIndex index;
  take(unpacker, index.models);
  take(unpacker, index.failures);
  take_tables(unpacker, index.tables);
  take(unpacker, index.learnt);
  unpacker.take(index.field_ranges);
  take(unpacker, index.sum);
  take(unpacker, index.nearest);
  fault = IndexFault::none;
  return index;
}

}  // namespace shapegauge
