// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/search/collection.h"
#include "shapegauge/experiments/search/search_method.h"
#include "shapegauge/experiments/search/shape_index.h"
#include "shapegauge/retrieval/diffusion.h"

/// Search for similar shapes in a collection (docs/manual/search.md).

namespace shapegauge {

/// Changes that opening an index made, and notes for users.
struct IndexUpdate {
  bool rebuilt = false;                ///< true if an unusable or outdated index was computed again
  std::vector<LeftOutShape> left_out;  ///< new or changed shape files without a signature, with the reasons
  std::vector<std::string> notes;      ///< notes for users, one sentence each
};

/// Collection of shapes with its search index, for search().
struct OpenIndex {
  SearchMethod method;         ///< search method that the index was computed with
  Collection collection;       ///< shape files of the collection
  std::filesystem::path file;  ///< path of the index file
  ShapeIndex contents;         ///< signatures of the shapes and statistics of the collection
};

/// Opens the index `file` of a collection. If it is absent, damaged, of another method or program, or out of date,
/// first describes the changed files and writes the index atomically. Files are unchanged if their size and
/// modification time are, or else their contents. Shapes that cannot be described are omitted. Uses the cache, from
/// which an interrupted description continues. The contents depend only on the files and the method. If the index
/// cannot be written, adds a note. Throws InputError if `file` exists and is neither an index nor empty, or is the
/// index of another collection: of another location, with none of the files. Throws InputError if no shape can be
/// described, and Interrupted.
OpenIndex open_index(SearchMethod method, const std::filesystem::path& collection, const std::filesystem::path& file,
                     const RunControl& control, Cache& cache, IndexUpdate& update);

/// Opens an index without reading the files of the collection. Throws InputError for an unusable index, and for one
/// that was made in another folder and shares no file, by name and size, with `collection`.
OpenIndex open_index_without_update(SearchMethod method, const std::filesystem::path& collection,
                                    const std::filesystem::path& file);

/// Query of a search: a shape file, or a shape in memory.
struct SearchQuery {
  std::string name;                 ///< name of the query in the answer
  std::filesystem::path file;       ///< shape file; if empty, the query is `shape`
  std::optional<Shape> shape = {};  ///< query in memory; none if the query is a file
};

/// Options of a search: number of results and re-ranking.
struct SearchOptions {
  std::size_t count = 10;  ///< number of results per query
  bool rerank = false;     ///< true to re-rank by diffusion over the collection and the query
};

/// Parameters of SearchOptions.
inline constexpr std::array search_table = {
    option_of<&SearchOptions::count>("count", {.low = 1, .high = 1'000'000}, "Number of results per query."),
    option_of<&SearchOptions::rerank>("rerank", "Re-rank results by diffusion over the collection's distances."),
};

/// Answer to one query: the nearest models of the collection with their distances, or the reason of a failure.
struct SearchAnswer {
  std::string query;                  ///< name of the query (SearchQuery::name)
  std::optional<std::size_t> member;  ///< index of the model that is the query, left out of the answer; absent if none
  std::vector<RankedModel> nearest;   ///< models of the index, nearest first (ties: smaller index first)
  double median = 0;         ///< median distance from the query to the models of the collection; 0 if re-ranked
  std::string failure = {};  ///< reason why the query has no answer; empty if it has one
};

/// Answers queries independently. A query that is a file of the collection, or has the same contents as one, is not
/// described again; its answer has the distances of a retrieval experiment. The local scales of any other query follow
/// from its nearest models (sum_row()); weights and scales of the collection stay unchanged. A query that cannot be
/// described gets a failure. The first re-ranked search computes the neighbours of all models and stores them in the
/// index; if that fails, adds a note. Throws Interrupted.
std::vector<SearchAnswer> search(OpenIndex& index, std::span<const SearchQuery> queries, const SearchOptions& options,
                                 const RunControl& control, Cache& cache, std::vector<std::string>& notes);

}  // namespace shapegauge
