// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/io/formats.h"
#include "tests/app/program.h"
#include "tests/support/small_dataset.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge::test_command_line {

namespace {

namespace fs = std::filesystem;
using test::text_of;
using test::write_text;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;

/// A run over the small data set, recorded in out/manifest.json.
class ReplayReport : public SmallRun {
 protected:
  void SetUp() override {
    SmallRun::SetUp();
    ASSERT_EQ(run_executable("run " + quoted("small.json") + " --output " + quoted("out")).status, 0);
  }
  [[nodiscard]] Outcome replay(const std::string& more = "") const {
    return run("run --replay @out/manifest.json --output @again " + more);
  }
};

TEST_F(ReplayReport, ConfirmsIdenticalOutputsForUnchangedInputs) {
  const Outcome outcome = succeeded(replay("--threads 3"));
  EXPECT_EQ(outcome.errors, "");
  EXPECT_THAT(outcome.output, HasSubstr("same          summary.csv\n"));
  EXPECT_THAT(outcome.output, HasSubstr("same          distances/fixed.npy\n"));
  EXPECT_THAT(outcome.output, HasSubstr("not compared  shape_seconds.csv\n"));
  EXPECT_THAT(outcome.output, HasSubstr("All 15 outputs are identical"));
  EXPECT_EQ(text_of(at("again/per_query.csv")), text_of(at("out/per_query.csv")));
}

TEST_F(SmallRun, RunAndCompareCommandsPlotPrecisionRecallCurves) {
  const std::string run = "run " + quoted("small.json") + " --output " + quoted("out");
  const Outcome outcome = succeeded(run_executable(run + " --plot " + quoted("run.svg")));
  const std::string drawn = text_of(at("run.svg"));
  EXPECT_THAT(drawn, AllOf(HasSubstr(">Recall<"), HasSubstr(">fixed (psb)<"), HasSubstr(">both (paper)<")));
  const Outcome compared =
      succeeded(run_executable("compare " + quoted("out") + " --plot " + quoted("compare.svg") + " --measures FT"));
  EXPECT_THAT(text_of(at("compare.svg")), AllOf(HasSubstr(">Recall<"), HasSubstr(">fixed<"), HasSubstr(">both<")));
  EXPECT_THAT(run_executable(run + " --plot " + quoted("run.svg")).errors, HasSubstr("--replace"));
  EXPECT_EQ(run_executable(run + " --plot " + quoted("run.eps")).status, 2);
}

TEST_F(SmallRun, DryRunChecksInputsAndPrintsTheConfiguration) {
  const std::string run = "run " + quoted("small.json") + " --output " + quoted("out");
  const Outcome dry = succeeded(run_executable(run + " --dry-run"));
  EXPECT_THAT(dry.output, HasSubstr("Inputs: 9 files\nResults: " + at("out").string() + "\n"));
  const Outcome printed = succeeded(run_executable(run + " --print-config --set signatures.0.histogram.bins=7"));
  const auto configuration = nlohmann::json::parse(printed.output);
  EXPECT_EQ(configuration["signatures"][0]["histogram"]["bins"], 7);
  EXPECT_EQ(configuration["signatures"][0]["field"]["rays"], 25) << "a default";
  for (const std::string option : {" --dry-run", " --part 1/2"}) {
    const Outcome without_queries = run_executable(run + option + " --set evaluation.minimum_class_size=100");
    EXPECT_EQ(without_queries.status, 2) << option;
    EXPECT_THAT(without_queries.errors, HasSubstr("no class")) << option;
  }
  EXPECT_FALSE(fs::exists(at("out")));
  ASSERT_EQ(run_executable(run).status, 0);
  EXPECT_THAT(run_executable(run + " --dry-run").output, HasSubstr("replacing"));
  EXPECT_EQ(run_executable(run + " --dry-run --set signatures.0.histogram.bins=7").status, 2);
}

TEST_F(SmallRun, EvaluatingARunFolderReproducesTheScoresOfItsSummary) {
  ASSERT_EQ(run("run @small.json --output @out").status, 0);
  EXPECT_EQ(text_of(at("out/distances/ids.txt")), "0\n1\n2\n3\n4\n5\n6\n7\n8\n");
  const Outcome all = succeeded(run("evaluate @out --protocol paper --format csv"));
  const std::string summary = text_of(at("out/summary.csv"));
  EXPECT_THAT(all.output, StartsWith("method,protocol,average,NN,FT,ST,E,DCG,mAP\nboth,paper,micro,"));
  std::size_t begin = summary.find("fixed,paper,micro");
  EXPECT_THAT(all.output, HasSubstr(summary.substr(begin, summary.find('\n', begin) - begin)));
  const Outcome json = run("evaluate @out --format json");
  EXPECT_EQ(nlohmann::json::parse(json.output).size(), 4U);
}

TEST_F(SmallRun, IdsFileOfAMatrixMatchesItsRowsToReorderedLabels) {
  ASSERT_EQ(run("run @small.json --output @out").status, 0);
  const std::string evaluate = "evaluate " + quoted("out/distances/fixed.npy") + " --format csv --labels ";
  write_text(at("shuffled.csv"), "id,class\n8,c\n0,a\n1,b\n2,c\n3,a\n4,b\n5,c\n6,a\n7,b\n");
  const Outcome outcome = run_executable(evaluate + quoted("shuffled.csv"));
  EXPECT_THAT(outcome.errors, testing::Not(HasSubstr("order")));
  EXPECT_EQ(outcome.output, run_executable(evaluate + quoted("data/test.cla")).output);
}

TEST_F(ReplayReport, DatasetRootOptionReplaysARunOnAMovedDataSet) {
  fs::rename(at("data"), at("moved"));
  EXPECT_EQ(replay().status, 2);
  const Outcome outcome = succeeded(replay("--dataset-root " + quoted("moved")));
  EXPECT_THAT(outcome.output, HasSubstr("All 15 outputs are identical"));
}

TEST_F(ReplayReport, RecomputesAllResultsDespiteAFilledCache) {
  const std::string cache = " --cache " + quoted("cache");
  EXPECT_THAT(replay(cache).output, HasSubstr("All 15"));
  EXPECT_THAT(replay(cache).output, Not(HasSubstr("From the cache")));
}

TEST_F(ReplayReport, NamesChangedInputsAndDifferentOutputs) {
  fs::copy_file(at("data/T3.off"), at("data/T4.off"), fs::copy_options::overwrite_existing);
  const Outcome outcome = replay();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.errors, HasSubstr("shapegauge: warning: input: model 4 differs from the recorded one\n"));
  EXPECT_THAT(outcome.output, HasSubstr("DIFFERENT     distances/fixed.npy\n"));
  EXPECT_THAT(outcome.output, HasSubstr("input         model 4 differs from the recorded one"));
  EXPECT_THAT(outcome.output, MatchesRegex("(.|\n)*[0-9]+ of 15 outputs differ from the recorded ones; 1 of its "
                                           "inputs differ as well\\.\n"));
}

