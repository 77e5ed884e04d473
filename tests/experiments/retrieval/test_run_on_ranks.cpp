#include <filesystem>
#include <gmock/gmock.h>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/distributed/agreement.h"
#include "shapegauge/experiments/retrieval/run_experiment.h"
#include "shapegauge/experiments/retrieval/write_results.h"
#include "tests/experiments/retrieval/published_retrieval.h"
#include "tests/support/small_dataset.h"
#include "tests/support/test_files.h"
#include "tests/support/thread_ranks.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using test::text_of;
using testing::HasSubstr;

/// Result files by name, without what varies between runs.
std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).string();
    if (entry.is_regular_file() && name != "shape_seconds.csv") files[name] = text_of(entry.path());
  }
  Json manifest = Json::parse(files.at("manifest.json"));
  manifest.erase("execution");
  files["manifest.json"] = manifest.dump();
  return files;
}

class RunOnRanks : public testing::Test {
 protected:
  void SetUp() override { test::write_small_dataset(at("data")); }
  [[nodiscard]] fs::path at(const std::string& name) const { return folder_.path() / name; }
  [[nodiscard]] Configuration configuration(const Json& changes = Json::object()) const {
    Json document = test::small_configuration(at("data"));
    const Json field = document["signatures"][0]["field"];
    document["signatures"].push_back(
        {{"name", "bag"}, {"descriptor", {{"type", "bag_of_features"}, {"words", 5}, {"fields", {field}}}}});
    document["signatures"].push_back({{"name", "d2"}, {"descriptor", {{"type", "d2"}, {"points", 50}}}});
    document["signatures"].push_back({{"name", "sum"}, {"sum", {{{"of", "fixed"}}, {{"of", "bag"}}}}});
    document.merge_patch(changes);
    return configuration_from_json(document, "test.json", folder_.path());
  }
  void run_on(int size, const std::string& output, const Configuration& configuration) const {
    test::on_thread_ranks(size, [&](Communicator& ranks) {
      Cache none;
      run_into_folder(retrieval_experiment(configuration), at(output), false, {.threads = 1}, none, ranks);
    });
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(RunOnRanks, TheFilesAreTheSameBytes) {
  Cache none;
  run_into_folder(retrieval_experiment(configuration()), at("alone"), false, {.threads = 2}, none, *single_process());
  const auto expected = files_in(at("alone"));
  ASSERT_TRUE(expected.contains("features/d2.npy") && expected.contains("distances/sum.npy"));
  for (const int size : {2, 3, 10}) {  // ten: more than models
    SCOPED_TRACE(size);
    run_on(size, std::to_string(size), configuration());
    EXPECT_EQ(files_in(at(std::to_string(size))), expected);
  }
}

TEST_F(RunOnRanks, ModelsThatAMethodCannotTakeAreTheSameBytes) {
  test::make_cloud(at("data/T4.off"));
  Configuration all = configuration({{"on_error", "skip"}});
  Configuration streamed = all;  // without derived distances: several ranks hold no whole matrix
  streamed.signatures.pop_back();
  int run = 0;
  for (const Configuration& one : {all, streamed}) {
    const std::string name = std::to_string(run++);
    Cache none;
    run_into_folder(retrieval_experiment(one), at("alone" + name), false, {.threads = 2}, none, *single_process());
    const auto expected = files_in(at("alone" + name));
    EXPECT_EQ(Json::parse(expected.at("manifest.json")).at("method_failures").size(), one.signatures.size() - 1);
    for (const int size : {2, 10}) {
      SCOPED_TRACE(size);
      const std::string output = "on" + name + std::to_string(size);
      run_on(size, output, one);
      EXPECT_EQ(files_in(at(output)), expected);
    }
  }
}

TEST_F(RunOnRanks, TiesAreTheSameBytes) {
  Json document = test::small_configuration(at("data"));
  document["signatures"][1]["histogram"] = {{"bins", 1}, {"smoothing_bins", 0}, {"range", "per-shape"}};
  const Configuration tied = configuration_from_json(document, "test.json", at(""));
  run_on(1, "alone", tied);
  const auto expected = files_in(at("alone"));
  EXPECT_EQ(Json::parse(expected.at("summary.json"))["tied"][2]["queries_with_ties"], 9);
  for (const int size : {2, 5}) {
    run_on(size, std::to_string(size), tied);
    EXPECT_EQ(files_in(at(std::to_string(size))), expected) << size;
  }
}

TEST_F(RunOnRanks, TheFilesAreThoseOfMatricesInMemory) {
  test::publish(at("memory"), run_experiment(configuration(), at("generated"), {.threads = 1}));
  Cache none;
  run_into_folder(retrieval_experiment(configuration()), at("alone"), false, {.threads = 1}, none, *single_process());
  EXPECT_EQ(files_in(at("alone")), files_in(at("memory")));
}

TEST_F(RunOnRanks, DistancesThatAreNotKeptChangeNothingElse) {
  const Configuration without = configuration({{"keep_distances", false}});
  run_on(2, "without", without);
  run_on(2, "with", configuration());
  auto expected = files_in(at("with"));
  std::erase_if(expected, [](const auto& file) { return file.first.starts_with("distances/"); });
  auto files = files_in(at("without"));
  for (auto* both : {&expected, &files}) both->erase("manifest.json");
  EXPECT_EQ(files, expected);
}

TEST_F(RunOnRanks, TheFirstModelThatFailsIsTheErrorOfAll) {
  for (const char* model : {"data/T7.off", "data/T3.off"}) test::write_text(at(model), "OFF\n3 1 0\n0 0 0\n");
  int errors = 0;
  std::mutex mutex;
  test::on_thread_ranks(3, [&](Communicator& ranks) {
    try {
      Cache none;
      run_into_folder(retrieval_experiment(configuration()), at("out"), false, {.threads = 1}, none, ranks);
    } catch (const SharedError& error) {
      EXPECT_THAT(error.what(), HasSubstr("model 3: "));
      const std::scoped_lock lock(mutex);
      ++errors;
    }
  });
  EXPECT_EQ(errors, 3);
}

}  // namespace

}  // namespace shapegauge
