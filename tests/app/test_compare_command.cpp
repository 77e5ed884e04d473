// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <string>

#include "shapegauge/datasets/files/npy.h"
#include "tests/app/program.h"
#include "tests/support/test_files.h"

namespace shapegauge::test_command_line {

namespace {

using test::text_of;
using test::write_text;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// Ten classes of six models on a line, seen with little noise (good.npy), and with much (bad.npy, poor.npy).
class CompareCommand : public CommandTest {
 protected:
  void SetUp() override {
    std::string table = "id,class\n";
    for (int i = 0; i < 60; ++i) table += std::to_string(i) + ",c" + std::to_string(i / 6) + "\n";
    write_text(at("labels.csv"), table);
    write_noisy("good.npy", 0.1, 1);
    write_noisy("bad.npy", 3, 2);
    write_noisy("poor.npy", 3, 3);
  }
  [[nodiscard]] Outcome compare(const std::string& inputs, const std::string& more = "") const {
    std::string arguments = "compare";
    std::istringstream names(inputs);
    for (std::string name; names >> name;) arguments += " " + quoted(name);
    return run(arguments + " " + more);
  }
  [[nodiscard]] Outcome compare_matrices(const std::string& inputs, const std::string& more = "") const {
    return compare(inputs, "--labels @labels.csv " + more);
  }

 private:
  void write_noisy(const std::string& name, double noise, unsigned seed) const {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0, noise);
    Eigen::VectorXd positions(60);
    for (int i = 0; i < 60; ++i) positions[i] = i / 6 + normal(random);
    write_npy(at(name), DistanceMatrix::NullaryExpr(60, 60, [&](Eigen::Index i, Eigen::Index j) {
                return std::abs(positions[i] - positions[j]);
              }));
  }
};

TEST_F(CompareCommand, ReportsASignificantDifferenceBetweenAGoodAndABadMethod) {
  const Outcome outcome = succeeded(compare_matrices("good.npy bad.npy poor.npy", "--measures FT,NN --format json"));
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["protocol"], "psb");
  EXPECT_EQ(json["blocks"], "queries");
  EXPECT_EQ(json["units"], 60);
  EXPECT_EQ(json["queries"], 60);
  const auto& pairs = json["measures"]["FT"]["pairs"];
  ASSERT_EQ(pairs.size(), 3U);
  EXPECT_EQ(pairs[0]["first"], "good");
  EXPECT_GT(pairs[0]["difference"], 0.3);
  EXPECT_LT(pairs[0]["p_holm"], 0.05);
  EXPECT_LT(pairs[0]["p_classes"], 0.05);
  EXPECT_GT(pairs[2]["p"], 0.05);
  EXPECT_EQ(pairs[0]["wins"].get<int>() + pairs[0]["ties"].get<int>() + pairs[0]["losses"].get<int>(), 60);
}

TEST_F(CompareCommand, ScoresPerQueryGiveTheSameOutputAsDistanceMatrices) {
  for (const std::string name : {"good", "bad"}) {
    ASSERT_EQ(
        run("evaluate " + quoted(name + ".npy") + " --labels @labels.csv --per-query " + quoted(name + ".csv")).status,
        0);
  }
  const Outcome tables = succeeded(compare("good.csv bad.csv", "--format csv"));
  EXPECT_EQ(tables.output, compare_matrices("good.npy bad.npy", "--format csv").output);
  EXPECT_EQ(compare("good.csv bad.csv", "--format json").output,
            compare_matrices("good.npy bad.npy", "--format json").output);  // to the last digit
}

TEST_F(CompareCommand, ReferenceOptionComparesOnlyPairsWithTheReferenceMethod) {
  write_text(at("results/per_query.csv"),
             "method,protocol,id,class,NN\n"
             "m,psb,1,x,100\nm,psb,2,y,0\nn,psb,1,x,0\nn,psb,2,y,100\no,psb,1,x,0\no,psb,2,y,0\n"
             "m,paper,1,x,100\nm,paper,2,y,0\nn,paper,1,x,0\nn,paper,2,y,100\n");
  EXPECT_EQ(nlohmann::json::parse(compare("results", "--format json").output)["measures"]["NN"]["pairs"].size(), 3U);
  const auto with_reference = nlohmann::json::parse(compare("results", "--format json --reference o").output);
  EXPECT_EQ(with_reference["measures"]["NN"]["pairs"].size(), 2U);
  EXPECT_EQ(with_reference["measures"]["NN"]["pairs"][0]["first"], "o");
  EXPECT_EQ(nlohmann::json::parse(compare("results", "--format json --protocol paper").output)["protocol"], "paper");
}