TEST_F(ReplayReport, ReportsOutputsChangedByAnOverriddenSetting) {
  const Outcome outcome = replay("--set signatures.0.histogram.bins=7");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.output, HasSubstr("DIFFERENT     distances/fixed.npy\n"));
  EXPECT_THAT(outcome.output, HasSubstr("same          distances/per_shape.npy\n"));
}

TEST_F(ReplayReport, OfAShapeComparisonNamesIdenticalOutputsAndChangedShapes) {
  write_text(at("comparison.json"), R"({"name": "two", "reference": "a", "shapes": [
    {"name": "a", "file": "data/T0.off"}, {"name": "b", "file": "data/T1.off"}], "signatures": [
    {"name": "cone", "field": {"type": "cone_sdf"}, "histogram": {"range": "per-shape"}}]})");
  ASSERT_EQ(run("run @comparison.json --output @two").status, 0);
  fs::rename(at("data"), at("moved"));
  const std::string replay =
      "run --replay " + quoted("two/manifest.json") + " --output " + quoted("again") + " --dataset-root ";
  const Outcome outcome = succeeded(run_executable(replay + quoted("moved")));
  EXPECT_THAT(outcome.output, HasSubstr("same          distances.csv\n"));
  EXPECT_THAT(outcome.output, HasSubstr("not compared  timings.csv\n"));
  fs::copy_file(at("moved/T2.off"), at("moved/T1.off"), fs::copy_options::overwrite_existing);
  const Outcome changed = run_executable(replay + quoted("moved"));
  EXPECT_EQ(changed.status, 1);
  EXPECT_THAT(changed.errors, HasSubstr("input: shape b differs from the recorded one\n")) << "before the run";
  EXPECT_THAT(changed.output, HasSubstr("input         shape b"));
}

