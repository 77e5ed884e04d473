// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <map>

#include "shapegauge/experiments/cache/cache_folder.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/retrieval/run_experiment.h"
#include "tests/experiments/retrieval/published_retrieval.h"
#include "tests/support/small_dataset.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using test::text_of;
using test::write_text;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Numbers of cached and computed values of a run, by kind.
using Uses = std::map<std::string, std::pair<std::size_t, std::size_t>>;

Uses uses_of(const ExperimentResults& results) {
  Uses uses;
  for (const EntryKind kind : {EntryKind::shape, EntryKind::field, EntryKind::distances}) {
    const CacheUse& use = results.cache.uses.at(static_cast<std::size_t>(kind));
    uses[std::string(name_of(kind))] = {use.hits, use.computed};
  }
  return uses;
}

/// Runs over the small data set with two more fields: one of the offset surface that chooses its offset, at points of
/// the surface, and a conventional one at vertices. In all: 9 shapes, 3 fields each, 6 distance matrices.
class RunsThroughCache : public test::FolderTest {
 protected:
  void SetUp() override { test::write_small_dataset(data()); }

  [[nodiscard]] fs::path data() const { return at("data"); }
  [[nodiscard]] fs::path cache() const { return at("cache"); }

  [[nodiscard]] Json document() const {
    Json document = test::small_configuration(data());
    document["signatures"].push_back({{"name", "offset"},
                                      {"field", {{"type", "offset_sdf"}, {"offset", 0.1}, {"at", {{"surface", 100}}}}},
                                      {"histogram", {{"range", "per-shape"}}}});
    document["signatures"].push_back({{"name", "nine rays"},
                                      {"field", {{"type", "cone_sdf"}, {"rays", 9}, {"at", "vertices"}}},
                                      {"histogram", {{"range", {{"fixed", {0, 0.6}}}}, {"bins", 30}}}});
    return document;
  }
  ExperimentResults run(const Json& document, Cache& cache, int threads = 2) const {
    return run_experiment(configuration_from_json(document, "test.json", "."),
                          {.control = {.threads = threads}, .cache = cache, .generated = at("generated")}, {});
  }
  ExperimentResults run(const Json& document, int threads = 2) const {
    Cache used(cache());
    ExperimentResults results = run(document, used, threads);
    EXPECT_THAT(used.warnings(), IsEmpty());
    return results;
  }

  [[nodiscard]] std::map<std::string, std::string> files_of(const ExperimentResults& results) const {
    fs::remove_all(at("out"));
    test::publish(at("out"), results);
    return test::results_in(at("out"));
  }

  /// Results of a run without cache.
  [[nodiscard]] std::map<std::string, std::string> fresh_files(const Json& document) const {
    Cache none;
    return files_of(run(document, none));
  }
};

const Uses all_computed{{"shape", {0, 9}}, {"field", {0, 27}}, {"distances", {0, 6}}};
const Uses all_cached{{"shape", {9, 0}}, {"field", {27, 0}}, {"distances", {6, 0}}};

TEST_F(RunsThroughCache, ReuseAllResultsOfAnEarlierRunAndWriteTheSameBytes) {
  const auto fresh = fresh_files(document());
  EXPECT_GT(fresh.size(), 12U);
  const ExperimentResults cold = run(document());
  EXPECT_EQ(uses_of(cold), all_computed);
  EXPECT_EQ(files_of(cold), fresh);
  for (const int threads : {1, 3}) {
    const ExperimentResults warm = run(document(), threads);
    EXPECT_EQ(uses_of(warm), all_cached);
    EXPECT_EQ(files_of(warm), fresh);
  }
}

