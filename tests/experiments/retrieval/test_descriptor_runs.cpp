// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <limits>
#include <map>

#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/retrieval/run_experiment.h"
#include "shapegauge/retrieval/descriptors/d2.h"
#include "shapegauge/retrieval/descriptors/joint_histogram.h"
#include "shapegauge/retrieval/diffusion.h"
#include "shapegauge/retrieval/fusion.h"
#include "tests/experiments/retrieval/published_retrieval.h"
#include "tests/support/small_dataset.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using test::text_of;

/// Runs over the small data set with descriptors of each kind: of the shape (d2), of fields (joint), of fields and all
/// that the data set has (bag), and what is made of their distances.
class DescriptorRuns : public test::FolderTest {
 protected:
  void SetUp() override { test::write_small_dataset(data()); }

  [[nodiscard]] fs::path data() const { return at("data"); }

  [[nodiscard]] Json document() const {
    Json document = test::small_configuration(data());
    const Json more = Json::parse(R"([
      {"name": "again", "rerank": {"of": "sum", "method": "diffusion", "neighbours": 2}},
      {"name": "sum", "sum": [{"of": "d2"}, {"of": "joint", "weight": 0.5}, {"of": "fixed"}]},
      {"name": "d2", "descriptor": {"type": "d2", "points": 64, "bins": 8}},
      {"name": "joint", "descriptor": {"type": "joint_histogram",
        "fields": [{"type": "cone_sdf"}, {"type": "centricity", "sources": 8}],
        "axes": [{"bins": 4, "high": 0.6}, {"bins": 4, "divide_by_mean": true, "high": 2}]}},
      {"name": "bag", "descriptor": {"type": "bag_of_features", "words": 5,
        "fields": [{"type": "cone_sdf"}, {"type": "centricity", "sources": 8}]}}])");
    document["signatures"].insert(document["signatures"].end(), more.begin(), more.end());
    return document;
  }

  ExperimentResults run(const Json& document, bool cached, int threads = 2) const {
    Cache cache(cached ? at("cache") : fs::path());
    ExperimentResults results =
        run_experiment(configuration_from_json(document, "test.json", "."),
                       {.control = {.threads = threads}, .cache = cache, .generated = at("generated")}, {});
    EXPECT_THAT(cache.warnings(), testing::IsEmpty());
    return results;
  }

  [[nodiscard]] std::map<std::string, std::string> files_of(const ExperimentResults& results) const {
    fs::remove_all(at("out"));
    test::publish(at("out"), results);
    return test::results_in(at("out"));
  }
};

const MethodResults& method_named(const ExperimentResults& results, const std::string& name) {
  return *std::ranges::find(results.methods, name, &MethodResults::name);
}

CacheUse uses_of_kind(const ExperimentResults& results, EntryKind kind) {
  return results.cache.uses.at(static_cast<std::size_t>(kind));
}

TEST_F(DescriptorRuns, ComputeFeaturesOfPreparedShapes) {
  const ExperimentResults results = run(document(), false);
  for (Eigen::Index i = 0; i < 9; ++i) {
    const Shape shape = prepare_shape(read_shape(results.models[static_cast<std::size_t>(i)].file), {}).shape;
    EXPECT_EQ(method_named(results, "d2").signatures.row(i).transpose(), d2(shape, {.points = 64, .bins = 8}));
  }
  EXPECT_EQ(method_named(results, "d2").distances,
            descriptor_distances(descriptors().at("d2"), method_named(results, "d2").signatures));
  const Signatures& joint = method_named(results, "joint").signatures;
  EXPECT_EQ(joint.cols(), 16);
  const Signatures& bag = method_named(results, "bag").signatures;
  EXPECT_EQ(bag.cols(), 5);
  for (Eigen::Index i = 0; i < 9; ++i) EXPECT_NEAR(bag.row(i).sum(), 1, 1e-6);
}

TEST_F(DescriptorRuns, DerivedDistancesMatchTheLibraryFunctions) {
  const ExperimentResults results = run(document(), false);
  const std::vector<DistanceMatrix> parts{method_named(results, "d2").distances,
                                          method_named(results, "joint").distances,
                                          method_named(results, "fixed").distances};
  const std::vector<double> weights{1, 0.5, 1};
  EXPECT_EQ(method_named(results, "sum").distances, sum_of_distances(parts, weights));
  EXPECT_EQ(method_named(results, "again").distances,
            diffused(method_named(results, "sum").distances, {.neighbours = 2}));
  EXPECT_EQ(method_named(results, "again").signatures.size(), 0);
  EXPECT_EQ(method_named(results, "again").evaluations.size(), 2U);
}