TEST_F(ReplayReport, NamesChangedInputsOfSegmentations) {
  write_text(at("parts.json"), R"({"name": "parts", "pictures": false,
    "dataset": {"layout": "shrec11", "root": "data"}, "segmentation": [{"name": "paper", "method": "paper"}]})");
  ASSERT_EQ(run("run @parts.json --output @parts").status, 0);
  fs::copy_file(at("data/T2.off"), at("data/T1.off"), fs::copy_options::overwrite_existing);
  const Outcome changed = run("run --replay @parts/manifest.json --output @again");
  EXPECT_EQ(changed.status, 1);
  EXPECT_THAT(changed.errors, HasSubstr("input: model 1 differs from the recorded one\n")) << "before the run";
}

TEST_F(ReplayReport, RejectsIncompleteManifestsMissingFoldersAndExclusiveOptions) {
  const std::string manifest = "run --replay " + quoted("out/manifest.json");
  write_text(at("text.json"), "{}");
  expect_error_lines(
      {{manifest + " " + quoted("small.json"), "excludes --replay"},
       {"run " + quoted("small.json") + " --dataset-root x", "--dataset-root requires --replay"},
       {"run --replay " + quoted("text.json"), "text.json: missing \"configuration\""},
       {"run --replay /nowhere/manifest.json", "no such file"},
       {manifest + " --output " + quoted("again") + " --dataset-root /nowhere", "/nowhere: no such folder"},
       {manifest + " --cache x --no-cache", "--cache excludes --no-cache"}});
}

class RunCommand : public SmallRun {
 protected:
  [[nodiscard]] Outcome run_small(const std::string& more = "") const {
    return run("run @small.json --output @out " + more);
  }
};

TEST_F(RunCommand, PrintsTheSummaryAndWritesTheResultFiles) {
  const Outcome outcome = succeeded(run_small());
  EXPECT_EQ(outcome.errors, "");
  EXPECT_THAT(outcome.output, HasSubstr("fixed      psb       both     100.00"));
  EXPECT_THAT(outcome.output, HasSubstr("Results in " + at("out").string()));
  EXPECT_THAT(outcome.output, HasSubstr("Report: " + (at("out") / "report.html").string()));
  EXPECT_THAT(text_of(at("out") / "summary.csv"),
              StartsWith("method,protocol,average,NN,FT,ST,E,DCG,mAP\nfixed,psb,micro,100.0000,"));
  for (const auto& entry : fs::recursive_directory_iterator(at("out"))) {
    EXPECT_THAT(entry.path().extension().string(), MatchesRegex("|.csv|.html|.json|.md|.tex|.npy|.txt"))
        << entry.path();
  }
}

TEST_F(RunCommand, OmitsTheReportOnRequest) {
  ASSERT_EQ(run_small().status, 0);
  EXPECT_TRUE(fs::exists(at("out") / "report.html"));
  const Outcome outcome = succeeded(run_small("--force --set report=false"));
  EXPECT_THAT(outcome.output, Not(HasSubstr("report.html")));
  EXPECT_FALSE(fs::exists(at("out") / "report.html")) << "that of the earlier run";
}

