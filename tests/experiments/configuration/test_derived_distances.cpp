// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <utility>

#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/retrieval/diffusion.h"
#include "shapegauge/retrieval/fusion.h"
#include "shapegauge/retrieval/k_reciprocal.h"
#include "shapegauge/retrieval/query_expansion.h"
#include "shapegauge/retrieval/rerank.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

Json document_with(const Json& last) {
  Json document = Json::parse(R"({
    "name": "x", "dataset": {"generate": {}},
    "signatures": [
      {"name": "a", "descriptor": {"type": "d2"}},
      {"name": "b", "field": {"type": "cone_sdf"}, "histogram": {"range": "per-shape"}}]})");
  document["signatures"].push_back(last);
  document["signatures"].back()["name"] = "c";
  return document;
}

SignatureConfiguration derived_signature(const Json& last) {
  return configuration_from_json(document_with(last), "x.json", ".").signatures.back();
}

std::string derived_error_with(const Json& last) {
  return test::input_error_of([&] { derived_signature(last); });
}

/// Distances of three models: medians 2 and 20.
const std::vector<DistanceMatrix> two_matrices = {DistanceMatrix{{0, 1, 2}, {1, 0, 4}, {2, 4, 0}},
                                                  DistanceMatrix{{0, 20, 10}, {20, 0, 30}, {10, 30, 0}}};

TEST(DerivedDistances, SumScalesAndWeightsTheDistancesOfEachSignature) {
  const auto sum = derived_signature({{"sum", {{{"of", "a"}}, {{"of", "b"}, {"weight", 0.5}}}}});
  EXPECT_THAT(sum.parts, ElementsAre(0, 1));
  const DistanceMatrix distances = derive(*sum.derived, two_matrices);
  EXPECT_NEAR(distances(0, 1), 1 / 2.0 + 0.5 * 20 / 20.0, 1e-15);
  EXPECT_NEAR(distances(1, 2), 4 / 2.0 + 0.5 * 30 / 20.0, 1e-15);
  const auto plain = derived_signature({{"sum", {{{"of", "b"}, {"weight", 2}}}}, {"scale", "none"}});
  EXPECT_THAT(plain.parts, ElementsAre(1));
  EXPECT_EQ(derive(*plain.derived, {&two_matrices[1], 1})(0, 1), 40);
}

TEST(DerivedDistances, SumEqualsThatOfTheLibraryForEveryScaleAndWeighting) {
  const std::vector<double> weights{1, 0.5};
  for (const auto& [word, kind] :
       {std::pair("given", SumWeights::given), std::pair("agreement", SumWeights::agreement)}) {
    const auto sum = derived_signature(
        {{"sum", {{{"of", "a"}}, {{"of", "b"}, {"weight", 0.5}}}}, {"scale", "local"}, {"weights", word}});
    EXPECT_EQ(derive(*sum.derived, two_matrices),
              sum_of_distances(two_matrices, sum_weights(two_matrices, weights, kind), DistanceScale::local));
  }
  for (const auto& [word, scale] : {std::pair("none", DistanceScale::none),
                                    {"median", DistanceScale::median},
                                    {"mean", DistanceScale::mean},
                                    {"local", DistanceScale::local},
                                    {"ranks", DistanceScale::ranks},
                                    {"local_spread", DistanceScale::local_spread}}) {
    const auto sum = derived_signature({{"sum", {{{"of", "a"}}, {{"of", "b"}, {"weight", 0.5}}}}, {"scale", word}});
    EXPECT_EQ(derive(*sum.derived, two_matrices), sum_of_distances(two_matrices, weights, scale)) << word;
  }
}

TEST(DerivedDistances, SumWeightedByAgreementReportsSignaturesThatDisagree) {
  Eigen::VectorXd positions(60);
  for (Eigen::Index i = 0; i < 60; ++i) positions[i] = static_cast<double>(i / 20 * 1000 + i % 20);
  const DistanceMatrix groups = (positions.replicate(1, 60).rowwise() - positions.transpose()).cwiseAbs();
  std::vector<Eigen::Index> order;
  for (Eigen::Index i = 0; i < 60; ++i) order.push_back(i * 7 % 60);
  const std::vector<DistanceMatrix> matrices{groups, groups(order, order)};
  const Json terms{{{"of", "a"}}, {{"of", "b"}}};
  const auto sum = derived_signature({{"sum", terms}, {"weights", "agreement"}});
  EXPECT_THAT(remark_on(*sum.derived, matrices), HasSubstr("\"a\" and \"b\" find different groups"));
  EXPECT_EQ(remark_on(*sum.derived, std::vector<DistanceMatrix>{groups, groups}), "");
  EXPECT_EQ(remark_on(*derived_signature({{"sum", terms}}).derived, matrices), "");
}

TEST(DerivedDistances, RejectUnknownNamesOfScalesAndWeights) {
  const auto read = [](Json settings) {
    settings["sum"] = {{{"of", "a"}}};
    return test::input_error_of([&] { make_derived("sum", settings); });
  };
  EXPECT_THAT(read({{"scale", "locally"}}), HasSubstr("scale is \"locally\""));
  EXPECT_THAT(read({{"weights", "agree"}}), HasSubstr("weights is \"agree\""));
}

