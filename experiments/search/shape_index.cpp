// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/search/shape_index.h"

#include <fmt/format.h>
#include <utility>

#include "shapegauge/core/base/members.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/experiments/cache/codec.h"
#include "shapegauge/experiments/signatures/bench.h"

namespace shapegauge {

SHAPEGAUGE_MEMBERS(IndexedFile, id, path, bytes, modified, sha256, failure)
static auto members(IndexTable& table) { return std::tie(table.rows, table.columns); }
SHAPEGAUGE_MEMBERS(LocalScales, roots, least)
SHAPEGAUGE_MEMBERS(NearestModels, indices, distances, largest)
SHAPEGAUGE_MEMBERS(CollectionSum, scale, weights, units, local_scales, at_ranks)
SHAPEGAUGE_MEMBERS(ShapeIndex, collection, models, failures, tables, learnt, field_ranges, sum, nearest)

namespace {

constexpr std::string_view magic = "shapegauge search index ";
constexpr std::string_view format_line = "shapegauge search index 1\n";
constexpr std::size_t digits_of_sha256 = 64;
constexpr std::size_t header_size = format_line.size() + digits_of_sha256 + 1;

/// The tables follow the other data, each at a multiple of this from the file's beginning: read where they are.
constexpr std::size_t alignment = 64;

constexpr std::size_t aligned(std::size_t offset) { return (offset + alignment - 1) / alignment * alignment; }

std::size_t bytes_of(const IndexTable& table) {
  return static_cast<std::size_t>(table.rows * table.columns) * sizeof(float);
}

}  // namespace

IndexTable::IndexTable(Signatures table) : rows(table.rows()), columns(table.cols()) {
  const auto owned = std::make_shared<const Signatures>(std::move(table));
  entries = {owned, owned->data()};
}

std::string encode_index(const ShapeIndex& index, const std::string& key) {
  std::string bytes = fmt::format("{}{:0>{}}\n{}{}", format_line, "", digits_of_sha256, key, encode(encode(index)));
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
  codec::Decoder decoder(content.substr(key.size()));
  std::string data;
  decoder.take(data);
  auto index = decode<ShapeIndex>(data);
  std::size_t offset = header_size + key.size() + sizeof(std::size_t) + data.size();
  for (IndexTable& table : index.tables) {
    offset = aligned(offset);
    table.entries = {file.memory, reinterpret_cast<const float*>(file.bytes.data() + offset)};
    offset += bytes_of(table);
  }
  fault = IndexFault::none;
  return index;
}

void copy_tables_to_memory(ShapeIndex& index) {
  for (IndexTable& table : index.tables) table = IndexTable(table.signatures());
}

}  // namespace shapegauge
