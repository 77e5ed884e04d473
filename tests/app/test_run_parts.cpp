// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <cstdlib>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "shapegauge/experiments/cache/cache_folder.h"
#include "tests/app/program.h"
#include "tests/support/small_dataset.h"
#include "tests/support/test_files.h"

namespace shapegauge::test_command_line {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::results_in;
using test::text_of;
using test::write_text;
using testing::HasSubstr;

/// Runs in parts, with 9 models and a descriptor that learns from all of them.
class RunParts : public SmallRun {
 protected:
  void SetUp() override {
    SmallRun::SetUp();
    json configuration = test::small_configuration("data");
    configuration["signatures"].push_back(
        {{"name", "bag"},
         {"descriptor",
          {{"type", "bag_of_features"}, {"words", 5}, {"fields", {configuration["signatures"][0]["field"]}}}}});
    configuration["signatures"].push_back({{"name", "sum"}, {"sum", {{{"of", "fixed"}}, {{"of", "bag"}}}}});
    write_text(at("small.json"), configuration.dump());
  }

  /// Makes the run long enough to be interrupted.
  void take_long() const {
    json configuration = json::parse(text_of(at("small.json")));
    for (json& signature : configuration["signatures"]) {
      if (signature.contains("field")) signature["field"]["rays"] = 3000;
    }
    write_text(at("small.json"), configuration.dump());
  }
  [[nodiscard]] std::vector<std::string> arguments(const std::string& part) const {
    return {"run",     at("small.json").string(), "--part",    part, "--output", at("out").string(),
            "--cache", at("cache").string(),      "--threads", "1"};
  }
  [[nodiscard]] Outcome run_part(const std::string& part, const std::string& cache = "cache") const {
    return run_executable(fmt::format("run {} --part {} --output {} --cache {}", quoted("small.json"), part,
                                      quoted("out"), quoted(cache)));
  }
  /// Runs the rest and returns the results.
  [[nodiscard]] std::map<std::string, std::string> combined(int status = 0) const {
    EXPECT_EQ(run("run @small.json --output @out --cache @cache").status, status);
    return results_in(at("out"));
  }
  [[nodiscard]] json cache_use() const {
    return json::parse(text_of(at("out/manifest.json")))["execution"]["cache"]["field"];
  }
  [[nodiscard]] std::map<std::string, std::string> results_of_one(int status = 0) const {
    EXPECT_EQ(run("run @small.json --no-cache --output @alone").status, status);
    return results_in(at("alone"));
  }
  [[nodiscard]] std::size_t cached_fields() const {
    return cache_contents(at("cache")).by_kind.at(static_cast<std::size_t>(EntryKind::field)).entries;
  }
};

TEST_F(RunParts, MissingPartsAreComputedByTheCombiningRun) {
  for (const char* part : {"1/2", "3/3"}) {
    const Outcome outcome = succeeded(run_part(part));
    EXPECT_EQ(outcome.errors, "");
  }
  const auto results = combined();
  EXPECT_TRUE(results.contains("distances/sum.npy") && results.contains("features/bag.npy"));
  EXPECT_EQ(results, results_of_one());
  EXPECT_EQ(cache_use()["computed"], 3);
}

TEST_F(RunParts, ComputedInParallelGiveTheResultsOfASingleProcess) {
  {
    BackgroundRun first(arguments("1/2"), at("errors1"));
    BackgroundRun same(arguments("1/2"), at("errors2"));
    BackgroundRun second(arguments("2/2"), at("errors3"));
    for (BackgroundRun* part : {&first, &same, &second}) EXPECT_EQ(part->wait(), 0);
  }
  for (const char* errors : {"errors1", "errors2", "errors3"}) EXPECT_EQ(text_of(at(errors)), "");
  EXPECT_EQ(combined(), results_of_one());
  EXPECT_EQ(cache_use()["computed"], 0);
}

TEST_F(RunParts, ContinueFromTheCacheAfterBeingKilled) {
  take_long();
  BackgroundRun part(arguments("1/2"), at("errors"));
  ASSERT_TRUE(part.wait_until([&] { return cached_fields() >= 2; }));
  part.send(SIGKILL);
  EXPECT_EQ(part.wait(), -SIGKILL);
  const std::size_t cached = cached_fields();
  EXPECT_LT(cached, 5U);
  const Outcome again = succeeded(run_part("1/2"));
  EXPECT_EQ(again.errors, "") << "nothing is damaged";
  EXPECT_GE(cached_fields(), 5U);
  EXPECT_EQ(combined(), results_of_one());
}

TEST_F(RunParts, SayHowToContinueWhenTerminated) {
  take_long();
  BackgroundRun part(arguments("1/1"), at("errors"));
  ASSERT_TRUE(part.wait_until([&] { return cached_fields() >= 1; }));
  part.send(SIGTERM);
  EXPECT_NE(part.wait(), 0);
  EXPECT_THAT(text_of(at("errors")), HasSubstr("Completed shapes are in the cache; the same command continues"));
}

TEST_F(RunParts, RecomputeCacheEntriesOfAnotherFormatVersion) {
  ASSERT_EQ(run_part("1/2").status, 0);
  // Those of another version have other keys; those of another format are damaged.
  for (const auto& entry : fs::recursive_directory_iterator(at("cache"))) {
    if (!entry.is_regular_file() || entry.path().filename() == cache_tag_name) continue;
    std::string bytes = text_of(entry.path());
    bytes.replace(0, bytes.find('\n'), "shapegauge cache entry 99");
    write_text(entry.path(), bytes);
  }
  const Outcome outcome = succeeded(run_part("2/2"));
  EXPECT_EQ(outcome.errors, "") << "shapes of another part";
  EXPECT_THAT(run_part("1/2").errors, HasSubstr("damaged cache entry, recomputed"));
  EXPECT_EQ(combined(), results_of_one());
  EXPECT_EQ(cache_use()["computed"], 0);
}

TEST_F(RunParts, StopAtAnInvalidModelUnlessSkippingIsRequested) {
  write_text(at("data/T4.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
  EXPECT_EQ(run_part("2/2").status, 0);
  const Outcome stopped = run_part("1/2");
  EXPECT_EQ(stopped.status, 2);
  EXPECT_THAT(stopped.errors, HasSubstr("model 4: "));
  const Outcome skipped = run_part("1/2 --set on_error=skip");
  EXPECT_EQ(skipped.status, 0) << "the other parts and the run go on";
  EXPECT_THAT(skipped.errors, HasSubstr("omitted model 4: "));
  EXPECT_THAT(skipped.output, HasSubstr("4 of 9 models"));
}

TEST_F(RunParts, OfAGeneratedDataSetGiveTheResultsOfOneProcess) {
  json configuration = json::parse(text_of(at("small.json")));
  configuration["dataset"] = {{"generate", {{"classes", 3}, {"models_per_class", 2}, {"faces", 1000}}}};
  write_text(at("small.json"), configuration.dump());
  {
    BackgroundRun first(arguments("1/2"), at("errors1"));
    BackgroundRun second(arguments("2/2"), at("errors2"));
    EXPECT_EQ(first.wait(), 0);
    EXPECT_EQ(second.wait(), 0);
  }
  auto together = combined();
  EXPECT_EQ(cache_use()["computed"], 0);
  auto alone = results_of_one();
  EXPECT_EQ(together, alone);
}

TEST_F(RunParts, AutomaticPartNumberIsThatOfTheSlurmArrayTask) {
  const std::string command =
      "run " + quoted("small.json") + " --part auto --output " + quoted("out") + " --cache " + quoted("cache");
  ::setenv("SLURM_ARRAY_TASK_ID", "3", 1);
  ::setenv("SLURM_ARRAY_TASK_COUNT", "4", 1);
  ::setenv("SLURM_ARRAY_TASK_MIN", "1", 1);
  const Outcome outcome = run_executable(command);
  for (const char* name : {"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", "SLURM_ARRAY_TASK_MIN"}) ::unsetenv(name);
  EXPECT_THAT(outcome.output, HasSubstr("Part 3 of 4: 2 of 9 models"));
}

TEST_F(RunParts, RejectPartNumbersOutOfRangeAndRunsWithoutACache) {
  const std::string run = "run " + quoted("small.json") + " --part ";
  expect_error_lines(
      {{run + "3/2", "3/2"}, {run + "1/2 --no-cache", "--no-cache"}, {run + "1/2 --plot x.svg", "--plot"}});
  EXPECT_EQ(run_part("1/2", "small.json/cache").status, 2) << "a part that nothing can keep";
}

TEST_F(RunParts, ValidateCommandChecksOnlyTheModelsOfTheRequestedPart) {
  write_text(at("data/T4.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
  const std::string validate = "dataset validate " + quoted("data") + " --part ";
  const Outcome first = run_executable(validate + "1/2");
  EXPECT_EQ(first.status, 1);
  EXPECT_THAT(first.output, HasSubstr("4 of 5 models can be used"));
  const Outcome second = succeeded(run_executable(validate + "2/2"));
  EXPECT_EQ(second.output, "4 of 4 models can be used\n");
}

/// Streamed distances need more models than a matrix in memory has. Nothing waits for models that fail: one has no
/// area, the file of another is missing.
TEST_F(RunParts, ScoreThousandsOfModelsRowByRowLikeASingleProcess) {
  std::string classification = "PSB 1\n2 2950\n";
  for (int i = 0; i < 2950; ++i) {
    if (i % 1475 == 0) classification += fmt::format("\nclass{} 0 1475\n", i);
    classification += fmt::format("{}\n", i);
    write_text(at(fmt::format("many/T{}.off", i)),
               fmt::format("OFF\n# {2}\n4 4 0\n0 0 0\n1 0 0\n0 {0} 0\n0 0 {1}\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n",
                           1 + i % 7 + (i / 1475), 1 + i % 11, i));
  }
  write_text(at("many/test.cla"), classification);
  write_text(at("many/T8.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
  fs::remove(at("many/T1500.off"));
  const json field{{"type", "cone_sdf"}, {"rays", 1}};
  const json configuration{
      {"name", "many"},
      {"dataset", {{"layout", "shrec11"}, {"root", "many"}}},
      {"on_error", "skip"},
      {"report", false},
      {"keep_distances", false},
      {"signatures",
       {{{"name", "cone"}, {"field", field}, {"histogram", {{"bins", 8}, {"range", {{"fixed", {0, 4}}}}}}}}}};
  write_text(at("small.json"), configuration.dump());
  EXPECT_THAT(run_part("2/2").output, testing::Not(HasSubstr("rows"))) << "nobody has tried model 8";
  EXPECT_THAT(run_part("1/2").output, HasSubstr("1474 of 2950 models and scores of 1536 rows of distances"));
  EXPECT_THAT(run_part("2/2").output, HasSubstr("1474 of 2950 models and scores of 1412 rows of distances"));
  const auto results = combined(1);
  const json cache = json::parse(text_of(at("out/manifest.json")))["execution"]["cache"];
  EXPECT_EQ(cache["evaluation"], (json{{"from_cache", 6}, {"computed", 0}}));
  EXPECT_EQ(results, results_of_one(1));
}

}  // namespace
}  // namespace shapegauge::test_command_line
