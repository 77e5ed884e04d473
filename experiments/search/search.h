#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/search/collection.h"
#include "shapegauge/experiments/search/search_method.h"
#include "shapegauge/experiments/search/shape_index.h"
#include "shapegauge/retrieval/diffusion.h"

/// Searches: which shapes of a collection are like this one (docs/manual/search.md).

namespace shapegauge {

/// What opening an index did.
struct IndexUpdate {
  bool rebuilt = false;                ///< the collection was described, and the index written
  std::vector<LeftOutShape> left_out;  ///< files that are new or changed and cannot be described
  std::vector<std::string> notes;      ///< what the user should know, a sentence each
};

/// A collection with its index, ready for queries.
struct OpenIndex {
  SearchMethod method;
  Collection collection;
  std::filesystem::path file;  ///< of the index
  ShapeIndex contents;
};

/// Opens the index of a collection. The index is in `file`; where it is absent, damaged, of another method or program,
/// or of files that have changed since, the collection is described first and the index written anew, whole or not at
/// all. Files count as unchanged while their size and time of change are, else their contents are compared. Shapes that
/// cannot be described are left out. What the cache holds is taken from it, and an interrupted description goes on from
/// there. The contents depend on the files and the method only, not on how they came about. Where the index cannot be
/// written, a note says so. Throws InputError where no shape can be described, and Interrupted.
OpenIndex open_index(SearchMethod method, const std::filesystem::path& collection, const std::filesystem::path& file,
                     const RunControl& control, Cache& cache, IndexUpdate& update);

/// The index in a file as it is, without a look at the collection's files. Of its collection only the base is known.
/// Throws InputError where it cannot be used.
OpenIndex open_index_as_it_is(SearchMethod method, const std::filesystem::path& collection,
                              const std::filesystem::path& file);

/// A shape to find others for.
struct SearchQuery {
  std::string name;
  std::filesystem::path file;  ///< empty: `shape` is given
  std::optional<Shape> shape = {};
};

/// What is wanted of a search.
struct SearchOptions {
  std::size_t count = 10;
  bool rerank = false;  ///< by diffusion over the collection and the query
};

/// The answer to one query.
struct SearchAnswer {
  std::string query;
  std::optional<std::size_t> member;  ///< the model that the query is itself, which the answer leaves out
  std::vector<RankedModel> nearest;   ///< models of the index, nearest first; of equal distances the lesser index first
  std::string failure = {};           ///< why there is no answer; empty where there is
};

/// Answers queries, each by itself. A query that is a file of the collection, or has the same contents as one, is not
/// described again; the answer to a file of the collection has the distances of a run. Of another shape, its own scales
/// follow from its nearest (sum_row()), weights and scales of the collection stay as they are. A query that cannot be
/// described is answered by a failure. The first re-ranked answers find the neighbours of all models, which the index
/// then keeps; a note says where it cannot. Throws Interrupted.
std::vector<SearchAnswer> search(OpenIndex& index, std::span<const SearchQuery> queries, const SearchOptions& options,
                                 const RunControl& control, Cache& cache, std::vector<std::string>& notes);

}  // namespace shapegauge