TEST(DerivedDistances, AcceptNeighbourCountsAsNumberListOrAuto) {
  const auto reranked = [](const Json& neighbours) {
    const Json last{{"rerank", {{"of", "b"}, {"method", "diffusion"}, {"neighbours", neighbours}}}};
    return derive(*derived_signature(last).derived, {&two_matrices[1], 1});
  };
  EXPECT_EQ(reranked({1, 2}), diffused(two_matrices[1], {.neighbours = {1, 2}}));
  EXPECT_EQ(reranked("auto"), diffused(two_matrices[1], {.neighbours = {}}));
  EXPECT_EQ(reranked(Json::array({2})), reranked(2));
  const auto error = [](const Json& neighbours) {
    return derived_error_with({{"rerank", {{"of", "b"}, {"method", "diffusion"}, {"neighbours", neighbours}}}});
  };
  EXPECT_THAT(error({4, 0}), HasSubstr("signatures.2.rerank.neighbours.1"));
  EXPECT_THAT(error(Json::array()), HasSubstr("signatures.2.rerank.neighbours"));
  EXPECT_THAT(error(std::vector<int>(17, 4)), HasSubstr("signatures.2.rerank.neighbours"));
  EXPECT_THAT(error("many"), HasSubstr("signatures.2.rerank.neighbours"));
}

TEST(DerivedDistances, RankFusionAndRerankingEqualThoseOfTheLibrary) {
  const std::vector<double> equal{1, 1};
  EXPECT_EQ(derive(*derived_signature({{"fuse_ranks", {"a", "b"}}}).derived, two_matrices),
            fusion_of_ranks(two_matrices, equal));
  EXPECT_EQ(derive(*derived_signature({{"fuse_ranks", {"a", "b"}}, {"score", "borda"}}).derived, two_matrices),
            fusion_of_ranks(two_matrices, equal, RankScore::borda));
  const Json diffusion{{"rerank", {{"of", "b"}, {"method", "diffusion"}, {"neighbours", 2}, {"damping", 0.9}}}};
  EXPECT_EQ(derive(*derived_signature(diffusion).derived, {&two_matrices[1], 1}),
            diffused(two_matrices[1], {.neighbours = 2, .damping = 0.9}));
  const Json expansion{{"rerank", {{"of", "b"}, {"method", "query_expansion"}, {"neighbours", 1}}}};
  EXPECT_EQ(derive(*derived_signature(expansion).derived, {&two_matrices[1], 1}),
            query_expansion(two_matrices[1], {.neighbours = 1}));
}

TEST(DerivedDistances, AreComputedAfterTheirInputs) {
  Json changed = document_with({{"sum", {{{"of", "a"}}}}});
  std::reverse(changed["signatures"].begin(), changed["signatures"].end());
  const Json reranked = Json::parse(R"({"name": "d", "rerank": {"of": "c", "method": "k_reciprocal"}})");
  changed["signatures"].insert(changed["signatures"].begin(), reranked);
  const auto signatures = configuration_from_json(changed, "x.json", ".").signatures;
  EXPECT_THAT(computation_order(signatures), ElementsAre(3, 1, 0, 2));
}

TEST(DerivedDistances, ConfigurationIsReadBackAsWritten) {
  for (const Json& last : {Json{{"sum", {{{"of", "a"}}}}, {"scale", "mean"}}, Json{{"fuse_ranks", {"b", "a"}}},
                           Json{{"sum", {{{"of", "a"}}}}, {"scale", "local"}, {"weights", "agreement"}},
                           Json{{"rerank", {{"of", "a"}, {"method", "diffusion"}}}},
                           Json{{"rerank", {{"of", "a"}, {"method", "diffusion"}, {"neighbours", "auto"}}}},
                           Json{{"rerank", {{"of", "a"}, {"method", "k_reciprocal"}, {"neighbours", {7, 9}}}}}}) {
    const Json filled = to_json(configuration_from_json(document_with(last), "x.json", "."));
    EXPECT_EQ(to_json(configuration_from_json(filled, "again.json", ".")), filled);
  }
}

TEST(DerivedDistances, ConfigurationErrorsNameTheirLocation) {
  const Json one_term{{{"of", "a"}}};
  const std::vector<std::pair<Json, const char*>> mistakes = {
      {{{"sum", {{{"of", "a"}}, {{"of", "bb"}}}}}, "signatures.2.sum.1.of: there is no signature \"bb\""},
      {{{"rerank", {{"of", "x"}, {"method", "diffusion"}}}}, "signatures.2.rerank.of: there is no signature \"x\""},
      {{{"fuse_ranks", {"a", "c"}}}, "signatures.2.fuse_ranks: the signature \"c\""},
      {{{"concatenate", {"a"}}}, "signatures.2.concatenate.0"},
      {{{"sum", {{{"of", "a"}, {"weight", 0}}}}}, "signatures.2.sum: at least one weight"},
      {{{"sum", {{{"of", "a"}, {"weight", -1}}}}}, "signatures.2.sum.0.weight"},
      {{{"sum", one_term}, {"score", "borda"}}, "signatures.2.score"},
      {{{"fuse_ranks", {"a"}}, {"weights", "agreement"}}, "signatures.2.weights"},
      {{{"rerank", {{"of", "a"}, {"method", "diffusion"}, {"original", 1}}}}, "unknown key \"original\""},
      {{{"rerank", {{"of", "a"}, {"method", "k_reciprocal"}, {"neighbours", 3}, {"expansion_neighbours", 4}}}},
       "signatures.2.rerank: "},
      {{{"sum", one_term}, {"fuse_ranks", {"a"}}}, "cannot be combined with \"sum\""},
      {Json::object(), "\"field\" is missing"}};
  for (const auto& [last, word] : mistakes) EXPECT_THAT(derived_error_with(last), HasSubstr(word)) << last;
}

}  // namespace

}  // namespace shapegauge
