// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <limits>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/datasets/files/matrix_files.h"
#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/retrieval/descriptors/d2.h"
#include "shapegauge/retrieval/diffusion.h"
#include "shapegauge/retrieval/k_reciprocal.h"
#include "shapegauge/retrieval/query_expansion.h"
#include "shapegauge/retrieval/rerank.h"
#include "tests/app/program.h"
#include "tests/support/small_dataset.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge::test_command_line {

namespace {

using testing::HasSubstr;

class DescribeCommand : public CommandTest {
 protected:
  void SetUp() override {
    for (const char* name : {"sphere", "box", "capsule"})
      write_off(at(std::string(name) + ".off"), test::small_shape(name, 0));
  }
  [[nodiscard]] std::string shapes() const {
    return quoted("sphere.off") + " " + quoted("box.off") + " " + quoted("capsule.off");
  }
  [[nodiscard]] Outcome describe(const std::string& arguments) const {
    return run_executable(fmt::format("describe {} {}", shapes(), arguments));
  }
};

TEST_F(DescribeCommand, DistancesCommandGivesTheDescriptorDistancesOfWrittenFeatures) {
  ASSERT_EQ(describe(fmt::format("--descriptor d2 -o '{}'", at("f.csv").string())).status, 0);
  const auto distances = [&](const std::string& output, const std::string& distance) {
    return run_executable(
        fmt::format("distances '{}' -o '{}' --distance {}", at("f.csv").string(), at(output).string(), distance));
  };
  ASSERT_EQ(distances("d.csv", "d2").status, 0);
  ASSERT_EQ(distances("d.npy", "d2").status, 0);
  const LabelledTable with_ids = read_matrix(at("d.csv"), TableShape::square);
  EXPECT_EQ(with_ids.row_ids, (std::vector<std::string>{"sphere", "box", "capsule"}));
  EXPECT_EQ(with_ids.numbers, read_matrix(at("d.npy"), TableShape::square).numbers);
  const LabelledTable features = read_matrix(at("f.csv"), TableShape::any);
  EXPECT_EQ(with_ids.numbers, feature_distances("d2", features.numbers.cast<float>()));
  EXPECT_GT(with_ids.numbers(0, 1), 0);
  expect_error_lines(
      {{fmt::format("distances '{}' -o '{}' --distance d2", at("f.csv").string(), at("d.npy").string()), "exists"},
       {fmt::format("distances '{}' -o '{}' --distance d2", at("f.csv").string(), at("d.txt").string()), "d.txt"},
       {fmt::format("distances '{}' -o '{}' --distance light_field", at("f.csv").string(), at("e.npy").string()),
        "f.csv"},
       {fmt::format("distances '{}' -o '{}' --distance l3", at("f.csv").string(), at("e.npy").string()),
        "--distance"}});
}

TEST_F(DescribeCommand, WritesOneRowPerShape) {
  const std::string output = at("x.npy").string();
  succeeded(describe(fmt::format("--descriptor d2 --set bins=8 --set points=64 -o '{}'", output)));
  const DistanceMatrix rows = read_matrix(output, TableShape::any).numbers;
  ASSERT_EQ(rows.rows(), 3);
  const Shape box = prepare_shape(test::small_shape("box", 0), {}).shape;
  EXPECT_TRUE(rows.row(1).transpose().isApprox(d2(box, {.points = 64, .bins = 8}).cast<double>(), 1e-6));
}

TEST_F(DescribeCommand, BagOfFeaturesRowsSumToOneAndHaveShapeIds) {
  const std::string output = at("x.csv").string();
  succeeded(describe(fmt::format(
      "--descriptor bag_of_features --set words=4 --set 'fields=[{{\"type\":\"centricity\"}}]' -o '{}'", output)));
  const LabelledTable table = read_matrix(output, TableShape::any);
  EXPECT_THAT(table.row_ids, testing::ElementsAre("sphere", "box", "capsule"));
  ASSERT_EQ(table.numbers.cols(), 4);
  for (Eigen::Index i = 0; i < 3; ++i) EXPECT_NEAR(table.numbers.row(i).sum(), 1, 1e-5);
}

TEST_F(DescribeCommand, GivesFilesOfEqualNamesDifferentIds) {
  std::filesystem::create_directory(at("a"));
  std::filesystem::create_directory(at("b"));
  write_off(at("a/x.off"), test::small_shape("box", 0));
  write_off(at("b/x.off"), test::small_shape("box", 1));
  const auto ids = [&](const std::string& inputs) {
    succeeded(
        run_executable(fmt::format("describe {} --descriptor d2 --replace -o '{}'", inputs, at("x.csv").string())));
    return read_matrix(at("x.csv"), TableShape::any).row_ids;
  };
  const std::string a = fmt::format("'{}'", at("a/x.off").string());
  const std::string b = fmt::format("'{}'", at("b/x.off").string());
  EXPECT_THAT(ids(a + " " + b), testing::ElementsAre("a/x", "b/x"));
  EXPECT_THAT(ids(a), testing::ElementsAre("x"));
  expect_error_lines({{fmt::format("describe {} {} --descriptor d2 -o x.csv", a, a), "is repeated"}});
}

TEST_F(DescribeCommand, OmitsTheRowsOfShapesThatCannotBeDescribed) {
  test::write_text(at("box.off"), "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n");
  const std::string output = at("x.npy").string();
  const Outcome outcome = describe(fmt::format("--descriptor shape_dna -o '{}'", output));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.errors, HasSubstr("box.off"));
  EXPECT_EQ(read_matrix(output, TableShape::any).numbers.rows(), 2);
}

