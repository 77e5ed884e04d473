// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/datasets/files/npy.h"
#include "tests/app/program.h"
#include "tests/datasets/files/write_matrix.h"
#include "tests/support/test_files.h"

namespace shapegauge::test_command_line {

namespace {

using test::text_of;
using test::write_text;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

/// The example of the known answers: A = values 0, 1, 4 and B = values 2, 3.5, 7, 9 on a line, in that order.
class EvaluateCommand : public CommandTest {
 protected:
  void SetUp() override {
    const Eigen::VectorXd values{{0, 1, 4, 2, 3.5, 7, 9}};
    DistanceMatrix distances(7, 7);
    std::string text;
    for (int i = 0; i < 7; ++i) {
      for (int j = 0; j < 7; ++j) {
        distances(i, j) = std::abs(values[i] - values[j]);
        text += std::to_string(distances(i, j)) + (j < 6 ? " " : "\n");
      }
    }
    write_npy(at("toy.npy"), distances);
    write_psb_matrix(at("toy.matrix"), distances);
    write_text(at("toy.txt"), text);
    write_text(at("toy.cla"), "PSB 1\n2 7\nA 0 3\n0\n1\n2\nB 0 4\n3\n4\n5\n6\n");
  }
  [[nodiscard]] Outcome evaluate_toy(const std::string& more, const std::string& matrix = "toy.npy") const {
    return run("evaluate " + quoted(matrix) + " --labels @toy.cla " + more);
  }
};

TEST_F(EvaluateCommand, MatrixFromStandardInputScoresTheSameAsFromAFile) {
  const nlohmann::json of_file = nlohmann::json::parse(evaluate_toy("--format json").output);
  for (const std::string format : {"npy", "matrix", "txt"}) {
    const std::string format_option =
        format == "npy" ? "" : " --input-format " + format;  // .npy is recognized by its contents
    const Outcome piped =
        succeeded(run("evaluate - --labels @toy.cla --format json" + format_option + " < " + quoted("toy." + format)));
    const nlohmann::json json = nlohmann::json::parse(piped.output);
    EXPECT_EQ(json.at("file"), "-");
    EXPECT_EQ(json.at("method"), "standard input");
    for (const char* const key : {"micro", "macro", "per_class", "queries"}) {
      EXPECT_EQ(json.value(key, nlohmann::json()), of_file.value(key, nlohmann::json())) << key;
    }
    EXPECT_TRUE(json.contains("micro"));
  }
  expect_error_lines({{"evaluate - --labels " + quoted("toy.cla") + " < /dev/null", "standard input is empty"},
                      {"evaluate - --labels " + quoted("toy.cla") + " < " + quoted("toy.cla"),
                       "standard input:1: \"PSB 1\" is neither a number"},
                      {"evaluate " + quoted("toy.npy") + " --labels " + quoted("toy.cla") + " --input-format npy",
                       "standard input (-)"}});
}

TEST_F(EvaluateCommand, SevenModelMatrixHasItsKnownScoresInEveryFileFormat) {
  for (const char* matrix : {"toy.npy", "toy.matrix", "toy.txt"}) {
    const Outcome outcome = succeeded(evaluate_toy("--format json", matrix));
    EXPECT_EQ(outcome.errors, "");
    const auto json = nlohmann::json::parse(outcome.output);
    EXPECT_EQ(json["protocol"], "psb");
    EXPECT_EQ(json["ties"], "index");
    EXPECT_EQ(json["queries"], 7);
    EXPECT_NEAR(json["micro"]["NN"], .571429, 1e-6);
    EXPECT_NEAR(json["micro"]["FT"], .428571, 1e-6);
    EXPECT_NEAR(json["micro"]["ST"], .928571, 1e-6);
    EXPECT_NEAR(json["micro"]["E"], .595238, 1e-6);
    EXPECT_NEAR(json["micro"]["DCG"], .718910, 1e-6);
    EXPECT_TRUE(json["per_class"].contains("B"));
  }
}

TEST_F(EvaluateCommand, PrintsEqualMicroAndMacroAveragesAsOneRow) {
  const std::string equal = evaluate_toy("--measures P@3 --min-class-size 4").output;  // one class
  EXPECT_THAT(equal, testing::AllOf(HasSubstr("toy     psb       both "), testing::Not(HasSubstr("macro"))));
}

TEST_F(EvaluateCommand, WritesAnHtmlReportOfTheMatrix) {
  const Outcome outcome = succeeded(evaluate_toy("--report @report.html"));
  EXPECT_EQ(outcome.output, evaluate_toy("").output);
  const std::string page = text_of(at("report.html"));
  EXPECT_THAT(page, StartsWith("<!DOCTYPE html>"));
  EXPECT_THAT(page, HasSubstr("<title>toy – shapegauge report</title>"));
  EXPECT_THAT(page, HasSubstr(R"("classes":["A","B"],"ids":["0","1","2","3","4","5","6"],"labels":[0,0,0,1,1,1,1])"));
  const Outcome nowhere = evaluate_toy("--report @no_folder/report.html");
  EXPECT_EQ(nowhere.status, 2);
  EXPECT_THAT(nowhere.errors, HasSubstr("cannot write"));
}

TEST_F(EvaluateCommand, FeaturesHaveTheScoresOfTheirDistanceMatrix) {
  // The toy's values as features: the same figures and notes, by rows or (for the report) by the whole matrix.
  write_text(at("toy.csv"), "0\n1\n4\n2\n3.5\n7\n9\n");
  const Outcome expected = evaluate_toy("--per-query @matrix.csv");
  const Outcome by_rows = evaluate_toy("--distance l1 --per-query @rows.csv", "toy.csv");
  const Outcome whole = evaluate_toy("--distance l1 --report @report.html", "toy.csv");
  ASSERT_EQ(by_rows.status, 0) << by_rows.errors;
  EXPECT_EQ(by_rows.output, expected.output);
  EXPECT_EQ(by_rows.errors, expected.errors);
  EXPECT_EQ(text_of(at("rows.csv")), text_of(at("matrix.csv")));
  EXPECT_EQ(whole.output, expected.output);
  EXPECT_THAT(text_of(at("report.html")), HasSubstr("\"heat_map\":{\"side\":7"));
}

TEST_F(EvaluateCommand, MatchesRowsToLabelsByTheirIds) {
  // The same matrix with permuted models: other rows have labels A and B.
  write_text(at("ids.txt"), "T6\nT5\nT4\nT3\n2.off\n1\n0\n");
  const auto json = nlohmann::json::parse(evaluate_toy("--format json --ids @ids.txt").output);
  // Now B = 0, 1, 4, 2 and A = 3.5, 7, 9; nearest others: 1, 0, 3.5, 1, 4, 9, 7: right for 5 of 7 (0, 1, 2, 7, 9).
  EXPECT_NEAR(json["micro"]["NN"], 5.0 / 7, 1e-12);
}

TEST_F(EvaluateCommand, OrderOptionSelectsNaturalOrFileOrderOfRows) {
  // Princeton's tools take the rows in the classification's order: the first four rows are of class B then.
  write_text(at("listed.cla"), "PSB 1\n2 7\nB 0 4\n3\n4\n5\n6\nA 0 3\n0\n1\n2\n");
  const auto nn = [&](const std::string& order) {
    const std::string arguments =
        "evaluate " + quoted("toy.npy") + " --labels " + quoted("listed.cla") + " --format json";
    return nlohmann::json::parse(run(arguments + order).output)["micro"]["NN"].get<double>();
  };
  EXPECT_NEAR(nn(" --order classification"), 5.0 / 7, 1e-12);
  EXPECT_NEAR(nn(" --order file"), 5.0 / 7, 1e-12);
  EXPECT_NEAR(nn(""), .571429, 1e-6);
}

TEST_F(EvaluateCommand, ReportsClassesExcludedByTheMinimumSize) {
  const Outcome outcome = succeeded(evaluate_toy("--format json --min-class-size 4"));
  EXPECT_EQ(nlohmann::json::parse(outcome.output)["queries"], 4);
  EXPECT_THAT(outcome.errors, HasSubstr("omitted as queries: 3 models"));
}

TEST_F(EvaluateCommand, WritesPrecisionRecallCurvesAndScoresPerQueryAndClass) {
  ASSERT_EQ(
      evaluate_toy(
          "--pr @pr.plot --curve trec --pr-per-class @classes.csv --per-query @queries.csv --per-class @per_class.csv")
          .status,
      0);
  EXPECT_THAT(text_of(at("pr.plot")), MatchesRegex("0.000000\t[^\n]*\n(.*\n)*1.000000\t[^\n]*\n"));
  EXPECT_THAT(text_of(at("classes.csv")), StartsWith("method,protocol,class,recall,precision\ntoy,psb,A,0,"));
  EXPECT_THAT(text_of(at("queries.csv")), StartsWith("method,protocol,id,class,NN,FT,ST,E,DCG,mAP\ntoy,psb,0,A,100"));
  EXPECT_THAT(text_of(at("per_class.csv")), StartsWith("method,protocol,class,queries,NN"));
}

TEST_F(EvaluateCommand, PrintsTheRequestedMeasuresUnitAndConfidenceIntervals) {
  EXPECT_THAT(evaluate_toy("--measures P@2,FT --unit fraction --digits 3 --format csv").output,
              StartsWith("method,protocol,average,P@2,FT\ntoy,psb,micro,0."));
  EXPECT_THAT(evaluate_toy("--measures NN --fractions --format csv").output, HasSubstr("toy,psb,micro,0.571429\n"));
  const auto json = nlohmann::json::parse(evaluate_toy("--format json --confidence 0.9 --measures FT").output);
  EXPECT_LE(json["intervals"]["micro"]["FT"][0], json["micro"]["FT"]);
  EXPECT_GE(json["intervals"]["micro"]["FT"][1], json["micro"]["FT"]);
  EXPECT_THAT(evaluate_toy("--confidence 0.9 --measures FT --blocks queries").output, HasSubstr("42.86 ["));
}

TEST_F(EvaluateCommand, CountsQueriesWithTiesAndOrdersTiesByTheTiesOption) {
  write_text(at("tied.txt"), "0 1 1\n1 0 1\n1 1 0\n");
  write_text(at("three.csv"), "id,class\n1,a\n2,a\n3,b\n");
  const auto nn = [&](const std::string& ties) {
    const Outcome outcome = run("evaluate @tied.txt --labels @three.csv --format json --ties " + ties);
    EXPECT_THAT(outcome.errors, HasSubstr("3 rows have all distances equal"));
    const auto json = nlohmann::json::parse(outcome.output);
    EXPECT_EQ(json["ties"], ties);
    EXPECT_EQ(json["queries_with_ties"], 2);
    return json["micro"]["NN"].get<double>();
  };
  EXPECT_THAT(evaluate_toy("").errors,
              HasSubstr("warning: the answers to 3 of 7 queries have relevant and other models"));
  EXPECT_EQ(nn("index"), 1);
  EXPECT_EQ(nn("pessimistic"), 0);
  EXPECT_EQ(nn("expected"), 0.5);
}

TEST_F(EvaluateCommand, WarnsOfNegativeAndAsymmetricDistances) {
  write_text(at("odd.txt"), "0 1 2\n1 0 -3\n2 4 0\n");
  write_text(at("three.csv"), "id,class\n1,a\n2,a\n3,b\n");
  const Outcome outcome = succeeded(run("evaluate @odd.txt --labels @three.csv"));
  EXPECT_THAT(outcome.errors,
              testing::AllOf(HasSubstr("warning: 1 distance is negative"), HasSubstr("not symmetric: 1 pair")));
}

TEST_F(EvaluateCommand, DoesNotOverwriteTheRankedListsOfAFolder) {
  write_text(at("lists/0"), "1\n");
  write_text(at("lists/1.csv"), "0\n");
  expect_error_line(evaluate_toy("--replace --per-query @lists/1.csv", "lists"), "would overwrite the input");
  EXPECT_EQ(text_of(at("lists/1.csv")), "0\n");
}

TEST_F(EvaluateCommand, SingleClassHasScoreOneAndNoConfidenceIntervals) {
  write_text(at("same.csv"), "id,class\n0,a\n1,a\n2,a\n3,a\n4,a\n5,a\n6,a\n");
  const Outcome outcome = succeeded(run("evaluate @toy.npy --labels @same.csv --confidence 0.95 --format json"));
  EXPECT_THAT(outcome.errors, HasSubstr("fewer than two classes"));
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["micro"]["mAP"], 1);
  EXPECT_FALSE(json.contains("intervals"));
}

TEST_F(EvaluateCommand, RejectsMissingOrInconsistentMatricesAndLabels) {
  write_text(at("short.txt"), "0 1\n1 0\n");
  write_text(at("nan.txt"), "0 nan\n1 0\n");
  write_text(at("absent.txt"), "0\n1\n2\n3\n4\n5\n7\n");
  write_text(at("empty.cla"), "");
  write_text(at("one.txt"), "0\n");
  write_text(at("one.csv"), "id,class\n1,a\n");
  const std::string toy = "evaluate " + quoted("toy.npy") + " ";
  const std::string labels = "--labels " + quoted("toy.cla") + " ";
  const std::vector<UnusableCall> cases{
      {toy, "--labels"},
      {toy + "--labels /nowhere.cla", "/nowhere.cla"},
      {toy + "--labels " + quoted("empty.cla"), "empty.cla"},
      {"evaluate /nowhere.npy " + labels, "/nowhere.npy"},
      {"evaluate " + quoted("short.txt") + " " + labels, "has 2 rows, but there are 7 models"},
      {"evaluate " + quoted("nan.txt") + " " + labels, "nan.txt"},
      {"evaluate " + quoted("nan.txt") + " " + quoted("nan.txt") + " " + labels, "shapegauge compare"},
      {"evaluate " + quoted("nan.txt") + " --level -1 " + labels, "--level"},
      {"evaluate " + quoted("nan.txt") + " --evaluator shrec21 --protocol psb " + labels, "--evaluator"},
      {"evaluate " + quoted("toy.cla") + " " + labels, "toy.cla"},
      {toy + labels + "--protocol pbs", "--protocol"},
      {toy + labels + "--format xml", "--format"},
      {toy + labels + "--min-class-size 5", "class"},
      {toy + labels + "--measures FT,F", "no measure \"F\""},
      {toy + labels + "--similarity --distance l1", "--similarity"},
      {toy + labels + "--level 1", "no level 1"},
      {toy + labels + "--ids " + quoted("absent.txt"), "toy.cla"},
      {toy + labels + "--pr /nowhere/pr.csv", "/nowhere/pr.csv"},
      {toy + labels + "--confidence nan", "--confidence"},
      {toy + labels + "--confidence 0.3", "--confidence"},
      {toy + labels + "--threads 0", "--threads"},
      {"evaluate " + quoted("one.txt") + " --labels " + quoted("one.csv"), "no class has 2 models"}};
  expect_error_lines(cases);
}

TEST_F(EvaluateCommand, OptionEachQueryPrintsTheScoresOfEveryQuery) {
  const Outcome table = evaluate_toy("--each-query --format csv --measures NN");
  EXPECT_THAT(table.output, StartsWith("method,protocol,id,class,NN\ntoy,psb,0,A,100.0000\n"));
  EXPECT_THAT(table.output, HasSubstr("\n\nmethod,protocol,average,NN\ntoy,psb,micro,57.1429\n"));
  const auto json = nlohmann::json::parse(evaluate_toy("--each-query --format json --measures NN").output);
  EXPECT_EQ(json["per_query"].size(), 7U);
  EXPECT_EQ(json["per_query"]["0"]["NN"], 1);
  expect_error_lines({{"evaluate " + quoted("toy.npy") + " --labels " + quoted("toy.cla") + " -q", "--each-query"}});
  EXPECT_EQ(evaluate_toy("--quiet --measures NN").output, evaluate_toy("--measures NN").output);
}

TEST_F(EvaluateCommand, WarnsOfMissingQueriesAndIncompleteRankedLists) {
  // Queries 0 to 3 of seven are answered, with the two models nearest to each; B has three relevant models.
  write_text(at("two.lists"), "0 1 3\n1 0 3\n2 4 3\n3 1 4\n");
  const auto evaluate = [&](const std::string& more) { return evaluate_toy("--format json " + more, "two.lists"); };
  const Outcome skipped = evaluate("");
  EXPECT_THAT(skipped.errors, HasSubstr("warning: 3 of 7 queries have no ranked list"));
  EXPECT_THAT(skipped.errors,
              HasSubstr("warning: 1 of 4 lists have fewer models than are relevant (lists of 2 models)"));
  EXPECT_THAT(skipped.errors, HasSubstr("warning: the lists have 2 of 7 models; the others count as not found"));
  const auto of_skipped = nlohmann::json::parse(skipped.output);
  EXPECT_EQ(of_skipped["lists"], nlohmann::json({{"queries", 7},
                                                 {"answered", 4},
                                                 {"missing_queries", "skip"},
                                                 {"shortest_list", 2},
                                                 {"longest_list", 2},
                                                 {"incomplete_lists", 1}}));
  EXPECT_EQ(of_skipped["queries"], 4);
  const Outcome zero = evaluate("--missing-queries zero");
  const auto of_zero = nlohmann::json::parse(zero.output);
  EXPECT_EQ(of_zero["queries"], 7);
  EXPECT_EQ(of_zero["lists"]["answered"], 4);
  EXPECT_EQ(of_zero["lists"]["missing_queries"], "zero");
  for (const char* const measure : {"NN", "FT", "DCG", "mAP"}) {
    EXPECT_NEAR(of_zero["micro"][measure].get<double>() * 7, of_skipped["micro"][measure].get<double>() * 4, 1e-12);
  }
  EXPECT_EQ(evaluate("-c").output, zero.output);
  EXPECT_THAT(evaluate("-c --missing-queries zero").errors, HasSubstr("--missing-queries excludes --all-queries"));
  EXPECT_THAT(run_executable("evaluate --help").output, testing::Not(HasSubstr("--all-queries"))) << "an older name";
  for (const char* option : {"-c", "--missing-queries zero"}) {
    EXPECT_THAT(evaluate_toy(option).errors, HasSubstr("--missing-queries zero applies to ranked lists only"));
  }
  EXPECT_FALSE(nlohmann::json::parse(evaluate_toy("--format json").output).contains("lists"));
}

/// Whether a text has the given number of warnings.
int warnings_in(const std::string& text) {
  int count = 0;
  for (std::size_t i = text.find("warning: "); i != std::string::npos; i = text.find("warning: ", i + 1)) ++count;
  return count;
}

TEST_F(EvaluateCommand, PlotsThePrecisionRecallCurveAndTheScoresOfClasses) {
  const Outcome outcome = succeeded(evaluate_toy("--measures FT --plot @pr.svg --plot-classes @classes.svg"));
  EXPECT_THAT(text_of(at("pr.svg")), AllOf(HasSubstr(">Recall<"), HasSubstr(">Precision<"), HasSubstr("<path")));
  EXPECT_THAT(text_of(at("classes.svg")), AllOf(HasSubstr(">A<"), HasSubstr(">B<"), HasSubstr("FT")));
  // Other distances have another curve, and the same ones the same.
  ASSERT_EQ(evaluate_toy("--plot @same.svg").status, 0);
  EXPECT_EQ(text_of(at("same.svg")), text_of(at("pr.svg")));
  EXPECT_EQ(evaluate_toy("--plot @pr.svg").status, 2);
  EXPECT_EQ(evaluate_toy("--plot @pr.svg --replace --similarity").status, 0);
  EXPECT_NE(text_of(at("same.svg")), text_of(at("pr.svg")));
}

TEST_F(EvaluateCommand, PrintsOneWarningPerKindOfMatrixAnomaly) {
  write_npy(at("zero.npy"), DistanceMatrix::Zero(7, 7));
  const Outcome outcome = evaluate_toy("", "zero.npy");
  EXPECT_EQ(warnings_in(outcome.errors), 1) << outcome.errors;
  EXPECT_THAT(outcome.errors, HasSubstr("7 rows have all distances equal"));
  DistanceMatrix mixed = DistanceMatrix::Zero(7, 7);  // some ties, too
  mixed.row(0) << 0, 1, 1, 1, 2, 3, 4;
  write_npy(at("mixed.npy"), mixed);
  const std::string errors = evaluate_toy("", "mixed.npy").errors;
  EXPECT_EQ(warnings_in(errors), 3) << errors;
  EXPECT_THAT(errors, HasSubstr("the answers to 7 of 7 queries"));
}

TEST_F(EvaluateCommand, ConfidenceIntervalsEqualThoseOfTheCompareCommand) {
  // Classes in another order than rows.
  write_text(at("toy.cla"), "PSB 1\n3 7\nC 0 2\n5\n6\nB 0 2\n3\n4\nA 0 3\n0\n1\n2\n");
  std::filesystem::copy_file(at("toy.npy"), at("copy.npy"));
  const auto alone = nlohmann::json::parse(evaluate_toy("--confidence 0.95 --format json").output);
  const auto compared =
      nlohmann::json::parse(run("compare @toy.npy @copy.npy --labels @toy.cla --blocks classes --format json").output);
  for (const char* const measure : {"NN", "FT", "DCG", "mAP"}) {
    EXPECT_EQ(compared["measures"][measure]["methods"][0]["interval"], alone["intervals"]["micro"][measure]) << measure;
  }
}

TEST_F(EvaluateCommand, JudgementsSelectTheTrecProtocolByDefault) {
  write_text(at("run.txt"), "q1 Q0 a 1 3 mine\nq1 Q0 b 2 2 mine\n");
  write_text(at("j.qrels"), "q1 0 b 1\nq2 0 a 1\n");
  const std::string call = "evaluate " + quoted("run.txt") + " --qrels " + quoted("j.qrels") + " --format json ";
  const auto json = nlohmann::json::parse(run(call).output);
  EXPECT_EQ(json["protocol"], "trec");
  EXPECT_EQ(json["method"], "mine");
  EXPECT_EQ(json["micro"]["mAP"], 0.5);
  EXPECT_EQ(nlohmann::json::parse(run(call + "-c").output)["micro"]["mAP"], 0.25);
  EXPECT_EQ(nlohmann::json::parse(run(call + "--protocol psb").output)["protocol"], "psb");
}

}  // namespace

}  // namespace shapegauge::test_command_line
