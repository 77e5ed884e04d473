// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/experiments/search/index_rows.h"
#include "shapegauge/experiments/search/search.h"
#include "shapegauge/experiments/signatures/compute_signatures.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

/// Age below which a file may change again within one tick of its clock.
constexpr std::chrono::seconds too_young{2};

IndexedFile state_of(const Collection& collection, const CollectionFile& file) {
  IndexedFile state{.id = file.id, .path = file.path.generic_string(), .sha256 = ""};
  std::error_code failure;
  const fs::path path = collection.file(file.path);
  state.bytes = fs::file_size(path, failure);
  if (failure) state.bytes = 0;
  const fs::file_time_type modified = fs::last_write_time(path, failure);
  if (!failure && modified < fs::file_time_type::clock::now() - too_young) {
    state.modified = static_cast<std::int64_t>(modified.time_since_epoch().count());
  }
  return state;
}

/// Returns the present state of the files; skips the contents of those whose size and time match the index.
std::vector<IndexedFile> states_of(const Collection& collection, const ShapeIndex* before) {
  std::map<std::string, const IndexedFile*> known;
  if (before != nullptr) {
    for (const auto* files : {&before->models, &before->failures}) {
      for (const IndexedFile& file : *files) known.emplace(file.path, &file);
    }
  }
  std::vector<IndexedFile> states(collection.files.size());
  parallel_for(std::size_t{0}, states.size(), [&](std::size_t i) {
    IndexedFile& state = states[i];
    state = state_of(collection, collection.files[i]);
    const auto same = known.find(state.path);
    if (same != known.end() && state.modified != 0 && same->second->modified == state.modified &&
        same->second->bytes == state.bytes) {
      state.sha256 = same->second->sha256;
      return;
    }
    try {
      state.sha256 = sha256_of_file(collection.file(collection.files[i].path));
    } catch (const InputError&) {
      state.sha256.clear();  // the reason is reported when it is described
    }
  });
  return states;
}

/// Returns the data of files that determines the contents of an index.
std::vector<std::pair<std::string, std::string>> contents_of(const std::vector<IndexedFile>& files) {
  std::vector<std::pair<std::string, std::string>> contents;
  contents.reserve(files.size());
  for (const IndexedFile& file : files) contents.emplace_back(file.id, file.path + " " + file.sha256);
  return contents;
}

bool is_of(const ShapeIndex& index, const std::vector<IndexedFile>& files) {
  auto indexed = contents_of(index.models);
  const auto failures = contents_of(index.failures);
  indexed.insert(indexed.end(), failures.begin(), failures.end());
  auto current = contents_of(files);
  std::ranges::sort(indexed);
  std::ranges::sort(current);
  return indexed == current;
}

[[noreturn]] void fail_as_foreign(const ShapeIndex& index, const fs::path& file, const std::string& location) {
  throw InputError(fmt::format("{} is the index of {}, none of whose files is in {}; name another file for the index",
                               file.string(), index.collection, location));
}

/// Throws InputError for the index of another collection: one of another location that has none of the files. A moved
/// collection has them, and one at the same location may have changed as a whole.
void check_collection(const ShapeIndex& index, const fs::path& file, const std::string& location,
                      const std::vector<IndexedFile>& files) {
  if (index.collection == location) return;
  const std::vector<std::pair<std::string, std::string>> present = contents_of(files);
  const std::set<std::pair<std::string, std::string>> known(present.begin(), present.end());
  for (const auto* indexed : {&index.models, &index.failures}) {
    for (const auto& contents : contents_of(*indexed)) {
      if (known.contains(contents)) return;
    }
  }
  fail_as_foreign(index, file, location);
}

/// Likewise without the contents of the files: those of the same name and size count.
void check_collection(const OpenIndex& index, const std::string& location) {
  if (index.contents.collection == location) return;
  for (const auto* indexed : {&index.contents.models, &index.contents.failures}) {
    for (const IndexedFile& file : *indexed) {
      std::error_code absent;
      if (fs::file_size(index.collection.file(file.path), absent) == file.bytes && !absent) return;
    }
  }
  fail_as_foreign(index.contents, index.file, location);
}

/// Updates the location, sizes and times; returns whether any changed.
bool take_state(ShapeIndex& index, const std::string& location, const std::vector<IndexedFile>& files) {
  std::map<std::string, const IndexedFile*> now;
  for (const IndexedFile& file : files) now.emplace(file.path, &file);
  bool changed = index.collection != location;
  index.collection = location;
  for (auto* indexed : {&index.models, &index.failures}) {
    for (IndexedFile& file : *indexed) {
      const IndexedFile& state = *now.at(file.path);
      changed = changed || file.modified != state.modified || file.bytes != state.bytes;
      file.modified = state.modified;
      file.bytes = state.bytes;
    }
  }
  return changed;
}

Dataset dataset_of(const Collection& collection) {
  Dataset dataset{.models = {}, .classes = {"all"}};
  for (const CollectionFile& file : collection.files) {
    dataset.models.push_back({.id = file.id, .file = collection.file(file.path), .label = 0});
  }
  return dataset;
}

/// Returns the rows of the models with all signatures; the others become failures.
std::vector<Eigen::Index> complete_models(ComputedSignatures& computed) {
  std::map<std::size_t, std::string> incomplete;
  for (const std::vector<ModelFailure>& without : computed.without) {
    for (const ModelFailure& failure : without) incomplete.emplace(failure.model, failure.message);
  }
  std::vector<Eigen::Index> complete;
  for (std::size_t row = 0; row < computed.models.size(); ++row) {
    const auto found = incomplete.find(row);
    if (found == incomplete.end()) {
      complete.push_back(static_cast<Eigen::Index>(row));
    } else {
      computed.failures.push_back({.model = computed.models[row], .message = found->second});
    }
  }
  std::ranges::sort(computed.failures, {}, &ModelFailure::model);
  return complete;
}