TEST_F(RunCommand, ReplacesOnlyResultsOfTheSameConfiguration) {
  ASSERT_EQ(run_small().status, 0);
  EXPECT_EQ(run_small().status, 0);
  const Outcome other = run_small("--set signatures.0.histogram.bins=10");
  EXPECT_EQ(other.status, 2);
  EXPECT_THAT(other.errors, HasSubstr("--replace"));
  EXPECT_EQ(run_small("--replace --set signatures.0.histogram.bins=10").status, 0);
  EXPECT_EQ(run_small("--force --set signatures.0.histogram.bins=10").status, 0);
}

TEST_F(RunCommand, SkipsAndNamesUnusableModelsOnRequest) {
  write_text(at("data/T3.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 nan\n3 0 1 2\n");
  const Outcome outcome = run_small("--set on_error=skip");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.errors, HasSubstr("omitted model 3: "));
  EXPECT_THAT(outcome.errors, HasSubstr("1 of 9 models could not be used"));
  EXPECT_THAT(outcome.output, HasSubstr("fixed"));
  EXPECT_TRUE(fs::exists(at("out/manifest.json")));
}

TEST_F(RunCommand, NamesMethodsThatCannotProcessAModel) {
  test::replace_by_cloud(at("data/T3.off"));
  const std::string d2 = R"( --set 'signatures=[{"name": "d2", "descriptor": {"type": "d2"}}, {"name": "dna", )"
                         R"("descriptor": {"type": "shape_dna", "eigenvalues": 5}}]')";
  const Outcome outcome = run_small("--set on_error=skip" + d2);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.errors, HasSubstr("method \"dna\" cannot process 1 of 9 models, which count as not found: 3 ("));
  EXPECT_THAT(outcome.errors, testing::Not(HasSubstr("omitted")));
  EXPECT_THAT(outcome.output, testing::ContainsRegex("dna +1 +psb +both "));
}

TEST_F(RunCommand, RejectsMissingFilesUnknownKeysAndInvalidOptionValues) {
  const std::string file = "run " + quoted("small.json") + " ";
  const std::string out = " --output " + quoted("out") + " ";
  expect_error_lines(
      {{"run /nowhere/x.json", "/nowhere/x.json: no such file"},
       {file + out + "--set signature=1", "unknown key \"signature\"; did you mean \"signatures\"?"},
       {file + out + "--set signatures.0.histogram.bins=many", "signatures.0.histogram.bins: must be of type integer"},
       {file + out + "--set signatures.3.concatenate.0=fixd", "did you mean \"fixed\"?"},
       {file + out + "--set dataset.root=nowhere", "nowhere: no such folder"},
       {file + out + "--set dataset.classification=nowhere.cla", "nowhere.cla"},
       {file + out + "--set 'dataset.root=${SHAPEGAUGE_TEST_UNSET}'", "SHAPEGAUGE_TEST_UNSET is not set; set it"},
       {file + "--output /proc/out", "/proc/out"},
       {file + out + "--frobnicate", "--frobnicate"},
       {file + out + "--threads 0", "--threads"},
       {file + out + "--threads many", "--threads"},
       {"run", "configuration file is required"}});
}

TEST_F(RunCommand, DoesNotOverwriteTheFilesItReads) {
  write_text(at("sets/summary.json"), R"({"layout": "shrec11", "root": "../data"})");
  write_text(at("own/manifest.json"), R"({"name": "own", "dataset": "../sets/summary.json",
    "signatures": [{"name": "d2", "descriptor": {"type": "d2"}}]})");
  const auto refusal = [&](const std::string& file) { return "would overwrite the input " + at(file).string(); };
  expect_error_lines(
      {{"run " + quoted("own/manifest.json") + " -o " + quoted("own"), refusal("own/manifest.json")},
       {"run " + quoted("own/manifest.json") + " -o " + quoted("sets"), "would overwrite the input "},
       {"run " + quoted("small.json") + " -o " + quoted("sets") + " --set dataset=" + quoted("sets/summary.json"),
        refusal("sets/summary.json")},
       {"run " + quoted("small.json") + " -o " + quoted("data"), refusal("data")}});
  EXPECT_FALSE(fs::exists(at("sets/manifest.json")));
  ASSERT_EQ(run_small().status, 0);
  expect_error_line(run("run --replay @out/manifest.json -o @out"), "would overwrite the input");
}

