// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>

#include "shapegauge/experiments/retrieval/run_experiment.h"
#include "tests/experiments/search/searched_folder.h"

namespace shapegauge {
namespace {

using test::SearchedFolder;

/// Distance matrices of a run on the folder, by signature name.
std::map<std::string, DistanceMatrix> distances_of_run(const SearchedFolder& folder, const nlohmann::json& document) {
  const Configuration configuration = configuration_from_json(document, "small.json", folder.models());
  std::map<std::string, DistanceMatrix> distances;
  for (MethodResults& method : run_experiment(configuration, folder.at("generated"), {}).methods) {
    distances[method.name] = std::move(method.distances);
  }
  return distances;
}

void expect_same_order(const SearchAnswer& answer, const Eigen::RowVectorXd& row, Eigen::Index member,
                       double tolerance) {
  const Eigen::Index others = row.size() - (member >= 0 ? 1 : 0);
  ASSERT_EQ(std::ssize(answer.nearest), std::min<Eigen::Index>(others, 10));
  double before = 0;
  for (const RankedModel& one : answer.nearest) {
    EXPECT_NEAR(one.distance, row[one.model], tolerance);
    EXPECT_GE(one.distance, before);
    EXPECT_NE(one.model, member);
    before = one.distance;
  }
}

class Search : public testing::Test {
 protected:
  const SearchedFolder folder;
};

TEST_F(Search, QueryFromTheCollectionHasTheDistancesOfARetrievalRun) {
  const std::map<std::string, DistanceMatrix> runs = distances_of_run(folder, folder.configuration());
  for (const char* signature : {"own range", "range of all", "both", "bag", "d2", "median", "local"}) {
    SCOPED_TRACE(signature);
    OpenIndex index = folder.open(signature);
    ASSERT_EQ(index.contents.models.size(), 9U);
    for (Eigen::Index i = 0; i < 9; ++i) {
      const IndexedFile& model = index.contents.models[static_cast<std::size_t>(i)];
      const SearchAnswer answer = folder.answer(index, folder.models() / model.path);
      EXPECT_EQ(answer.member, static_cast<std::size_t>(i));
      expect_same_order(answer, runs.at(signature).row(i), i, 0);
    }
  }
}

TEST_F(Search, RerankedQueryFromTheCollectionHasTheDistancesOfARetrievalRun) {
  const std::map<std::string, DistanceMatrix> runs = distances_of_run(folder, folder.configuration());
  OpenIndex index = folder.open();
  for (Eigen::Index i = 0; i < 9; ++i) {
    const auto path = folder.models() / index.contents.models[static_cast<std::size_t>(i)].path;
    expect_same_order(folder.answer(index, path, {.rerank = true}), runs.at("diffused").row(i), i, 1e-5);
  }
}

TEST_F(Search, CopyOfACollectionMemberFindsThatMemberFirst) {
  OpenIndex index = folder.open();
  std::filesystem::copy_file(folder.models() / "T4.off", folder.at("copy.off"));
  const SearchAnswer member = folder.answer(index, folder.models() / "T4.off");
  const SearchAnswer copy = folder.answer(index, folder.at("copy.off"));
  EXPECT_FALSE(copy.member);
  ASSERT_EQ(copy.nearest.size(), 9U);
  EXPECT_EQ(copy.nearest[0].model, 4);
  EXPECT_EQ(copy.nearest[0].distance, 0);
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_EQ(copy.nearest[k + 1].model, member.nearest[k].model);
    EXPECT_EQ(copy.nearest[k + 1].distance, member.nearest[k].distance);
  }
}

TEST_F(Search, ExternalQueryHasTheDistancesItHasAsACollectionMember) {
  OpenIndex index = folder.open("d2");  // features independent of other shapes
  write_off(folder.at("query.off"), test::small_shape("box", 7));
  const SearchAnswer answer = folder.answer(index, folder.at("query.off"));
  folder.add("T9.off", "box", 7);
  OpenIndex with_it = folder.open("d2");
  const SearchAnswer expected = folder.answer(with_it, folder.models() / "T9.off");
  ASSERT_EQ(expected.member, 9U);
  ASSERT_EQ(answer.nearest.size(), expected.nearest.size());
  for (std::size_t k = 0; k < answer.nearest.size(); ++k) {
    EXPECT_EQ(answer.nearest[k].model, expected.nearest[k].model);
    EXPECT_EQ(answer.nearest[k].distance, expected.nearest[k].distance);
  }
  EXPECT_EQ(expected.median, expected.nearest[4].distance) << "of ten with itself, the upper";
  folder.add("T10.off", "box", 7);
  OpenIndex with_two = folder.open("d2");
  const SearchAnswer tied = folder.answer(with_two, folder.at("query.off"));
  EXPECT_EQ(tied.nearest[0].model, 9) << "of two copies, the first";
  EXPECT_EQ(tied.nearest[1].model, 10);
}

TEST_F(Search, ExternalQueryIsRerankedByDiffusionWithTheCollection) {
  OpenIndex index = folder.open();
  write_off(folder.at("query.off"), test::small_shape("box", 7));
  // Input of diffusion: the index' sum between models, and the query's distances without re-ranking.
  DistanceMatrix all = DistanceMatrix::Zero(10, 10);
  for (Eigen::Index i = 0; i < 10; ++i) {
    const auto file =
        i < 9 ? folder.models() / index.contents.models[static_cast<std::size_t>(i)].path : folder.at("query.off");
    for (const RankedModel& one : folder.answer(index, file).nearest) {
      all(i, one.model) = one.distance;
      if (i == 9) all(one.model, i) = one.distance;
    }
  }
  const DistanceMatrix expected = diffused(all, index.method.diffusion);
  const SearchAnswer answer = folder.answer(index, folder.at("query.off"), {.rerank = true});
  ASSERT_EQ(answer.nearest.size(), 9U);
  for (const RankedModel& one : answer.nearest) EXPECT_NEAR(one.distance, expected(9, one.model), 1e-5);
}

TEST_F(Search, RanksShapesOfTheQueryClassFirst) {
  OpenIndex index = folder.open();
  const Shape shape = test::small_shape("sphere", 8);
  write_off(folder.at("query.off"), shape);
  const SearchAnswer of_file = folder.answer(index, folder.at("query.off"), {.count = 3});
  ASSERT_EQ(of_file.nearest.size(), 3U);
  Cache none;
  std::vector<std::string> notes;
  const std::vector<SearchQuery> queries{{.name = "shape", .file = {}, .shape = read_shape(folder.at("query.off"))}};
  const SearchAnswer of_shape = search(index, queries, {.count = 3}, {}, none, notes).front();
  const SearchAnswer sphere = folder.answer(index, folder.models() / "T3.off", {.count = 2});
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(of_shape.nearest[k].model, of_file.nearest[k].model);
    EXPECT_EQ(of_shape.nearest[k].distance, of_file.nearest[k].distance);
  }
  std::vector<Eigen::Index> kind{3};  // T3 and its two nearest are spheres
  for (const RankedModel& one : sphere.nearest) kind.push_back(one.model);
  for (const RankedModel& one : of_file.nearest) EXPECT_THAT(kind, testing::Contains(one.model));
}