TEST_F(CompareCommand, WritesChartsAndAReportOnRequest) {
  const Outcome outcome = succeeded(compare_matrices(
      "good.npy bad.npy",
      "--measures FT --names ours,theirs --plot @pr.svg --plot-scores @scores.svg --pr @pr.csv --report @all.html"));
  EXPECT_THAT(text_of(at("pr.svg")), AllOf(HasSubstr(">Recall<"), HasSubstr(">ours<"), HasSubstr(">theirs<")));
  EXPECT_THAT(text_of(at("scores.svg")), AllOf(HasSubstr(">FT<"), HasSubstr(">theirs<")));
  EXPECT_THAT(text_of(at("pr.csv")),
              AllOf(StartsWith("method,protocol,recall,precision\nours,psb,0.05,"), HasSubstr("\ntheirs,psb,1,")));
  EXPECT_THAT(text_of(at("all.html")), AllOf(HasSubstr("ours"), HasSubstr("theirs")));
}

TEST_F(CompareCommand, WritesThePrecisionRecallCurvesStoredInARunFolder) {
  write_text(at("results/per_query.csv"),
             "method,protocol,id,class,NN\nm,psb,1,x,100\nm,psb,2,y,0\nn,psb,1,x,0\nn,psb,2,y,100\n");
  write_text(at("results/pr_curves.csv"),
             "method,protocol,recall,precision,macro_precision\nm,psb,0.5,0.75,0.7\nn,psb,0.5,0.25,0.2\n"
             "m,paper,0.5,1,1\n");
  ASSERT_EQ(compare("results", "--pr @pr.csv").status, 0);
  EXPECT_EQ(text_of(at("pr.csv")), "method,protocol,recall,precision\nm,psb,0.5,0.750000\nn,psb,0.5,0.250000\n");
}

TEST_F(CompareCommand, DoesNotOverwriteInputs) {
  write_text(at("results/per_query.csv"),
             "method,protocol,id,class,NN\nm,psb,1,x,100\nm,psb,2,y,0\nn,psb,1,x,0\nn,psb,2,y,100\n");
  write_text(at("results/pr_curves.csv"), "method,protocol,recall,precision,macro_precision\nm,psb,0.5,0.75,0.7\n");
  write_text(at("other.csv"), "1\n");
  const auto refused = [&](const Outcome& outcome, const std::string& name) {
    expect_error_line(outcome, "would overwrite the input " + at(name).string());
  };
  const auto replacing = [&](const std::string& name) { return "--replace --pr " + quoted(name) + " "; };
  refused(compare_matrices("good.npy bad.npy", replacing("labels.csv")), "labels.csv");
  for (const std::string option : {"--qrels", "--ids", "--targets"}) {
    refused(compare("good.npy bad.npy", replacing("other.csv") + option + " @other.csv"), "other.csv");
  }
  for (const std::string name : {"results/per_query.csv", "results/pr_curves.csv"}) {
    refused(compare("results", replacing(name)), name);
  }
}

TEST_F(CompareCommand, PValuesDependOnSeedAndTestButNotOnThreads) {
  const auto p = [&](const std::string& more) {
    return nlohmann::json::parse(compare_matrices("bad.npy poor.npy", "--measures FT --format json " + more)
                                     .output)["measures"]["FT"]["pairs"][0]["p"]
        .get<double>();
  };
  EXPECT_EQ(p(""), p(""));
  EXPECT_NE(p("--seed 7"), p("--seed 8"));
  EXPECT_NE(p("--test t"), p(""));
  EXPECT_EQ(p("--test randomization"), p("--test randomisation"));
  EXPECT_NE(p("--blocks classes"), p(""));
}

TEST_F(CompareCommand, RejectsMissingFilesSingleMethodsAndUnknownMeasures) {
  write_text(at("one.csv"), "method,protocol,id,class,NN\nm,psb,1,x,100\nm,psb,2,y,0\n");
  write_text(at("class.csv"), "method,protocol,id,class,NN\nm,psb,1,x,100\nm,psb,2,x,0\nn,psb,1,x,100\nn,psb,2,x,0\n");
  const std::vector<std::pair<Outcome, std::string>> cases{
      {compare("one.csv"), "two methods"},
      {compare("good.npy bad.npy"), "good.npy"},
      {compare("nowhere"), "nowhere"},
      {compare("class.csv", "--blocks classes"), "needs at least two classes"},
      {compare_matrices("good.npy bad.npy", "--reference god"), "did you mean \"good\"?"},
      {compare_matrices("good.npy bad.npy", "--measures FT,XX"), "no measure \"XX\""},
      {compare_matrices("good.npy bad.npy", "--test u"), "--test"}};
  for (const auto& [outcome, words] : cases) expect_error_line(outcome, words);
}