/// Describes the collection. Shapes without one of the method's signatures are failures.
ShapeIndex described(const SearchMethod& method, const Collection& collection, std::vector<IndexedFile> files,
                     const RunControl& control, Cache& cache) {
  ComputedSignatures computed =
      compute_signatures(dataset_of(collection), method.configuration, {.control = control, .cache = cache});
  const std::vector<Eigen::Index> complete = complete_models(computed);
  if (complete.empty()) {
    throw InputError(fmt::format("none of {} shapes has all signatures of the method; the first is {}: {}",
                                 files.size(), files.front().id, computed.failures.front().message));
  }
  ShapeIndex index;
  for (const Eigen::Index row : complete) {
    index.models.push_back(files[computed.models[static_cast<std::size_t>(row)]]);
  }
  for (const ModelFailure& failure : computed.failures) {
    index.failures.push_back(std::move(files[failure.model]));
    index.failures.back().failure = failure.message;
  }
  index.learnt = std::move(computed.learnt);
  index.field_ranges = std::move(computed.field_ranges);
  for (const std::size_t term : method.terms) {
    Signatures& table = computed.signatures[term];
    const bool all = std::ssize(complete) == table.rows();
    index.tables.emplace_back(all ? std::move(table) : Signatures(table(complete, Eigen::all)));
  }
  index.sum = sum_of(method, index, control);
  return index;
}

/// Returns the failures that an earlier index does not have.
std::vector<LeftOutShape> new_failures(const ShapeIndex& index, const ShapeIndex* before) {
  std::vector<LeftOutShape> left_out;
  for (const IndexedFile& file : index.failures) {
    const bool known = before != nullptr && std::ranges::any_of(before->failures, [&](const IndexedFile& one) {
                         return one.path == file.path && one.sha256 == file.sha256;
                       });
    if (!known) left_out.push_back({.id = file.id, .message = file.failure});
  }
  return left_out;
}

/// Throws InputError if the file is neither an index nor empty: only those may be overwritten.
void check_is_index(const fs::path& file) {
  constexpr std::size_t enough = 64;
  std::error_code failure;
  if (fs::is_empty(file, failure) || begins_as_index(read_file_bytes(file, enough))) return;
  throw InputError(
      fmt::format("{} is not an index and is not overwritten; name another file for the index", file.string()));
}

std::optional<ShapeIndex> read_index(const fs::path& file, const std::string& key, std::vector<std::string>& notes) {
  std::error_code absent;
  if (!fs::exists(file, absent)) return std::nullopt;
  check_is_index(file);
  IndexFault fault = IndexFault::damaged;
  try {
    if (auto index = decode_index(map_file(file), key, fault)) return index;
  } catch (const InputError&) {  // empty, or not to be read
  }
  notes.push_back(fmt::format("{} is {} and is rebuilt", file.string(),
                              fault == IndexFault::damaged ? "damaged" : "of another method or program"));
  return std::nullopt;
}

}  // namespace

void write_index(const OpenIndex& index, std::vector<std::string>& notes) {
  try {
    write_file_atomically(index.file, encode_index(index.contents, index.method.key()));
  } catch (const InputError& error) {
    notes.push_back(fmt::format("the index could not be written: {}; choose another file with `index`", error.what()));
  }
}

OpenIndex open_index(SearchMethod method, const fs::path& collection, const fs::path& file, const RunControl& control,
                     Cache& cache, IndexUpdate& update) {
  OpenIndex index{.method = std::move(method), .collection = find_collection(collection), .file = file, .contents = {}};
  std::error_code absent;
  if (fs::is_directory(file, absent))
    throw InputError(fmt::format("{} is a folder; the index must be a file", file.string()));
  std::optional<ShapeIndex> before = read_index(file, index.method.key(), update.notes);
  const std::string location = collection_location(collection);
  with_threads(control, [&] {
    std::vector<IndexedFile> files = states_of(index.collection, before ? &*before : nullptr);
    if (before) check_collection(*before, file, location, files);
    if (before && is_of(*before, files)) {
      index.contents = std::move(*before);
      if (take_state(index.contents, location, files)) write_index(index, update.notes);
      return;
    }
    index.contents = described(index.method, index.collection, std::move(files), control, cache);
    index.contents.collection = location;
    update.rebuilt = true;
    update.left_out = new_failures(index.contents, before ? &*before : nullptr);
    write_index(index, update.notes);
  });
  return index;
}

OpenIndex open_index_without_update(SearchMethod method, const fs::path& collection, const fs::path& file) {
  OpenIndex index{.method = std::move(method), .collection = {}, .file = file, .contents = {}};
  IndexFault fault = IndexFault::damaged;
  std::optional<ShapeIndex> contents = decode_index(map_file(file), index.method.key(), fault);
  if (!contents) {
    throw InputError(fmt::format("{} is {}; rebuild it by searching without `update=false`", file.string(),
                                 fault == IndexFault::damaged ? "damaged" : "of another method or program"));
  }
  index.contents = std::move(*contents);
  index.collection.base = collection_base(collection);
  check_collection(index, collection_location(collection));
  return index;
}

}  // namespace shapegauge