TEST_F(DescribeCommand, RejectsUnknownDescriptorsSettingsAndOutputFormats) {
  const std::string output = fmt::format("-o '{}'", at("x.npy").string());
  expect_error_lines({{fmt::format("describe {} {}", shapes(), output), "--descriptor"},
                      {fmt::format("describe {} {} --descriptor d3", shapes(), output), "d3"},
                      {fmt::format("describe {} {} --descriptor d2 --set bin=3", shapes(), output), "bins"},
                      {fmt::format("describe {} --descriptor d2 -o x.txt", shapes()), ".npy"},
                      {fmt::format("describe {} {} --descriptor joint_histogram", shapes(), output), "fields"},
                      {"describe --descriptor d2", "--list"}});
}

TEST_F(DescribeCommand, EvaluatingFeaturesGivesTheScoresOfTheirDistanceMatrix) {
  std::filesystem::create_directory(at("matrix"));
  test::write_text(at("classes.txt"), "a\na\nb\n");
  EXPECT_EQ(describe(fmt::format("--descriptor light_field --set pixels=16 -o '{}'", at("x.npy").string())).status, 0);
  const Signatures features = read_matrix(at("x.npy"), TableShape::any).numbers.cast<float>();
  write_npy(at("matrix/x.npy"), descriptor_distances(descriptors().at("light_field"), features));
  const auto evaluate = [&](const std::string& matrix, const std::string& distance) {
    return run_executable(fmt::format("evaluate '{}' {} --labels '{}' --per-query '{}'", at(matrix).string(), distance,
                                      at("classes.txt").string(), at(matrix + ".csv").string()));
  };
  const Outcome by_features = evaluate("x.npy", "--distance light_field");
  const Outcome by_matrix = evaluate("matrix/x.npy", "");
  EXPECT_EQ(by_features.status, 0) << by_features.errors;
  EXPECT_EQ(by_matrix.status, 0) << by_matrix.errors;
  EXPECT_EQ(by_features.output, by_matrix.output);
  EXPECT_EQ(test::text_of(at("x.npy.csv")), test::text_of(at("matrix/x.npy.csv")));
  expect_error_lines({{fmt::format("evaluate '{}' --distance light_field --labels '{}'", at("matrix/x.npy").string(),
                                   at("classes.txt").string()),
                       "distances, not features"}});
}

/// Distances of ten points on a line.
DistanceMatrix line() {
  DistanceMatrix distances(10, 10);
  for (int i = 0; i < 10; ++i) {
    for (int j = 0; j < 10; ++j) distances(i, j) = std::abs(i * i - j * j);
  }
  return distances;
}

