// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <filesystem>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"
#include "tests/support/small_dataset.h"
#include "tests/support/test_files.h"

namespace shapegauge::test_command_line {

namespace {

using test::write_text;
using testing::HasSubstr;

class DatasetCommand : public CommandTest {
 protected:
  void SetUp() override { test::write_small_dataset(folder_.path()); }
  [[nodiscard]] Outcome dataset(const std::string& command) const {
    return run("dataset " + command + " '" + folder_.path().string() + "'");
  }
};

TEST_F(DatasetCommand, InfoPrintsAConfigurationForTheDataSet) {
  const std::string output = dataset("info").output;
  const std::string key = "\"dataset\": ";
  const std::size_t begin = output.find(key);
  ASSERT_NE(begin, std::string::npos);
  const auto proposed = nlohmann::json::parse(output.substr(begin + key.size()));
  EXPECT_EQ(proposed,
            (nlohmann::json{{"layout", "shrec11"}, {"root", folder_.path().string()}, {"classification", "test.cla"}}));
}

TEST_F(DatasetCommand, InfoCountsUnusableModels) {
  EXPECT_THAT(dataset("info").output, testing::Not(HasSubstr("unusable")));
  write_text(at("T2.off"), "garbage");
  write_text(at("T4.off"), "more garbage");
  const Outcome outcome = dataset("info");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.output, HasSubstr("9 models in 3 classes, 2 of them unusable"));
  EXPECT_THAT(outcome.output, testing::ContainsRegex("sphere +3 +0\n"));
  EXPECT_THAT(outcome.output, testing::ContainsRegex("box +3 +1\n"));
  EXPECT_THAT(outcome.output, testing::ContainsRegex("capsule +3 +1\n"));
  EXPECT_THAT(outcome.errors, HasSubstr("warning: model 2: "));
}

TEST_F(DatasetCommand, InfoCountsSkippedFiles) {
  EXPECT_THAT(dataset("info").output, testing::Not(HasSubstr("skipped")));
  std::filesystem::create_directories(at("classes/box/old"));
  std::filesystem::copy(at("T1.off"), at("classes/box/T1.off"));
  write_text(at("classes/box/T1.mtl"), "newmtl x");
  const Outcome outcome = succeeded(run("dataset info @classes"));
  EXPECT_THAT(outcome.output, HasSubstr("\nskipped: 1 file that is not a shape, 1 folder\n"));
}

TEST_F(DatasetCommand, InfoCountsOnlyTheModelsOfTheRequestedSplit) {
  for (const char* name : {"bed/train/1.off", "bed/test/2.off", "bed/test/3.off", "sofa/test/4.off"}) {
    write_text(at("parts/" + std::string(name)), test::text_of(at("T0.off")));
  }
  const Outcome outcome = succeeded(run("dataset info @parts --split test"));
  EXPECT_THAT(outcome.output, HasSubstr("layout folders: 3 models in 2 classes"));
  EXPECT_THAT(outcome.output, HasSubstr("\"split\":\"test\""));
  const Outcome without = run("dataset info @ --split test");
  EXPECT_EQ(without.status, 2);
  EXPECT_THAT(without.errors, HasSubstr("the layout shrec11 has no splits"));
}

TEST_F(DatasetCommand, LabelsOfASplitAreAcceptedByTheEvaluateCommand) {
  write_text(at("all.csv"),
             "id,synsetId,subSynsetId,modelId,split\n000001,7,7,a,test\n000002,7,8,b,test\n000003,9,9,c,train\n");
  const std::string command = "dataset labels @ --layout shapenet --split test";
  EXPECT_EQ(run(command).output, "id,class,subclass\n000001,7,\n000002,7,8\n");
  ASSERT_EQ(run(command + " -o @labels.csv").status, 0);
  write_text(at("lists/000001"), "000001 0\n000002 0.5\n");
  write_text(at("lists/000002"), "000002 0\n");
  const Outcome outcome = succeeded(
      run("evaluate @lists --labels @labels.csv --protocol paper --measures P@N,R@N,F1@N,mAP@N,nDCG@N --format csv "
          "--unit fraction --digits 4"));
  // Query 1 finds both, with the grades 3 and 1; query 2 finds itself only, not the model of grade 2.
  EXPECT_THAT(outcome.output, HasSubstr("lists,paper,micro,1.0000,0.7500,0.8333,0.7500,0.8000\n"));
  EXPECT_EQ(run(command + " -o @labels.csv").status, 2) << "exists";
}

TEST_F(DatasetCommand, ValidateNamesUnusableModels) {
  EXPECT_EQ(dataset("validate").output, "9 of 9 models can be used\n");
  write_text(at("T2.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
  const Outcome outcome = dataset("validate");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.output, HasSubstr("2: "));
  EXPECT_THAT(outcome.output, HasSubstr("8 of 9 models can be used\n"));
}

TEST_F(DatasetCommand, InfoAndValidateRejectAMissingFolder) {
  for (const std::string command : {"info", "validate"}) {
    const Outcome outcome = run("dataset " + command + " /nowhere");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.errors, HasSubstr("/nowhere: no such folder"));
  }
}

TEST_F(DatasetCommand, ReportsIncompleteDataSetIfGenerationIsInterrupted) {
  BackgroundRun run(
      {"dataset", "generate", at("made"), "--classes", "1", "--models-per-class", "500", "--threads", "1"},
      at("errors"));
  ASSERT_TRUE(
      run.wait_until([&] { return std::filesystem::exists(at("made")) && !std::filesystem::is_empty(at("made")); }));
  run.send(SIGINT);
  EXPECT_EQ(run.wait(), 130);
  EXPECT_EQ(test::text_of(at("errors")), "shapegauge: error: interrupted; the data set in " + at("made").string() +
                                             " is incomplete; --replace replaces it\n");
}

TEST_F(DatasetCommand, GenerateWritesUsableModelsAndRefusesToReplaceADataSet) {
  const Outcome generated = succeeded(run("dataset generate @made --classes 2 --models-per-class 2 --faces 1000"));
  EXPECT_THAT(generated.output, HasSubstr("4 models of 2 classes"));
  EXPECT_THAT(run("dataset validate @made").output, HasSubstr("4 of 4 models"));
  EXPECT_EQ(run("dataset generate @made --classes 2").status, 2);
}

}  // namespace

}  // namespace shapegauge::test_command_line
