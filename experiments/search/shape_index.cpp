#include "shapegauge/experiments/search/shape_index.h"

#include <fmt/format.h>
#include <utility>

#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/experiments/distributed/packing.h"

namespace shapegauge {

namespace {

constexpr std::string_view magic = "shapegauge search index ";
constexpr std::string_view format_line = "shapegauge search index 1\n";
constexpr std::size_t digits_of_sha256 = 64;
constexpr std::size_t header_size = format_line.size() + digits_of_sha256 + 1;

/// The tables follow the other data, each at a multiple of this from the file's beginning: read where they are.
constexpr std::size_t alignment = 64;

constexpr std::size_t aligned(std::size_t place) { return (place + alignment - 1) / alignment * alignment; }

std::size_t bytes_of(const IndexTable& table) {
  return static_cast<std::size_t>(table.rows * table.columns) * sizeof(float);
}

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

void add(Packer& packer, const NearestModels& nearest) {
  packer.add(nearest.indices).add(nearest.distances).add(nearest.largest);
}

void take(Unpacker& unpacker, NearestModels& nearest) {
  unpacker.take(nearest.indices).take(nearest.distances).take(nearest.largest);
}

void add(Packer& packer, const CollectionSum& sum) {
  packer.add(sum.scale).add(sum.weights).add(sum.units).add(sum.local_scales.size());
  for (const LocalScales& scales : sum.local_scales) packer.add(scales.roots).add(scales.least);
  add(packer, sum.at_ranks);
}

void take(Unpacker& unpacker, CollectionSum& sum) {
  unpacker.take(sum.scale).take(sum.weights).take(sum.units);
  sum.local_scales.resize(unpacker.take_value<std::size_t>());
  for (LocalScales& scales : sum.local_scales) unpacker.take(scales.roots).take(scales.least);
  take(unpacker, sum.at_ranks);
}

void add(Packer& packer, const ShapeIndex& index) {
  packer.add(std::string_view(index.collection));
  add(packer, index.models);
  add(packer, index.failures);
  packer.add(index.tables.size());
  for (const IndexTable& table : index.tables) packer.add(table.rows).add(table.columns);
  add(packer, index.learnt);
  packer.add(index.field_ranges);
  add(packer, index.sum);
  add(packer, index.nearest);
}

void take(Unpacker& unpacker, ShapeIndex& index) {
  unpacker.take(index.collection);
  take(unpacker, index.models);
  take(unpacker, index.failures);
  index.tables.resize(unpacker.take_value<std::size_t>());
  for (IndexTable& table : index.tables) unpacker.take(table.rows).take(table.columns);
  take(unpacker, index.learnt);
  unpacker.take(index.field_ranges);
  take(unpacker, index.sum);
  take(unpacker, index.nearest);
}

}  // namespace

IndexTable::IndexTable(Signatures own) : rows(own.rows()), columns(own.cols()) {
  const auto kept = std::make_shared<const Signatures>(std::move(own));
  entries = {kept, kept->data()};
}

std::string encode_index(const ShapeIndex& index, const std::string& key) {
  Packer data;
  add(data, index);
  Packer content;
  content.add_bytes(key.data(), key.size()).add(std::string_view(std::move(data).bytes()));
  std::string bytes = fmt::format("{}{:0>{}}\n{}", format_line, "", digits_of_sha256, std::move(content).bytes());
  std::size_t size = bytes.size();
  for (const IndexTable& table : index.tables) size = aligned(size) + bytes_of(table);
  bytes.reserve(size);
  for (const IndexTable& table : index.tables) {
    bytes.resize(aligned(bytes.size()));
    bytes.append(reinterpret_cast<const char*>(table.entries.get()), bytes_of(table));
  }
  const std::string checksum = sha256(std::string_view(bytes).substr(header_size));
  return bytes.replace(format_line.size(), checksum.size(), checksum);
}

bool begins_as_index(std::string_view bytes) { return bytes.starts_with(magic); }

std::optional<ShapeIndex> decode_index(const MappedBytes& file, const std::string& key, IndexFault& fault) {
  fault = IndexFault::damaged;
  if (!file.bytes.starts_with(format_line) || file.bytes.size() < header_size) return std::nullopt;
  const std::string_view content = file.bytes.substr(header_size);
  if (file.bytes.substr(format_line.size(), digits_of_sha256) != sha256(content)) return std::nullopt;
  fault = IndexFault::other_method;
  if (!content.starts_with(key)) return std::nullopt;
  Unpacker unpacker(content.substr(key.size()));
  const auto data_size = unpacker.take_value<std::size_t>();
  ShapeIndex index;
  take(unpacker, index);
  std::size_t place = header_size + key.size() + sizeof(data_size) + data_size;
  for (IndexTable& table : index.tables) {
    place = aligned(place);
    table.entries = {file.memory, reinterpret_cast<const float*>(file.bytes.data() + place)};
    place += bytes_of(table);
  }
  fault = IndexFault::none;
  return index;
}

void keep_in_memory(ShapeIndex& index) {
  for (IndexTable& table : index.tables) table = IndexTable(table.signatures());
}

}  // namespace shapegauge