TEST_F(DescriptorRuns, DistancesDoNotDependOnClasses) {
  Json all = document();
  const Json more = Json::parse(R"([
    {"name": "ranks", "fuse_ranks": ["d2", "joint"]},
    {"name": "k", "rerank": {"of": "sum", "method": "k_reciprocal", "neighbours": 3, "expansion_neighbours": 2}},
    {"name": "query", "rerank": {"of": "sum", "method": "query_expansion"}},
    {"name": "agreed", "sum": [{"of": "d2"}, {"of": "joint"}, {"of": "fixed"}], "scale": "local", "weights": "agreement"},
    {"name": "averaged", "rerank": {"of": "agreed", "method": "diffusion", "neighbours": "auto"}}])");
  all["signatures"].insert(all["signatures"].end(), more.begin(), more.end());
  const ExperimentResults results = run(all, false);
  test::write_text(data() / "test.cla", "PSB 1\n3 9\n\na 0 3\n0\n3\n8\n\nb 0 3\n1\n4\n6\n\nc 0 3\n2\n5\n7\n");
  const ExperimentResults shuffled = run(all, false);
  EXPECT_NE(method_named(results, "sum").evaluations[0].per_query,
            method_named(shuffled, "sum").evaluations[0].per_query);
  for (const MethodResults& method : results.methods) {
    EXPECT_EQ(method_named(shuffled, method.name).distances, method.distances) << method.name;
  }
}

TEST_F(DescriptorRuns, ResultsDoNotDependOnTheCache) {
  const auto fresh = files_of(run(document(), false, 1));
  EXPECT_TRUE(fresh.contains("features/joint.npy"));
  EXPECT_FALSE(fresh.contains("features/sum.npy"));
  EXPECT_TRUE(fresh.contains("distances/sum.npy"));
  EXPECT_EQ(files_of(run(document(), true, 3)), fresh);
  const ExperimentResults again = run(document(), true);
  EXPECT_EQ(files_of(again), fresh);
  EXPECT_EQ(uses_of_kind(again, EntryKind::features).computed, 0U);
  EXPECT_EQ(uses_of_kind(again, EntryKind::features).hits, 27U);
  EXPECT_EQ(uses_of_kind(again, EntryKind::learnt).hits, 1U);
  EXPECT_EQ(uses_of_kind(again, EntryKind::field).computed, 0U);
}

TEST_F(DescriptorRuns, ComputeFeaturesFromCachedFields) {
  run(document(), true);
  Json changed = document();
  changed["signatures"][7]["descriptor"]["axes"][0]["bins"] = 5;
  const auto fresh = files_of(run(changed, false));
  const ExperimentResults results = run(changed, true);
  EXPECT_EQ(uses_of_kind(results, EntryKind::field).computed, 0U);
  EXPECT_EQ(uses_of_kind(results, EntryKind::features).computed, 9U);
  EXPECT_EQ(files_of(results), fresh);
}

TEST_F(DescriptorRuns, FeaturesWithACodebookDependOnEveryModel) {
  run(document(), true);
  write_off(data() / "T8.off", test::small_shape("box", 9));
  const auto fresh = files_of(run(document(), false));
  const ExperimentResults results = run(document(), true);
  EXPECT_EQ(uses_of_kind(results, EntryKind::learnt).computed, 1U);
  // All of the bag's, and those of the other two descriptors for one model.
  EXPECT_EQ(uses_of_kind(results, EntryKind::features).computed, 9U + 2U);
  EXPECT_EQ(files_of(results), fresh);
}

TEST_F(DescriptorRuns, ReportModelsThatCannotBeDescribed) {
  // A point cloud: ShapeDNA needs triangles.
  std::string cloud = "OFF\n30 0 0\n";
  for (int i = 0; i < 30; ++i)
    cloud += std::to_string(i % 5) + " " + std::to_string(i % 7) + " " + std::to_string(i) + "\n";
  test::write_text(data() / "T4.off", cloud);
  Json document = test::small_configuration(data());
  document["signatures"] = {{{"name", "dna"}, {"descriptor", {{"type", "shape_dna"}, {"eigenvalues", 5}}}}};
  EXPECT_THAT(test::input_error_of([&] { run(document, false); }), testing::HasSubstr("4"));
  document["on_error"] = "skip";
  const ExperimentResults results = run(document, false);
  ASSERT_EQ(results.failures.size(), 1U);
  EXPECT_EQ(results.failures[0].id, "4");
  EXPECT_EQ(method_named(results, "dna").distances.rows(), 8);
}

/// Rows and columns of the distances without those of model 4.
DistanceMatrix without_4(const DistanceMatrix& distances) {
  const std::vector<int> others{0, 1, 2, 3, 5, 6, 7, 8};
  return distances(others, others);
}

