// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/experiments/search/searched_folder.h"

namespace shapegauge {
namespace {

using test::input_error_of;
using test::SearchedFolder;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(SearchMethodOfAConfiguration, RecommendedMethodsMatchTheShippedConfigurationFiles) {
  for (const auto& [recommended, terms] :
       {std::pair(RecommendedMethod::any, 5U), std::pair(RecommendedMethod::articulated, 3U)}) {
    const std::string file = recommended_file(recommended);
    const SearchMethod method = recommended_search_method(recommended);
    const SearchMethod of_file = search_method(read_json(SHAPEGAUGE_SOURCE_FOLDER "/configs/" + file), file);
    EXPECT_EQ(method.key(), of_file.key());
    EXPECT_EQ(method.terms.size(), terms);
    EXPECT_EQ(method.sum.options.scale, DistanceScale::ranks);
    EXPECT_EQ(method.sum.options.weights, SumWeights::agreement);
    EXPECT_TRUE(method.diffusion.keep_nearest);
    EXPECT_TRUE(method.configuration.preparation.remove_outliers);
    EXPECT_EQ(method.configuration.signatures.size(), method.terms.size() + 1);  // nothing unneeded
  }
}

TEST(SearchMethodOfAConfiguration, RejectsRankFusionsAndRerankedSignatures) {
  const SearchedFolder folder;
  EXPECT_EQ(folder.method("").name, "local");
  EXPECT_THAT(input_error_of([&] { folder.method("ranks"); }), HasSubstr("it fuses ranks"));
  EXPECT_THAT(input_error_of([&] { folder.method("diffused"); }), HasSubstr("it is re-ranked"));
  EXPECT_THAT(input_error_of([&] { folder.method("locla"); }), HasSubstr("did you mean \"local\"?"));
  EXPECT_EQ(folder.method("local").diffusion.neighbours, (IntegerList{2, 3}));
  EXPECT_EQ(folder.method("median").diffusion.neighbours, IntegerList{});
}

TEST(SearchMethodOfAConfiguration, IndexKeyChangesOnlyWithSettingsThatAffectResults) {
  const SearchedFolder folder;
  const std::string key = folder.method().key();
  nlohmann::json document = folder.configuration();
  document["name"] = "other";
  document["seed"] = 7;
  document["evaluation"] = {{"ties", "expected"}};
  EXPECT_EQ(search_method(document, "small.json", "local").key(), key);
  document = folder.configuration();
  document["preparation"] = {{"denoise", true}};
  EXPECT_NE(search_method(document, "small.json", "local").key(), key);
  document = folder.configuration();
  document["distance"] = "chi2";
  EXPECT_NE(search_method(document, "small.json", "local").key(), key);
  document = folder.configuration();
  document["signatures"][7]["scale"] = "median";
  EXPECT_NE(search_method(document, "small.json", "local").key(), key);
  EXPECT_NE(folder.method("d2").key(), key);
}

std::vector<std::string> signature_names(const SearchMethod& method) {
  std::vector<std::string> names;
  for (const SignatureConfiguration& one : method.configuration.signatures) names.push_back(one.name);
  return names;
}

std::vector<std::string> term_names(const SearchMethod& method) {
  std::vector<std::string> names;
  for (const std::size_t term : method.terms) names.push_back(method.configuration.signatures.at(term).name);
  return names;
}

TEST(SearchMethodOfAConfiguration, ContainsOnlyTheSelectedSignatureAndItsInputs) {
  const SearchedFolder folder;
  const SearchMethod alone = folder.method("d2");
  EXPECT_THAT(signature_names(alone), ElementsAre("d2"));
  EXPECT_THAT(term_names(alone), ElementsAre("d2"));
  EXPECT_THAT(alone.sum.weights, ElementsAre(1));
  const SearchMethod concatenated = folder.method("both");
  EXPECT_THAT(signature_names(concatenated), ElementsAre("own range", "range of all", "both"));
  EXPECT_THAT(term_names(concatenated), ElementsAre("both"));
  const SearchMethod sum = folder.method("median");
  EXPECT_THAT(signature_names(sum), ElementsAre("own range", "range of all", "both", "d2", "median"));
  EXPECT_THAT(term_names(sum), ElementsAre("both", "d2"));
  EXPECT_THAT(sum.sum.weights, ElementsAre(1, 0.5));
  EXPECT_EQ(sum.sum.options.scale, DistanceScale::median);
  EXPECT_EQ(sum.sum.options.weights, SumWeights::given);
  const SearchMethod local = folder.method("local");
  EXPECT_THAT(term_names(local), ElementsAre("range of all", "bag", "d2"));
  EXPECT_THAT(local.sum.weights, ElementsAre(1, 1, 1));
  EXPECT_EQ(local.sum.options.scale, DistanceScale::local);
  EXPECT_EQ(local.sum.options.weights, SumWeights::agreement);
}

TEST(SearchMethodOfAConfiguration, RejectsASumOfDerivedDistances) {
  const SearchedFolder folder;
  nlohmann::json document = folder.configuration();
  document["signatures"].push_back({{"name", "sum of ranks"}, {"sum", {{{"of", "ranks"}}, {{"of", "d2"}}}}});
  EXPECT_THAT(input_error_of([&] { search_method(document, "small.json", "sum of ranks"); }), HasSubstr("\"ranks\""));
  EXPECT_EQ(search_method(document, "small.json").name, "local") << "the last suitable one";
  document["signatures"].erase(document["signatures"].begin(), document["signatures"].begin() + 7);
  EXPECT_NE(input_error_of([&] { search_method(document, "small.json"); }), "no error") << "only derived ones";
}

TEST(SearchMethodOfAConfiguration, UsesTheSettingsOfTheFirstDiffusionAppliedToTheSignature) {
  const SearchedFolder folder;
  nlohmann::json document = folder.configuration();
  const auto add = [&](const char* name, const char* of, int neighbours) {
    document["signatures"].push_back(
        {{"name", name}, {"rerank", {{"of", of}, {"method", "diffusion"}, {"neighbours", {neighbours}}}}});
  };
  add("of median", "median", 4);
  add("again", "local", 5);
  EXPECT_EQ(search_method(document, "small.json", "local").diffusion.neighbours, (IntegerList{2, 3}));
  EXPECT_EQ(search_method(document, "small.json", "median").diffusion.neighbours, IntegerList{4});
  EXPECT_EQ(search_method(document, "small.json", "d2").diffusion.neighbours, IntegerList{});
}

TEST(SearchMethodOfAConfiguration, IsReadFromAFileWithOverrides) {
  const SearchedFolder folder;
  test::write_text(folder.at("small.json"), folder.configuration().dump());
  const std::vector<std::string> overrides{"signatures.0.histogram.bins=8"};
  const SearchMethod plain = read_search_method(folder.at("small.json"), {}, "own range");
  const SearchMethod changed = read_search_method(folder.at("small.json"), overrides, "own range");
  EXPECT_EQ(plain.key(), folder.method("own range").key());
  EXPECT_EQ(plain.configuration.signatures.front().histogram.options.bins, 16);
  EXPECT_EQ(changed.configuration.signatures.front().histogram.options.bins, 8);
  EXPECT_NE(changed.key(), plain.key());
}

}  // namespace
}  // namespace shapegauge
