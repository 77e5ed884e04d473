// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapegauge/experiments/leaderboard/submissions.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using testing::HasSubstr;

class SubmissionsOfAFolder : public test::FolderTest {
 protected:
  void add(const std::string& name, const std::string& text = "0") { test::write_text(at(name), text); }
  FoundSubmissions find(const std::vector<std::filesystem::path>& others = {}) {
    return find_submissions(std::vector{folder_.path()}, others);
  }
};

TEST_F(SubmissionsOfAFolder, ShareOneDescriptionAmongRepetitions) {
  for (const char* name : {"x.seed1.npy", "x.fold12.csv.gz", "y.v2.npy", "z.seedling.npy", "z.seed.npy"}) add(name);
  add("x.json", R"({"authors": "A"})");
  add("y.v2.json", R"({"name": "Y"})");
  const FoundSubmissions found = find();
  ASSERT_EQ(found.submissions.size(), 5U);
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_EQ(found.submissions[i].repetition_of, at("x"));
    EXPECT_EQ(found.submissions[i].name, "x");
    EXPECT_EQ(found.submissions[i].authors, "A");
  }
  EXPECT_EQ(found.submissions[2].name, "Y");
  for (const std::size_t i : {2U, 3U, 4U}) EXPECT_TRUE(found.submissions[i].repetition_of.empty());
  EXPECT_TRUE(found.refused.empty());
}

TEST_F(SubmissionsOfAFolder, AreAllFilesOfReadableFormatsInNaturalOrder) {
  for (const char* name : {"m10.npy", "m2.csv.gz", "m1.RUN", "README.md", ".hidden.npy", "deep/x.npy"}) add(name);
  const FoundSubmissions found = find();
  ASSERT_EQ(found.submissions.size(), 3U);
  EXPECT_EQ(found.submissions[0].file.filename(), "m1.RUN");
  EXPECT_EQ(found.submissions[1].file.filename(), "m2.csv.gz");
  EXPECT_EQ(found.submissions[2].file.filename(), "m10.npy");
  EXPECT_EQ(found.skipped, std::vector{at("README.md")});
  EXPECT_TRUE(found.refused.empty());
}

TEST_F(SubmissionsOfAFolder, AreDescribedByAJsonFile) {
  add("x.csv.gz");
  add("x.json", R"({"name": "Ours", "authors": ["A", "B"], "paper": "P", "url": "https://e.org", "similarity": true,
                    "ids": "order.txt"})");
  add("order.txt");
  const FoundSubmissions found = find();
  ASSERT_EQ(found.submissions.size(), 1U) << "the file of ids is no submission";
  const Submission& one = found.submissions[0];
  EXPECT_EQ(one.name, "Ours");
  EXPECT_EQ(one.authors, "A, B");
  EXPECT_EQ(one.paper, "P");
  EXPECT_EQ(one.url, "https://e.org");
  EXPECT_EQ(one.similarity, true);
  EXPECT_EQ(one.ids, at("order.txt"));
}

TEST_F(SubmissionsOfAFolder, AreAcceptedWithoutADescription) {
  add("x.npy");
  const FoundSubmissions found = find();
  EXPECT_TRUE(found.submissions.at(0).name.empty());
  EXPECT_FALSE(found.submissions.at(0).similarity.has_value());
}

TEST_F(SubmissionsOfAFolder, AreRejectedForAnInvalidDescription) {
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"{", "w0.json:1:2: not valid JSON"}, {"[]", "object"},
      {R"({"nane": "x"})", "\"name\""},     {R"({"similarity": "yes"})", "similarity"},
      {R"({"name": 3})", "name"},           {R"({"url": "javascript:alert"})", "https://"},
      {R"({"distance": "l3"})", "l3"},      {R"({"distance": "l1", "similarity": true})", "distance"}};
  add("good.npy");
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    add("w" + std::to_string(i) + ".npy");
    add("w" + std::to_string(i) + ".json", wrong[i].first);
  }
  const FoundSubmissions found = find();
  EXPECT_EQ(found.submissions.size(), 1U);
  ASSERT_EQ(found.refused.size(), wrong.size());
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    EXPECT_EQ(found.refused[i].file, at("w" + std::to_string(i) + ".npy"));
    EXPECT_THAT(found.refused[i].reason, HasSubstr(wrong[i].second));
  }
}

TEST_F(SubmissionsOfAFolder, RejectADescriptionWithoutASubmission) {
  add("x.npy");
  add("y.json", "{}");
  const FoundSubmissions found = find();
  ASSERT_EQ(found.refused.size(), 1U);
  EXPECT_EQ(found.refused[0].file, at("y.json"));
}

TEST_F(SubmissionsOfAFolder, MustNotReferToFilesOutsideTheFolder) {
  const test::TemporaryFolder elsewhere;
  const auto secret = elsewhere.file("secret.txt", "secret");
  std::filesystem::create_symlink(secret, at("link.txt"));
  std::filesystem::create_symlink(secret, at("matrix.csv"));
  std::filesystem::create_symlink(secret, at("described.json"));
  add("order.txt");
  std::filesystem::create_symlink(at("order.txt"), at("same.txt"));
  const std::vector<std::pair<std::string, std::string>> ids{
      {"absolute", secret.string()}, {"above", "../secret.txt"}, {"linked", "link.txt"}};
  for (const auto& [name, file] : ids) {
    add(name + ".npy");
    add(name + ".json", R"({"ids": ")" + file + R"("})");
  }
  add("described.npy");
  add("good.npy");
  add("good.json", R"({"ids": "same.txt"})");
  const FoundSubmissions found = find({at("order.txt")});
  ASSERT_EQ(found.submissions.size(), 1U);
  EXPECT_EQ(found.submissions[0].ids, at("same.txt"));
  ASSERT_EQ(found.refused.size(), 6U);
  for (const RefusedSubmission& refused : found.refused) {
    EXPECT_THAT(refused.reason, testing::AnyOf(HasSubstr("outside of the folder"), HasSubstr("out of the folder")));
    EXPECT_THAT(refused.reason, testing::Not(HasSubstr("not valid")));
  }
}

TEST_F(SubmissionsOfAFolder, ExcludeTheFileOfLabels) {
  add("x.npy");
  add("labels.csv");
  EXPECT_EQ(find({at("labels.csv"), {}}).submissions.size(), 1U);
  EXPECT_EQ(find().submissions.size(), 2U);
}

TEST_F(SubmissionsOfAFolder, ExcludeReadmeFiles) {
  add("x.npy");
  add("README.txt");
  add("License.csv");
  const FoundSubmissions found = find();
  EXPECT_EQ(found.submissions.size(), 1U);
  EXPECT_TRUE(found.refused.empty());
  EXPECT_EQ(found.skipped.size(), 2U);
}

TEST_F(SubmissionsOfAFolder, RejectAFolderWithoutSubmissions) {
  add("README.md");
  EXPECT_THAT(test::input_error_of([&] { find(); }), HasSubstr("no submissions"));
}

TEST(Submissions, RejectMissingPathsAndKeepOtherSubmissions) {
  const test::TemporaryFolder folder;
  const auto there = folder.file("a.npy", "0");
  const FoundSubmissions found = find_submissions(std::vector{folder.path() / "absent.npy", there});
  EXPECT_EQ(found.submissions.size(), 1U);
  ASSERT_EQ(found.refused.size(), 1U);
  EXPECT_EQ(found.refused[0].file.filename(), "absent.npy");
}

}  // namespace

}  // namespace shapegauge