TEST_F(DescriptorRuns, KeepModelsThatOneMethodCannotProcessForOtherMethods) {
  Json document = this->document();
  document["on_error"] = "skip";
  const ExperimentResults before = run(document, false);
  test::replace_by_cloud(data() / "T4.off");
  const ExperimentResults results = run(document, true);
  EXPECT_TRUE(results.failures.empty());
  ASSERT_EQ(results.models.size(), 9U);

  // D2 of a cloud exists.
  const MethodResults& d2 = method_named(results, "d2");
  EXPECT_TRUE(d2.failures.empty());
  EXPECT_TRUE(d2.distances.allFinite());
  EXPECT_EQ(without_4(d2.distances), without_4(method_named(before, "d2").distances));

  std::vector<int> labels;
  for (const Model& model : results.models) labels.push_back(model.label);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const char* name : {"fixed", "joint", "bag", "both", "sum", "again"}) {
    SCOPED_TRACE(name);
    const MethodResults& method = method_named(results, name);
    ASSERT_EQ(method.failures.size(), 1U);
    EXPECT_EQ(method.failures[0].model, 4U);
    EXPECT_THAT(method.failures[0].message, testing::HasSubstr("the conventional SDF needs triangles"));
    for (Eigen::Index i = 0; i < 9; ++i) {
      EXPECT_EQ(method.distances(4, i), i == 4 ? 0 : infinity);
      EXPECT_EQ(method.distances(i, 4), i == 4 ? 0 : infinity);
    }
    EXPECT_TRUE(without_4(method.distances).allFinite());
    EXPECT_EQ(method.evaluations[0].per_query.row(4), Eigen::RowVectorXd::Zero(method.evaluations[0].per_query.cols()));
    EXPECT_EQ(evaluate(method.distances, labels, {}).micro, method.evaluations[0].micro);
  }
  EXPECT_TRUE(method_named(results, "joint").signatures.row(4).array().isNaN().all());
  EXPECT_TRUE(method_named(results, "both").signatures.row(4).array().isNaN().all());

  // The others are as in a run without the model.
  test::write_text(data() / "T4.off", "no shape");
  const ExperimentResults alone = run(document, false);
  for (const char* name : {"fixed", "joint", "bag", "both", "sum", "again"}) {
    EXPECT_EQ(without_4(method_named(results, name).distances), method_named(alone, name).distances) << name;
  }
}

TEST_F(DescriptorRuns, SummaryCountsModelsThatAMethodCannotProcess) {
  test::replace_by_cloud(data() / "T4.off");
  Json document = this->document();
  document["on_error"] = "skip";
  const ExperimentResults results = run(document, true);
  const auto files = files_of(results);
  EXPECT_THAT(files.at("summary.csv"), testing::HasSubstr("method,failed,protocol,average,NN"));
  EXPECT_THAT(files.at("summary.csv"), testing::HasSubstr("\nd2,0,psb,micro,"));
  EXPECT_THAT(files.at("summary.csv"), testing::HasSubstr("\nsum,1,psb,micro,"));
  const Json manifest = Json::parse(text_of(folder_.path() / "out" / "manifest.json"));
  EXPECT_TRUE(manifest.at("failed_models").empty());
  const Json& listed = manifest.at("method_failures");
  ASSERT_EQ(listed.size(), results.methods.size() - 1);
  EXPECT_EQ(listed[0].at("method"), "fixed");
  EXPECT_EQ(listed[0].at("model"), "4");
  const std::vector<std::string> sentences = incomplete_methods(results);
  ASSERT_EQ(sentences.size(), results.methods.size() - 1);
  EXPECT_THAT(sentences[0], testing::HasSubstr("method \"fixed\" cannot process 1 of 9 models"));
  EXPECT_EQ(files_of(run(document, true)), files) << "from the cache";
}

TEST_F(DescriptorRuns, StopIfAMethodSupportsNoModel) {
  for (int i = 0; i < 9; ++i) test::replace_by_cloud(data() / ("T" + std::to_string(i) + ".off"));
  Json document = this->document();
  document["on_error"] = "skip";
  EXPECT_THAT(test::input_error_of([&] { run(document, false); }),
              testing::HasSubstr("signature \"fixed\": none of 9 models can be used; the first is 0: "));
}

TEST_F(DescriptorRuns, OmitPicturesFromTheReportWithoutFields) {
  Json document = test::small_configuration(data());
  document["signatures"] = {{{"name", "d2"}, {"descriptor", {{"type", "d2"}}}},
                            {{"name", "again"}, {"rerank", {{"of", "d2"}, {"method", "k_reciprocal"}}}}};
  const ExperimentResults results = run(document, true);
  EXPECT_TRUE(results.pictures.empty());
  EXPECT_TRUE(files_of(results).contains("report.html"));
}

}  // namespace

}  // namespace shapegauge