TEST_F(CompareCommand, RejectsEvaluationOptionsForTablesOfScores) {
  std::string scores = "method,protocol,id,class,NN\n";
  for (int i = 0; i < 60; ++i) scores += fmt::format("m,psb,{0},c{1},{2}\nn,psb,{0},c{1},0\n", i, i / 6, i % 2 * 100);
  write_text(at("results/per_query.csv"), scores);
  write_text(at("results/summary.json"), R"({"ties": "expected"})");
  ASSERT_EQ(compare("results").status, 0);
  for (const std::string option : {"--ties index", "--min-class-size 3", "--similarity", "--distance l1", "--level 1",
                                   "--missing-queries zero", "--ids absent.txt", "--labels absent.csv"}) {
    expect_error_line(compare("results", option), option.substr(0, option.find(' ')));
  }
  expect_error_line(compare("results", "--protocol paper"), "--protocol");
  expect_error_line(compare_matrices("results good.npy", "--measures NN --ties index"), "--ties expected");
  expect_error_line(compare_matrices("results good.npy", "--measures NN --ties expected --report @r.html"), "--report");
  EXPECT_EQ(compare_matrices("results good.npy", "--measures NN --ties expected").status, 0);
}

TEST_F(CompareCommand, WarnsIfClassesAreTooFewForSignificance) {
  std::string table = "id,class\n";
  for (int i = 0; i < 60; ++i) table += std::to_string(i) + ",c" + std::to_string(i / 20) + "\n";
  write_text(at("three.csv"), table);
  const std::string more = "--labels " + quoted("three.csv") + " --measures FT --format json ";
  const Outcome outcome = compare("good.npy bad.npy", more + "--blocks classes ");
  EXPECT_THAT(outcome.errors, AllOf(HasSubstr("3 classes"), HasSubstr("below 0.25"), HasSubstr("--blocks queries")));
  EXPECT_EQ(nlohmann::json::parse(outcome.output)["smallest_p"], 0.25);
  EXPECT_THAT(compare("good.npy bad.npy", more + "--blocks classes --test t").errors,
              testing::Not(HasSubstr("p-value")));
  EXPECT_THAT(compare("good.npy bad.npy", more).errors, AllOf(HasSubstr("3 classes"), HasSubstr("p_classes")));
  EXPECT_THAT(compare_matrices("good.npy bad.npy").errors, testing::Not(HasSubstr("p-value")));
}

TEST_F(CompareCommand, GivesFilesOfTheSameNameUniqueMethodNames) {
  std::filesystem::create_directory(at("x"));
  std::filesystem::copy_file(at("bad.npy"), at("x/good.npy"));
  const auto names = [&](const std::string& inputs, const std::string& more = "") {
    const auto json = nlohmann::json::parse(compare_matrices(inputs, "--measures FT --format json " + more).output);
    std::vector<std::string> found;
    for (const auto& method : json["measures"]["FT"]["methods"]) found.push_back(method["method"]);
    return found;
  };
  const std::vector<std::string> unique = names("good.npy x/good.npy");
  EXPECT_EQ(unique[1], "x/good");
  EXPECT_THAT(unique[0], AllOf(testing::EndsWith("/good"), testing::Ne("x/good")));
  EXPECT_THAT(names("good.npy x/good.npy", "--names ours,theirs"), testing::ElementsAre("ours", "theirs"));
  EXPECT_THAT(compare_matrices("good.npy good.npy").errors, HasSubstr("are the same file"));
  expect_error_line(compare_matrices("good.npy bad.npy", "--names ours"), "1 names for 2 methods");
}

TEST(MeasuresCommand, ListsEveryRegisteredMeasureOnce) {
  const auto json = nlohmann::json::parse(run_executable("measures --format json").output);
  EXPECT_EQ(json[0]["name"], "NN");
  std::set<std::string> names;
  for (const auto& measure : json) names.insert(measure["name"]);
  EXPECT_EQ(names.size(), json.size());
  EXPECT_THAT(names, testing::IsSupersetOf({"FT", "DCG", "P@k", "nDCG", "Rand", "CD", "GCE"}));
}

}  // namespace

}  // namespace shapegauge::test_command_line
