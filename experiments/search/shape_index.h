// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/retrieval/collection_sum.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/retrieval/histogram.h"
#include "shapegauge/retrieval/nearest_models.h"

namespace shapegauge {

/// State of a shape file of a collection when its index was made.
struct IndexedFile {
  std::string id;           ///< id of the shape
  std::string path;         ///< path of the file; relative to Collection::base for a file below it
  std::uint64_t bytes = 0;  ///< size of the file in bytes
  std::int64_t modified =
      0;  ///< modification time in ticks of the file clock; 0 if too recent to show that the contents are unchanged
  std::string sha256;        ///< SHA-256 of the file; empty if it could not be read
  std::string failure = {};  ///< reason why the shape has no signatures; empty if it has them
};

/// Table of signatures, one row per model, in memory or in a memory-mapped index file.
struct IndexTable {
  IndexTable() = default;
  explicit IndexTable(Signatures table);  ///< moves signatures to memory that the table owns

  /// Returns a view of the signatures (models x features), valid during the lifetime of the table.
  [[nodiscard]] Eigen::Map<const Signatures> signatures() const { return {entries.get(), rows, columns}; }

  std::shared_ptr<const float> entries;  ///< features in row-major order; owns the memory or the mapping of the file
  Eigen::Index rows = 0;                 ///< number of models
  Eigen::Index columns = 0;              ///< number of features of a signature
};

/// Index of a collection of shapes: all signatures and statistics needed to answer queries.
struct ShapeIndex {
  std::string collection;              ///< absolute path of the collection when the index was written
  std::vector<IndexedFile> models;     ///< files of shapes with signatures, in natural order of ids
  std::vector<IndexedFile> failures;   ///< files of shapes without signatures
  std::vector<IndexTable> tables;      ///< per SearchMethod::terms: table whose row i is the signature of models[i]
  std::vector<LearntFeatures> learnt;  ///< per signature of the method: features learnt from the collection, if any
  std::vector<Interval> field_ranges;  ///< per field of distinct_fields(): interval of its values in the collection
  CollectionSum sum;                   ///< statistics of the sum of the terms' distances
  NearestModels nearest;               ///< nearest other models of each model; empty before the first re-ranked search
};

/// Encodes an index as the bytes of a file: a line with the format, a line with the SHA-256 of the rest, and the data,
/// which only programs of the same build and processor type read. `key` is SearchMethod::key().
std::string encode_index(const ShapeIndex& index, const std::string& key);

/// Returns true if a file with these leading bytes is an index, of this or another version of the format.
bool begins_as_index(std::string_view bytes);

/// Reason why an index file is unusable; `none` for a usable one.
enum class IndexFault { none, damaged, other_method };

/// Decodes an index from a memory-mapped file, to which its tables refer. Returns nothing, and the reason in `fault`,
/// if the file is corrupt or of another method. `key` is SearchMethod::key().
std::optional<ShapeIndex> decode_index(const MappedBytes& file, const std::string& key, IndexFault& fault);

/// Copies the tables of an index into memory, so that they do not depend on the index file.
void copy_tables_to_memory(ShapeIndex& index);

}  // namespace shapegauge
