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

/// State of a collection's file when it was described.
struct IndexedFile {
  std::string id;
  std::string path;  ///< CollectionFile::path
  std::uint64_t bytes = 0;
  std::int64_t modified =
      0;               ///< in ticks of the file clock; 0 for a file so new that its contents must be checked again
  std::string sha256;  ///< empty if it could not be read
  std::string failure = {};  ///< reason why it could not be described; otherwise empty
};

/// Signatures in memory of their own, or in that of an index file.
struct IndexTable {
  IndexTable() = default;
  explicit IndexTable(Signatures own);

  [[nodiscard]] Eigen::Map<const Signatures> signatures() const { return {entries.get(), rows, columns}; }

  std::shared_ptr<const float> entries;  ///< row by row; keeps the memory that they are in
  Eigen::Index rows = 0;
  Eigen::Index columns = 0;
};

/// Index of a collection for answering queries.
struct ShapeIndex {
  std::string collection;              ///< collection_location() when the index was written
  std::vector<IndexedFile> models;     ///< described files, in natural order of ids
  std::vector<IndexedFile> failures;   ///< the other files
  std::vector<IndexTable> tables;      ///< per term of the method: row i is of models[i]
  std::vector<LearntFeatures> learnt;  ///< per signature of the method's configuration
  std::vector<Interval> field_ranges;  ///< by planned field, over the collection
  CollectionSum sum;
  NearestModels nearest;  ///< of the models by the sum; empty before the first re-ranked search
};

/// Encodes an index as the bytes of a file: a line with the format, a line with the SHA-256 of the rest, and the data,
/// which only programs of the same build and processor type read. `key` is SearchMethod::key().
std::string encode_index(const ShapeIndex& index, const std::string& key);

/// Returns true if a file with these leading bytes is an index, of this or another version of the format.
bool begins_as_index(std::string_view bytes);

/// Reason why an index file is unusable.
enum class IndexFault { none, damaged, other_method };

/// Decodes an index, whose tables remain where the bytes are. Nothing if it is corrupt or of another method.
std::optional<ShapeIndex> decode_index(const MappedBytes& file, const std::string& key, IndexFault& fault);

/// Copies the tables into memory, so that they do not depend on the index file.
void keep_in_memory(ShapeIndex& index);

}  // namespace shapegauge