TEST_F(Search, AnswersOtherQueriesIfOneIsUnusable) {
  OpenIndex index = folder.open();
  test::write_text(folder.at("broken.off"), "OFF\n3 1 0\n0 0 0\n");
  Cache none;
  std::vector<std::string> notes;
  const std::vector<SearchQuery> queries{{.name = "broken", .file = folder.at("broken.off")},
                                         {.name = "absent", .file = folder.at("absent.off")},
                                         {.name = "good", .file = folder.models() / "T0.off"}};
  const std::vector<SearchAnswer> answers = search(index, queries, {}, {}, none, notes);
  EXPECT_THAT(answers[0].failure, testing::HasSubstr("broken.off"));
  EXPECT_THAT(answers[1].failure, testing::HasSubstr("absent.off"));
  EXPECT_EQ(answers[2].failure, "");
  EXPECT_EQ(answers[2].nearest.size(), 8U);
}

TEST_F(Search, GivesTheSameAnswersOnAnyNumberOfThreads) {
  write_off(folder.at("query.off"), test::small_shape("capsule", 6));
  std::vector<std::vector<std::pair<Eigen::Index, double>>> found;
  for (const int threads : {1, 3}) {
    Cache none;
    IndexUpdate update;
    OpenIndex index = open_index(folder.method(), folder.models(), folder.at(std::to_string(threads)),
                                 {.threads = threads}, none, update);
    std::vector<std::string> notes;
    const std::vector<SearchQuery> queries{{.name = "query", .file = folder.at("query.off")}};
    auto& answer = found.emplace_back();
    for (const bool rerank : {false, true}) {
      const SearchOptions options{.rerank = rerank};
      const std::vector<SearchAnswer> answers = search(index, queries, options, {.threads = threads}, none, notes);
      for (const RankedModel& one : answers.front().nearest) {
        answer.emplace_back(one.model, one.distance);
      }
    }
  }
  EXPECT_EQ(found[0], found[1]);
  EXPECT_EQ(test::bytes_of(folder.at("1")), test::bytes_of(folder.at("3")));
}

}  // namespace
}  // namespace shapegauge