TEST_F(DescribeCommand, ReportsThatNoFileIsWrittenIfInterrupted) {
  write_off(at("ball.off"), test::sphere(1, 5));
  std::vector<std::string> call{"describe"};
  for (int i = 0; i < 200; ++i) {  // enough for many seconds
    call.push_back(at("ball" + std::to_string(i) + ".off").string());
    std::filesystem::create_hard_link(at("ball.off"), call.back());
  }
  for (const char* const word : {"--descriptor", "light_field", "--threads", "1", "-o"}) call.emplace_back(word);
  call.push_back(at("new.csv").string());
  BackgroundRun run(call, at("errors"));
  std::this_thread::sleep_for(std::chrono::seconds(2));
  run.send(SIGINT);
  EXPECT_EQ(run.wait(), 130);
  EXPECT_FALSE(std::filesystem::exists(at("new.csv")));
  EXPECT_EQ(test::text_of(at("errors")), "shapegauge: error: interrupted; no results were written\n");
}

using RerankCommand = CommandTest;

TEST_F(RerankCommand, EachMethodWritesTheDistancesOfItsLibraryFunction) {
  write_npy(at("d.npy"), line());
  const auto rerank = [&](const std::string& arguments) {
    const std::string call = fmt::format("rerank @d.npy --replace -o @r.npy {}", arguments);
    succeeded(run(call));
    return read_matrix(at("r.npy"), TableShape::square).numbers;
  };
  EXPECT_EQ(rerank("--neighbours 3"), diffused(line(), {.neighbours = 3}));
  EXPECT_EQ(rerank("--method k_reciprocal --neighbours 4 --expansion-neighbours 2 --original 0.5"),
            k_reciprocal(line(), {.neighbours = 4, .expansion_neighbours = 2, .original = 0.5}));
  EXPECT_EQ(rerank("--method query_expansion"), query_expansion(line()));
  EXPECT_EQ(rerank("--neighbours 3,5,4"), diffused(line(), {.neighbours = {3, 4, 5}}));
  EXPECT_EQ(rerank("--neighbours auto"), diffused(line(), {.neighbours = {}}));
  EXPECT_EQ(rerank("--method k_reciprocal --neighbours auto"), k_reciprocal(line(), {.neighbours = {}}));
  // The sparse form is accurate to 1e-6, as diffused_affinities() says; so is the difference of its two triangles.
  EXPECT_LT((rerank("--neighbours 3 --sparse") - diffused(line(), {.neighbours = 3})).cwiseAbs().maxCoeff(), 1e-5);
  EXPECT_LT((rerank("--neighbours auto --sparse") - diffused(line(), {.neighbours = {}})).cwiseAbs().maxCoeff(), 1e-5);
}

/// Names of the folder's files.
std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

TEST_F(RerankCommand, SparseOptionDoesNotOverwriteAFileThroughASymbolicLink) {
  write_npy(at("d.npy"), line());
  test::write_text(at("mine"), "mine");
  std::filesystem::create_symlink(at("mine"), at("r.npy.part"));
  EXPECT_EQ(run("rerank @d.npy -o @r.npy --sparse").status, 0);
  EXPECT_EQ(test::text_of(at("mine")), "mine");
  EXPECT_EQ(names_in(folder_.path()), (std::set<std::string>{"d.npy", "mine", "r.npy", "r.npy.part"}));
}

TEST_F(RerankCommand, WritesNoFileIfInterrupted) {
  constexpr Eigen::Index models = 2000;  // enough for some seconds
  write_npy(at("d.npy"), DistanceMatrix::NullaryExpr(models, models, [](Eigen::Index i, Eigen::Index j) {
              return static_cast<double>(std::abs(i - j));
            }));
  const test::TemporaryFolder messages;
  BackgroundRun run({"rerank", at("d.npy"), "-o", at("r.npy"), "--sparse", "--neighbours", "auto"},
                    messages.path() / "errors");
  ASSERT_TRUE(run.wait_until([&] { return names_in(folder_.path()).size() == 2; }));
  run.send(SIGINT);
  EXPECT_EQ(run.wait(), 130);
  EXPECT_EQ(names_in(folder_.path()), std::set<std::string>{"d.npy"});
  EXPECT_EQ(test::text_of(messages.path() / "errors"), "shapegauge: error: interrupted; no results were written\n");
}