TEST_F(RunsThroughCache, WriteTheSameBytesWithAPartialCache) {
  const auto fresh = fresh_files(document());
  run(document());
  for (const EntryKind kind : {EntryKind::shape, EntryKind::samples, EntryKind::field, EntryKind::distances,
                               EntryKind::picture, EntryKind::view}) {
    for (const CacheFile& file : cache_files(cache())) {
      if (file.kind == kind) fs::remove(file.path);
    }
    EXPECT_EQ(files_of(run(document())), fresh) << name_of(kind);
    EXPECT_EQ(uses_of(run(document())), all_cached) << name_of(kind);
  }
  // Every third file, regardless of kind.
  std::size_t i = 0;
  for (const CacheFile& file : cache_files(cache())) {
    if (i++ % 3 == 0) fs::remove(file.path);
  }
  EXPECT_EQ(files_of(run(document())), fresh);
}

TEST_F(RunsThroughCache, DrawPicturesFromCachedFieldValues) {
  for (const char* signature : {"fixed", "offset", "nine rays"}) {
    SCOPED_TRACE(signature);
    Json pictured = document();
    pictured["report"]["pictures"]["of"] = signature;
    const auto fresh = fresh_files(pictured);
    run(document());
    const ExperimentResults drawn = run(pictured);
    EXPECT_EQ(uses_of(drawn), all_cached);
    EXPECT_EQ(files_of(drawn), fresh);
    const CacheUse pictures = run(pictured).cache.uses.at(static_cast<std::size_t>(EntryKind::picture));
    EXPECT_EQ(pictures.hits, 9U);
    EXPECT_EQ(pictures.computed, 0U);
  }
}

TEST_F(RunsThroughCache, ComputeModelViewsOnceFromCachedFieldValues) {
  const ExperimentResults first = run(document());
  ASSERT_EQ(first.views.size(), 9U);
  ASSERT_EQ(first.viewed.size(), 3U) << "one a field";
  EXPECT_EQ(first.viewed[0].name, "fixed");
  EXPECT_FALSE(first.viewed[1].colours) << "histograms with each model's own range";
  for (const CacheFile& file : cache_files(cache())) {
    if (file.kind == EntryKind::view) fs::remove(file.path);
  }
  const ExperimentResults again = run(document());
  EXPECT_EQ(uses_of(again), all_cached);
  EXPECT_EQ(again.views, first.views);
  const CacheUse views = run(document()).cache.uses.at(static_cast<std::size_t>(EntryKind::view));
  EXPECT_EQ(views.hits, 9U);
  EXPECT_EQ(views.computed, 0U);
}

TEST_F(RunsThroughCache, MakeNoModelViewsIfDisabledOrWithoutPictures) {
  for (const char* setting : {"views", "pictures"}) {
    Json without = document();
    without["report"][setting] = false;
    const ExperimentResults results = run(without);
    EXPECT_TRUE(results.views.empty() && results.viewed.empty()) << setting;
  }
}

TEST_F(RunsThroughCache, ReportAnAutomaticOffsetReadFromTheCache) {
  Json chosen = document();
  chosen["signatures"][4]["field"]["offset"] = "auto";
  run(chosen);
  const ExperimentResults warm = run(chosen);
  EXPECT_EQ(uses_of(warm), all_cached);
  EXPECT_TRUE(warm.shapes[0].fields[1].offset.has_value());
  EXPECT_EQ(files_of(warm), fresh_files(chosen));
}

TEST_F(RunsThroughCache, ReuseFieldsForOtherHistogramBinsRangesAndSmoothing) {
  run(document());
  Json changed = document();
  changed["signatures"][0]["histogram"]["range"]["fixed"] = {0, 0.5};
  changed["signatures"][1]["histogram"]["smoothing_bins"] = 2;
  changed["signatures"][4]["histogram"]["range"] = "dataset";
  changed["signatures"][5]["histogram"]["bins"] = 31;
  const ExperimentResults results = run(changed);
  EXPECT_EQ(uses_of(results).at("field"), (std::pair<std::size_t, std::size_t>{27, 0}));
  EXPECT_EQ(files_of(results), fresh_files(changed));
}

