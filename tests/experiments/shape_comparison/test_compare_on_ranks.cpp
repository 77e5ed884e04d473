#include <atomic>
#include <filesystem>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <string>

#include "shapegauge/experiments/distributed/agreement.h"
#include "tests/experiments/shape_comparison/published_comparison.h"
#include "tests/support/test_files.h"
#include "tests/support/thread_ranks.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::HasSubstr;

/// Comparisons by several processes, each a thread, without a cache or with one that they share.
class CompareOnRanks : public testing::Test {
 protected:
  void SetUp() override {
    test::write_sphere(at("sphere.off"));
    test::write_text(at("flat.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
  }
  [[nodiscard]] fs::path at(const std::string& name) const { return folder_.path() / name; }
  /// Runs the comparison on that many processes; returns the outcome of rank 0.
  RunOutcome run(int size, const std::string& output, const Json& document, const fs::path& cache = "",
                 const RunControl& control = {.threads = 1}) const {
    RunOutcome outcome;
    test::on_thread_ranks(size, [&](Communicator& ranks) {
      Cache own(cache);
      const Experiment experiment = comparison_kind().read(document, "test.json", folder_.path());
      RunOutcome of_rank = run_into_folder(experiment, at(output), false, control, own, ranks);
      if (ranks.rank() == 0) outcome = std::move(of_rank);
    });
    return outcome;
  }
  [[nodiscard]] std::map<std::string, std::string> results(const std::string& output) const {
    return test::reproducible_results(at(output));
  }

 private:
  test::TemporaryFolder folder_;
};

CacheUse use_in(const RunOutcome& outcome) {
  return outcome.cache.uses.at(static_cast<std::size_t>(EntryKind::comparison));
}

TEST_F(CompareOnRanks, TheFilesAreTheSameBytes) {
  Json alone = test::three_spheres();
  alone.erase("reference");
  Json poses = test::three_spheres();
  poses["registered"] = false;
  int run_number = 0;
  for (const Json& document : {test::three_spheres(), poses, alone}) {
    const std::string name = std::to_string(run_number++);
    run(1, name + "/alone", document, "", {.threads = 2});
    const auto expected = results(name + "/alone");
    EXPECT_EQ(expected.size(), document.contains("reference") ? (document.contains("registered") ? 5U : 7U) : 4U);
    for (const int size : {2, 3, 5}) {  // five: more than shapes
      SCOPED_TRACE(size);
      const std::string output = name + "/" + std::to_string(size);
      run(size, output, document);
      EXPECT_EQ(results(output), expected);
    }
  }
}

TEST_F(CompareOnRanks, EachShapeIsMeasuredOnceAndFoundByAnyNumberOfRanks) {
  run(1, "alone", test::three_spheres());
  const CacheUse first = use_in(run(3, "first", test::three_spheres(), at("cache")));
  EXPECT_EQ(first.hits, 0U);
  EXPECT_EQ(first.computed, 3U);
  const CacheUse second = use_in(run(2, "second", test::three_spheres(), at("cache")));
  EXPECT_EQ(second.hits, 3U);
  EXPECT_EQ(second.computed, 0U);
  EXPECT_EQ(results("first"), results("alone"));
  EXPECT_EQ(results("second"), results("alone"));
  const Json execution = Json::parse(test::text_of(at("second/manifest.json"))).at("execution");
  EXPECT_EQ(execution.at("processes"), 2);
  EXPECT_EQ(execution.at("cache"), (Json{{"comparison", {{"from_cache", 3}, {"computed", 0}}}}));
}

TEST_F(CompareOnRanks, AnInterruptedRunGoesOnFromTheCacheOfAllRanks) {
  Json document = test::three_spheres();
  for (int i = 0; i < 4; ++i) {
    document["shapes"].push_back({{"name", std::to_string(i)},
                                  {"file", "sphere.off"},
                                  {"perturbations", {{{"type", "remove_faces"}, {"fraction", 0.1}}}}});
  }
  run(1, "alone", document);
  std::atomic<bool> interrupted = false;
  RunControl control{.threads = 1, .interrupted = [&] { return interrupted.load(); }};
  control.progress = [&](std::string_view stage, std::size_t done, std::size_t) {
    if (stage == "shapes" && done >= 3) interrupted = true;
  };
  EXPECT_THROW(run(2, "resumed", document, at("cache"), control), Interrupted);
  EXPECT_FALSE(fs::exists(at("resumed/manifest.json")));
  const CacheUse use = use_in(run(2, "resumed", document, at("cache")));
  EXPECT_GE(use.hits, 2U) << "the reference and another";
  EXPECT_GE(use.computed, 1U);
  EXPECT_EQ(use.hits + use.computed, 7U);
  EXPECT_EQ(results("resumed"), results("alone"));
}

TEST_F(CompareOnRanks, AShapeThatFailsIsLeftOutByAll) {
  Json document = test::three_spheres();
  document["shapes"].push_back({{"name", "flat"}, {"file", "flat.off"}});
  document["shapes"].push_back({{"name", "absent"}, {"file", "absent.off"}});
  document["on_error"] = "skip";
  run(1, "alone", document);
  for (const int size : {2, 3}) {
    SCOPED_TRACE(size);
    const RunOutcome outcome = run(size, std::to_string(size), document);
    ASSERT_EQ(outcome.left_out.size(), 2U);
    EXPECT_EQ(outcome.left_out[0].id, "flat");
    EXPECT_THAT(outcome.left_out[0].message, HasSubstr("area"));
    EXPECT_EQ(outcome.left_out[1].id, "absent");
    EXPECT_EQ(outcome.used, 3U);
    EXPECT_EQ(results(std::to_string(size)), results("alone"));
  }
}

TEST_F(CompareOnRanks, AFailureIsTheSameErrorOfAllRanks) {
  const auto error_on_ranks = [&](const Json& document, int size) {
    std::atomic<int> errors = 0;
    std::string message;
    test::on_thread_ranks(size, [&](Communicator& ranks) {
      Cache none;
      const Experiment experiment = comparison_kind().read(document, "test.json", at(""));
      try {
        run_into_folder(experiment, at("out"), false, {.threads = 1}, none, ranks);
      } catch (const SharedError& error) {
        ++errors;
        if (ranks.rank() == 0) message = error.what();
      }
    });
    EXPECT_EQ(errors, size);
    return message;
  };
  Json stopped = test::three_spheres();
  for (const char* const name : {"flat", "flat too"}) {
    stopped["shapes"].push_back({{"name", name}, {"file", "flat.off"}});
  }
  Json of_reference = stopped;
  of_reference["on_error"] = "skip";
  of_reference["reference"] = "flat too";
  Json none_left = stopped;
  none_left["on_error"] = "skip";
  none_left.erase("reference");
  none_left["shapes"].erase(none_left["shapes"].begin(), none_left["shapes"].begin() + 3);
  for (const int size : {1, 2, 3}) {
    SCOPED_TRACE(size);
    EXPECT_THAT(
        error_on_ranks(stopped, size),
        testing::MatchesRegex("shape \"flat\": .*area.*; repair or remove it, or set \"on_error\" to \"skip\""));
    EXPECT_THAT(error_on_ranks(of_reference, size),
                testing::MatchesRegex("shape \"flat too\": .*; it is the reference: repair it or choose another"));
    EXPECT_THAT(error_on_ranks(none_left, size), testing::StartsWith("none of the 2 shapes can be used; the first: "));
    EXPECT_FALSE(fs::exists(at("out/manifest.json")));
  }
}

}  // namespace

}  // namespace shapegauge
