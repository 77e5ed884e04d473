// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/search/search.h"
#include "tests/support/small_dataset.h"
#include "tests/support/test_files.h"

/// Folder of small shapes, with search methods and an index.
namespace shapegauge::test {

class SearchedFolder {
 public:
  SearchedFolder() { write_small_dataset(models()); }

  [[nodiscard]] std::filesystem::path models() const { return folder_.path() / "models"; }
  [[nodiscard]] std::filesystem::path at(const std::string& name) const { return folder_.path() / name; }
  [[nodiscard]] std::filesystem::path index() const { return at("models.search-index"); }

  void add(const std::string& name, const std::string& shape, int number) const {
    write_off(models() / name, small_shape(shape, number));
  }

  /// Retrieval experiment on the folder: histograms, a trained descriptor, sums and a re-ranked sum.
  [[nodiscard]] nlohmann::json configuration() const {
    using Json = nlohmann::json;
    const Json cone{{"type", "cone_sdf"}, {"rays", 5}};
    Json document{{"name", "small"},
                  {"dataset", {{"layout", "shrec11"}, {"root", models().string()}, {"classification", "test.cla"}}},
                  {"report", false}};
    document["signatures"] = {
        {{"name", "own range"}, {"field", cone}, {"histogram", {{"bins", 16}, {"range", "per-shape"}}}},
        {{"name", "range of all"}, {"field", cone}, {"histogram", {{"bins", 16}, {"range", "dataset"}}}},
        {{"name", "both"}, {"concatenate", {"own range", "range of all"}}},
        {{"name", "bag"},
         {"descriptor", {{"type", "bag_of_features"}, {"words", 6}, {"standardise", true}, {"fields", {cone}}}}},
        {{"name", "d2"}, {"descriptor", {{"type", "d2"}}}},
        {{"name", "median"}, {"sum", {{{"of", "both"}}, {{"of", "d2"}, {"weight", 0.5}}}}},
        {{"name", "mutual ranks"}, {"sum", {{{"of", "both"}}, {{"of", "d2"}}}}, {"scale", "ranks"}},
        {{"name", "local"},
         {"sum", {{{"of", "range of all"}}, {{"of", "bag"}}, {{"of", "d2"}}}},
         {"scale", "local"},
         {"weights", "agreement"}},
        {{"name", "ranks"}, {"fuse_ranks", {"both", "d2"}}},
        {{"name", "diffused"}, {"rerank", {{"of", "local"}, {"method", "diffusion"}, {"neighbours", {2, 3}}}}},
    };
    return document;
  }

  SearchMethod method(const std::string& signature = "local") const {
    return search_method(configuration(), "small.json", signature);
  }

  OpenIndex open(IndexUpdate& update, const std::string& signature = "local") const {
    Cache cache(at("cache"));
    return open_index(method(signature), models(), index(), {}, cache, update);
  }

  OpenIndex open(const std::string& signature = "local") const {
    IndexUpdate update;
    return open(update, signature);
  }

  /// Results for a query file.
  SearchAnswer answer(OpenIndex& index, const std::filesystem::path& file, const SearchOptions& options = {}) const {
    Cache cache(at("cache"));
    std::vector<std::string> notes;
    const std::vector<SearchQuery> queries{{.name = file.filename().string(), .file = file}};
    return search(index, queries, options, {}, cache, notes).front();
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace shapegauge::test