TEST_F(RunsThroughCache, ComputeOnlyAnAddedSignature) {
  Json fewer = document();
  fewer["signatures"].erase(5);
  run(fewer);
  const Uses expected{{"shape", {9, 0}}, {"field", {18, 9}}, {"distances", {5, 1}}};
  const ExperimentResults results = run(document());
  EXPECT_EQ(uses_of(results), expected);
  EXPECT_EQ(files_of(results), fresh_files(document()));
}

TEST_F(RunsThroughCache, ComputeOnlyAChangedModel) {
  run(document());
  write_text(data() / "T4.off", text_of(data() / "T7.off") + "\n");
  const ExperimentResults results = run(document());
  EXPECT_EQ(uses_of(results).at("shape"), (std::pair<std::size_t, std::size_t>{8, 1}));
  EXPECT_EQ(uses_of(results).at("field"), (std::pair<std::size_t, std::size_t>{24, 3}));
  EXPECT_EQ(files_of(results), fresh_files(document()));
}

TEST_F(RunsThroughCache, RecomputeAllResultsOnRequest) {
  run(document());
  Cache anew(cache(), true);
  EXPECT_EQ(uses_of(run(document(), anew)), all_computed);
  EXPECT_EQ(uses_of(run(document())), all_cached);
}

TEST_F(RunsThroughCache, StorePerturbedModelsSeparately) {
  Json noisy = document();
  noisy["perturbations"] = Json::parse(R"([{"type": "one_of", "assign": "in_turn", "choices": [
      [], [{"type": "vertex_noise", "amplitude": 0.01}]]}])");
  noisy["preparation"] = {{"denoise", true}};
  run(document());
  EXPECT_EQ(uses_of(run(noisy)), all_computed);
  const ExperimentResults warm = run(noisy);
  EXPECT_EQ(uses_of(warm), all_cached);
  EXPECT_EQ(files_of(warm), fresh_files(noisy));
}

TEST_F(RunsThroughCache, ReportTheFailuresOfTheEarlierRunAgain) {
  Json skipping = document();
  skipping["on_error"] = "skip";
  // A file that is no shape; a flat triangle without a conventional SDF.
  write_text(data() / "T3.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
  write_text(data() / "T6.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  Cache none;
  const ExperimentResults fresh = run(skipping, none);
  ASSERT_EQ(fresh.failures.size(), 1U);
  const std::vector<std::string> of_methods = incomplete_methods(fresh);
  ASSERT_FALSE(of_methods.empty());
  for (int i = 0; i < 2; ++i) {
    const ExperimentResults again = run(skipping);
    ASSERT_EQ(again.failures.size(), 1U);
    EXPECT_EQ(again.failures[0].id, "3");
    EXPECT_EQ(again.failures[0].message, fresh.failures[0].message);
    EXPECT_EQ(incomplete_methods(again), of_methods);
  }
  EXPECT_THAT(test::input_error_of([&] { run(document()); }), HasSubstr("model 3: "));
}

TEST_F(RunsThroughCache, RecomputeDamagedEntries) {
  const auto fresh = fresh_files(document());
  run(document());
  std::size_t i = 0;
  std::size_t damaged = 0;
  for (const CacheFile& file : cache_files(cache())) {
    if (file.kind == EntryKind::samples || file.kind == EntryKind::field || i++ % 2 != 0) continue;
    std::string bytes = text_of(file.path);
    const std::size_t at = i * 37 % bytes.size();
    bytes[at] = static_cast<char>(bytes[at] ^ 1);
    write_text(file.path, damaged++ % 2 == 0 ? bytes : bytes.substr(0, at));
  }
  ASSERT_GT(damaged, 5U);
  Cache used(cache());
  EXPECT_EQ(files_of(run(document(), used)), fresh);
  EXPECT_THAT(used.warnings(), ElementsAre(testing::AllOf(HasSubstr("damaged cache entry, recomputed: "),
                                                          HasSubstr(std::to_string(damaged - 1) + " others"))));
  EXPECT_EQ(uses_of(run(document())), all_cached);
}

}  // namespace

}  // namespace shapegauge
