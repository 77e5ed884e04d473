#include <gmock/gmock.h>

#include "tests/experiments/command_line/error_line.h"
#include "tests/experiments/command_line/run_executable.h"
#include "tests/experiments/command_line/small_run.h"
#include "tests/experiments/text_files.h"

namespace shapegauge {
namespace {

namespace fs = std::filesystem;
using test_command_line::expect_error_lines;
using test_command_line::Outcome;
using test_command_line::run_executable;
using test_command_line::SmallRun;
using test_experiments::text_of;
using test_experiments::write_text;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

/// A run over the small data set, recorded in out/manifest.json.
class ReplayReport : public SmallRun {
 protected:
  void SetUp() override {
    SmallRun::SetUp();
    ASSERT_EQ(run_executable("run " + quoted("small.json") + " --output " + quoted("out")).status, 0);
  }
  [[nodiscard]] Outcome replay(const std::string& more = "") const {
    return run_executable("run --replay " + quoted("out/manifest.json") + " --output " + quoted("again") + " " + more);
  }
};

TEST_F(ReplayReport, TheSameInputsGiveTheSameBytes) {
  const Outcome outcome = replay("--threads 3");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  EXPECT_THAT(outcome.output, HasSubstr("same          summary.csv\n"));
  EXPECT_THAT(outcome.output, HasSubstr("same          distances/fixed.npy\n"));
  EXPECT_THAT(outcome.output, HasSubstr("not compared  shape_seconds.csv\n"));
  EXPECT_THAT(outcome.output, HasSubstr("All 14 outputs are the same bytes as recorded.\n"));
  EXPECT_EQ(text_of(at("again/per_query.csv")), text_of(at("out/per_query.csv")));
}

TEST_F(ReplayReport, TheDataSetMayBeElsewhere) {
  fs::rename(at("data"), at("moved"));
  EXPECT_EQ(replay().status, 2);
  const Outcome outcome = replay("--dataset-root " + quoted("moved"));
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("All 14 outputs are the same bytes"));
}

TEST_F(ReplayReport, NothingComesFromTheCache) {
  const std::string cache = " --cache " + quoted("cache");
  EXPECT_THAT(replay(cache).output, HasSubstr("All 14"));
  EXPECT_THAT(replay(cache).output, Not(HasSubstr("From the cache")));
}

TEST_F(ReplayReport, AChangedInputIsNamedAndSoAreTheOutputsThatDiffer) {
  fs::copy_file(at("data/T3.off"), at("data/T4.off"), fs::copy_options::overwrite_existing);
  const Outcome outcome = replay();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.errors,
            "shapegauge: warning: input: model 4 is not the recorded one: its file holds other bytes\n");
  EXPECT_THAT(outcome.output, HasSubstr("DIFFERENT     distances/fixed.npy\n"));
  EXPECT_THAT(outcome.output, HasSubstr("input         model 4 is not the recorded one"));
  EXPECT_THAT(outcome.output, MatchesRegex("(.|\n)*[0-9]+ of 14 outputs are not the same bytes as recorded; 1 of its "
                                           "inputs are not those recorded\\.\n"));
}

TEST_F(ReplayReport, AnotherSettingGivesOtherOutputs) {
  const Outcome outcome = replay("--set signatures.0.histogram.bins=7");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.output, HasSubstr("DIFFERENT     distances/fixed.npy\n"));
  EXPECT_THAT(outcome.output, HasSubstr("same          distances/per_shape.npy\n"));
}

TEST_F(ReplayReport, AComparisonIsRepeatedToo) {
  write_text(at("comparison.json"), R"({"name": "two", "reference": "a", "shapes": [
    {"name": "a", "file": "data/T0.off"}, {"name": "b", "file": "data/T1.off"}], "signatures": [
    {"name": "cone", "field": {"type": "cone_sdf"}, "histogram": {"range": "per-shape"}}]})");
  ASSERT_EQ(run_executable("run " + quoted("comparison.json") + " --output " + quoted("two")).status, 0);
  fs::rename(at("data"), at("moved"));
  const std::string replay =
      "run --replay " + quoted("two/manifest.json") + " --output " + quoted("again") + " --dataset-root ";
  const Outcome outcome = run_executable(replay + quoted("moved"));
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("same          distances.csv\n"));
  EXPECT_THAT(outcome.output, HasSubstr("not compared  timings.csv\n"));
  fs::copy_file(at("moved/T2.off"), at("moved/T1.off"), fs::copy_options::overwrite_existing);
  const Outcome changed = run_executable(replay + quoted("moved"));
  EXPECT_EQ(changed.status, 1);
  EXPECT_THAT(changed.output, HasSubstr("input         shape b is not the recorded one"));
}

TEST_F(ReplayReport, UnusableArgumentsAreOneClearLine) {
  const std::string manifest = "run --replay " + quoted("out/manifest.json");
  write_text(at("text.json"), "{}");
  expect_error_lines(
      {{manifest + " " + quoted("small.json"), "excludes --replay"},
       {"run " + quoted("small.json") + " --dataset-root x", "--dataset-root goes with --replay"},
       {"run --replay " + quoted("text.json"), "has no \"configuration\""},
       {"run --replay /nowhere/manifest.json", "no such file"},
       {manifest + " --output " + quoted("again") + " --dataset-root /nowhere", "/nowhere: no such folder"},
       {manifest + " --cache x --no-cache", "--cache excludes --no-cache"}});
}

}  // namespace
}  // namespace shapegauge
