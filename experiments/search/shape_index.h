#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/retrieval/collection_sum.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/retrieval/histogram.h"
#include "shapegauge/retrieval/nearest_models.h"

namespace shapegauge {

/// A file of a collection as it was when it was described.
struct IndexedFile {
  std::string id;
  std::string path;  ///< CollectionFile::path
  std::uint64_t bytes = 0;
  std::int64_t modified = 0;  ///< in ticks of the file clock; 0: so young that its contents have to be looked at again
  std::string sha256;         ///< empty: it could not be read
  std::string failure = {};   ///< why it could not be described; empty where it is
};

/// All that answers need to know of a collection: a few kilobytes a shape.
struct ShapeIndex {
  std::vector<IndexedFile> models;     ///< those described, in natural order of their ids
  std::vector<IndexedFile> failures;   ///< the others
  std::vector<Signatures> tables;      ///< by term of the method, row i is of models[i]
  std::vector<LearntFeatures> learnt;  ///< by planned descriptor of the method's configuration
  std::vector<Interval> field_ranges;  ///< by planned field, over the collection
  CollectionSum sum;
  NearestModels nearest;  ///< of the models by the sum; empty until answers are re-ranked
};

/// The index as the bytes of a file: a line that names the format, one with the SHA-256 of the rest, and that, which
/// only programs of the same build and kind of processor read. `key`: SearchMethod::key().
std::string encode_index(const ShapeIndex& index, const std::string& key);

/// Why the bytes of a file are no index that can be used.
enum class IndexFault { none, damaged, other_method };

/// The index in the bytes of a file. Nothing where a byte of it is not what was written, or it is of another method.
std::optional<ShapeIndex> decode_index(std::string_view bytes, const std::string& key, IndexFault& fault);

}  // namespace shapegauge