TEST_F(RerankCommand, CopiesModelIdsFromTheInputCsvToTheOutput) {
  test::write_text(at("d.csv"), "id,x,y,z\nx,0,1,3\ny,1,0,2\nz,3,2,0\n");
  succeeded(run("rerank @d.csv -o @r.csv --method query_expansion --neighbours 1"));
  const LabelledTable found = read_matrix(at("r.csv"), TableShape::square);
  EXPECT_THAT(found.row_ids, testing::ElementsAre("x", "y", "z"));
  EXPECT_EQ(found.numbers, query_expansion(DistanceMatrix{{0, 1, 3}, {1, 0, 2}, {3, 2, 0}}, {.neighbours = 1}));
}

TEST_F(RerankCommand, AcceptsInfiniteDistances) {
  DistanceMatrix distances = line();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  distances.row(3).setConstant(infinity);
  distances.col(3).setConstant(infinity);
  distances(3, 3) = 0;
  write_npy(at("d.npy"), distances);
  test::write_text(at("classes.txt"), "a\na\na\na\na\nb\nb\nb\nb\nb\n");
  for (const std::string method :
       {"diffusion --neighbours 3", "diffusion --neighbours 3 --sparse", "k_reciprocal", "query_expansion"}) {
    const Outcome outcome = succeeded(run(fmt::format("rerank @d.npy --replace -o @r.npy --method {}", method)));
    EXPECT_EQ(outcome.errors, "") << method;
    const DistanceMatrix found = read_matrix(at("r.npy"), TableShape::square).numbers;
    EXPECT_EQ(found.array().isInf().count(), 18) << method;
    EXPECT_FALSE(found.hasNaN()) << method;
    EXPECT_EQ(run("evaluate @r.npy --labels @classes.txt").status, 0);
  }
}

TEST_F(RerankCommand, WarnsOfAsymmetricMatrices) {
  DistanceMatrix distances = line();
  distances(2, 5) += 0.5;
  distances(7, 1) += 2;
  write_npy(at("d.npy"), distances);
  const Outcome outcome = succeeded(run("rerank @d.npy -o @r.npy"));
  EXPECT_THAT(outcome.errors, testing::MatchesRegex("shapegauge: warning: [^\n]*not symmetric: 2 pairs[^\n]*by up to "
                                                    "2;[^\n]*\n"));
}

TEST_F(RerankCommand, RejectsOptionsOutOfRangeAndNegativeDistances) {
  write_npy(at("d.npy"), line());
  write_npy(at("negative.npy"), -line());
  const std::string call = "rerank " + quoted("d.npy") + " -o " + quoted("r.npy") + " ";
  expect_error_lines({{call + "--neighbours 0", "neighbours"},
                      {call + "--original 1", "--method diffusion"},
                      {call + "--neighbours 4,0", "neighbours"},
                      {call + "--neighbours many", "--neighbours"},
                      {call + "--neighbours ''", "--neighbours"},
                      {call + "--damping x", "--damping"},
                      {call + "--damping 0.5,0.6", "--damping"},
                      {call + "--method k_reciprocal --neighbours 2", "expansion_neighbours"},
                      {call + "--method query_expansion --sparse", "--sparse"},
                      {"rerank " + quoted("d.npy") + " -o " + quoted("r.txt"), ".npy"},
                      {"rerank " + quoted("negative.npy") + " -o " + quoted("r.npy"), "negative"},
                      {"rerank " + quoted("negative.npy") + " -o " + quoted("r.npy") + " --sparse", "negative"}});
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
    EXPECT_FALSE(entry.path().filename().string().starts_with("r.npy")) << "nothing half-written is left";
  }
}

}  // namespace

}  // namespace shapegauge::test_command_line
