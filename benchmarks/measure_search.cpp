// SPDX-License-Identifier: GPL-3.0-or-later
// measure_search COLLECTION MODELS [FOLDER]: run times of an index of MODELS models. The models of a described
// collection are multiplied: each copy's features are moved towards those of another model, by a random fraction.
// FOLDER: only plain answers, with the scales that the models have in the collection, for numbers whose pairs take
// hours. The new folder gets a link to the file of each model, and the index, for queries by the command line.
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <string>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/experiments/cache/cache_folder.h"
#include "shapegauge/experiments/search/index_rows.h"
#include "shapegauge/experiments/search/search.h"

namespace {

using namespace shapegauge;

ShapeIndex multiplied(const ShapeIndex& few, std::size_t models) {
  RandomNumbers random(1);
  ShapeIndex many;
  many.learnt = few.learnt;
  many.field_ranges = few.field_ranges;
  const auto rows = static_cast<Eigen::Index>(models);
  std::vector<Signatures> tables;
  for (const IndexTable& table : few.tables) tables.emplace_back(rows, table.columns);
  for (std::size_t i = 0; i < models; ++i) {
    const std::size_t of = i % few.models.size();
    IndexedFile model = few.models[of];
    if (i != of) {
      model.id += fmt::format("-{}", i);
      model.path += fmt::format("-{}", i);
      model.sha256[0] = 'x';
    }
    many.models.push_back(model);
    const auto other = static_cast<Eigen::Index>(random.below(few.models.size()));
    const auto part = static_cast<float>(i == of ? 0 : random.uniform(0, 0.5));
    for (std::size_t k = 0; k < tables.size(); ++k) {
      const auto table = few.tables[k].signatures();
      tables[k].row(static_cast<Eigen::Index>(i)) =
          (1 - part) * table.row(static_cast<Eigen::Index>(of)) + part * table.row(other);
    }
  }
  for (Signatures& table : tables) many.tables.emplace_back(std::move(table));
  return many;
}

/// Local scales and ranks of the models copied, as if there were no more models.
CollectionSum multiplied(CollectionSum sum, Eigen::Index models) {
  for (LocalScales& scales : sum.local_scales) {
    const Eigen::VectorXd few = scales.roots;
    scales.roots = Eigen::VectorXd::NullaryExpr(models, [&](Eigen::Index i) { return few[i % few.size()]; });
  }
  for (DistanceMatrix& at_ranks : sum.at_ranks) {
    const DistanceMatrix few = at_ranks;
    at_ranks = DistanceMatrix::Constant(models, sampled_rank_count(models), std::numeric_limits<double>::infinity());
    for (Eigen::Index i = 0; i < models; ++i) at_ranks.row(i).head(few.cols()) = few.row(i % few.rows());
  }
  return sum;
}

/// Makes a folder with a link for each model, whose index is that of the folder then.
void link_models(OpenIndex& index, const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  fs::create_directory(folder);
  std::vector<IndexedFile>& models = index.contents.models;
  const std::size_t originals = index.collection.files.size();
  for (std::size_t i = 0; i < models.size(); ++i) {
    const fs::path file = index.collection.file(index.collection.files[i % originals].path);
    fs::create_hard_link(file, folder / fmt::format("{:06}{}", i, file.extension().string()));
  }
  index.collection = find_collection(folder);
  for (std::size_t i = 0; i < models.size(); ++i) {
    const CollectionFile& file = index.collection.files[i];
    models[i] = {.id = file.id, .path = file.path.generic_string(), .sha256 = ""};
    models[i].bytes = fs::file_size(index.collection.file(file.path));
    models[i].sha256 = sha256_of_file(index.collection.file(file.path));
  }
  index.file = default_index_path(folder);
}

/// Run times, on the clock and of all processors: on a busy machine the latter are more meaningful.
struct Timer {
  void start() {
    stopwatch.lap();
    processor_start = std::clock();
  }

  /// Prints the times since the start or the last report.
  void report(const std::string& what) {
    const double processor = static_cast<double>(std::clock() - processor_start) / CLOCKS_PER_SEC;
    fmt::print("{:<44}{:8.3f} s, {:8.3f} s of processors\n", what, stopwatch.lap(), processor);
    start();
  }

  Stopwatch stopwatch;
  std::clock_t processor_start = std::clock();
};

/// Replaces the index by one of the models multiplied, written to a file and read again.
void multiply_index(OpenIndex& index, std::size_t models, const std::filesystem::path& folder, Timer& timer) {
  const bool answers_only = !folder.empty();
  const CollectionSum sum = multiplied(index.contents.sum, static_cast<Eigen::Index>(models));
  index.contents = multiplied(index.contents, models);
  fmt::print("{} models\n", models);
  timer.start();
  index.contents.sum = answers_only ? sum : sum_of(index.method, index.contents, {});
  if (!answers_only) timer.report("scales and weights of all pairs");
  index.file = std::filesystem::temp_directory_path() / "measure_search.index";
  if (answers_only) link_models(index, folder);
  write_file_atomically(index.file, encode_index(index.contents, index.method.key()));
  fmt::print("index: {:.1f} kB a model\n",
             static_cast<double>(std::filesystem::file_size(index.file)) / 1000 / static_cast<double>(models));
  timer.start();
  IndexFault fault{};
  index.contents = decode_index(map_file(index.file), index.method.key(), fault).value();
  timer.report("read the index");
  if (!answers_only) std::filesystem::remove(index.file);
}

int measure(const std::filesystem::path& collection, std::size_t models, const std::filesystem::path& folder) {
  Cache cache(default_cache_folder());
  IndexUpdate update;
  const RunControl control;
  OpenIndex index =
      open_index(recommended_search_method(), collection, default_index_path(collection), control, cache, update);
  Timer timer;
  multiply_index(index, models, folder, timer);
  const std::vector<SearchQuery> query{
      {.name = "query", .file = index.collection.file(index.contents.models.front().path)}};
  const auto answer = [&](const SearchOptions& options, const std::string& what) {
    std::vector<std::string> notes;
    search(index, query, options, control, cache, notes);
    timer.report(what);
  };
  answer({}, "answer to a member");
  if (!folder.empty()) return EXIT_SUCCESS;
  index.contents.nearest = nearest_models_in_index(index.method, index.contents, 20, control);
  timer.report("neighbours of all models, for re-ranking");
  answer({.rerank = true}, "re-ranked answer to a member");
  index.contents.models.front().sha256[0] = 'x';  // the same file is now one from elsewhere
  timer.start();
  answer({}, "answer to another file, described before");
  answer({.rerank = true}, "re-ranked answer to it");
  return EXIT_SUCCESS;
}

}  // namespace

int main(int count, char** arguments) try {
  if (count < 3) {
    fmt::print(stderr, "measure_search COLLECTION MODELS [FOLDER]\n");
    return EXIT_FAILURE;
  }
  return measure(arguments[1], std::stoul(arguments[2]), count > 3 ? arguments[3] : "");
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return EXIT_FAILURE;
}