TEST_F(RunCommand, ReportsTheNumberOfModelsWithGapsWiderThanTheOffset) {
  Shape open_box = test::small_shape("box", 0);
  open_box.triangles = open_box.triangles.bottomRows(open_box.triangles.rows() - 8).eval();
  write_off(at("data/T1.off"), open_box);
  const std::string field = R"(--set 'signatures.0.field={"type":"offset_sdf","offset":0.005}')";
  const Outcome outcome = succeeded(run_small(field));
  EXPECT_THAT(outcome.errors, HasSubstr("warning: 1 of 9 shapes have gaps wider than the offset of the field "));
  EXPECT_THAT(text_of(at("out/report.html")), HasSubstr("1 of 9 shapes have gaps wider than the offset"));
  const auto fields = nlohmann::json::parse(text_of(at("out/manifest.json")))["fields"];
  EXPECT_EQ(fields[0]["shapes_with_gaps_wider_than_offset"], 1);
  EXPECT_FALSE(fields[1].contains("shapes_with_gaps_wider_than_offset")) << "the cone has no offset";
  EXPECT_THAT(
      run_small("--replace " + field + R"( --set 'perturbations=[{"type":"remove_faces","fraction":0.3}]')").errors,
      HasSubstr("have the outside on both sides"));
  EXPECT_EQ(run_small("--replace --set 'signatures.0.field={\"type\":\"offset_sdf\",\"offset\":\"auto\"}'").errors, "")
      << "auto closes the opening";
}

TEST_F(RunCommand, ShapeComparisonReportsShapesWithGapsWiderThanTheOffset) {
  write_text(at("comparison.json"), R"({"name": "two", "reference": "a", "shapes": [
    {"name": "a", "file": "data/T0.off"},
    {"name": "b", "file": "data/T0.off", "perturbations": [{"type": "remove_faces", "fraction": 0.3}]}],
    "signatures": [
    {"name": "offset", "field": {"type": "offset_sdf", "offset": 0.005}, "histogram": {"range": "per-shape"}}]})");
  const Outcome outcome = succeeded(run("run @comparison.json --output @two"));
  EXPECT_THAT(outcome.errors, HasSubstr("warning: 1 of 2 shapes have gaps wider than the offset of the field "));
  EXPECT_THAT(text_of(at("two/summary.md")), HasSubstr("1 of 2 shapes have gaps wider than the offset"));
  EXPECT_EQ(nlohmann::json::parse(text_of(at("two/manifest.json")))["fields"][0]["shapes_with_gaps_wider_than_offset"],
            1);
}

TEST_F(RunCommand, WritesNoResultsIfInterrupted) {
  // Very many rays from larger spheres take several seconds.
  for (const char* model : {"T0.off", "T3.off", "T6.off"}) write_off(at("data") / model, test::sphere(1, 3));
  BackgroundRun run({"run", at("small.json").string(), "--output", at("out").string(), "--no-cache", "--threads", "1",
                     "--set", "signatures.0.field.rays=10000"},
                    at("errors"));
  ASSERT_TRUE(run.wait_until([&] { return fs::exists(at("out")); })) << text_of(at("errors"));
  run.send(SIGINT);
  EXPECT_EQ(run.wait(), 130);
  EXPECT_EQ(text_of(at("errors")), "shapegauge: error: interrupted; no results were written\n");
  EXPECT_TRUE(fs::is_empty(at("out")));
}

}  // namespace

}  // namespace shapegauge::test_command_line
