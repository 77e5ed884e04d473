// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <gmock/gmock.h>

#include "shapegauge/experiments/evaluation/method_scores.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string table =
    "method,protocol,id,class,NN,FT\n"
    "a,psb,1,ant,100.0000,50.0000\na,psb,2,ant,0,25\nb,psb,2,ant,100,75\nb,psb,1,ant,0,100\n";

class MethodScoreTables : public test::FolderTest {
 protected:
  std::vector<MethodScores> read(const std::string& text, const std::string& name = "per_query.csv") {
    test::write_text(at(name), text);
    return read_method_scores(at(name));
  }
  std::string error_of(const std::string& text) {
    return test::input_error_of([&] { read(text); });
  }
};

TEST_F(MethodScoreTables, AreSplitByMethodAndAlignedByQuery) {
  const std::vector<MethodScores> methods = read(table);
  ASSERT_EQ(methods.size(), 2U);
  EXPECT_EQ(methods[0].values(1, 1), 0.25);
  const AlignedMethods aligned = align_methods(methods, {});
  EXPECT_EQ(read("method,protocol,id,class,shrec21.FT\na,psb,1,ant,150\n")[0].values(0, 0), 1.5);
  EXPECT_THAT(aligned.methods, ElementsAre("a", "b"));
  EXPECT_THAT(aligned.measures, ElementsAre("NN", "FT"));
  EXPECT_THAT(aligned.classes, ElementsAre(0, 0));
  EXPECT_EQ(aligned.values[1], (Eigen::MatrixXd(2, 2) << 0.5, 1, 0.25, 0.75).finished());
  EXPECT_THAT(align_methods(methods, std::vector<std::string>{"FT"}).measures, ElementsAre("FT"));
}

TEST_F(MethodScoreTables, PrefixEqualMethodNamesWithTheFileName) {
  std::vector<MethodScores> methods = read(table, "one/per_query.csv");
  const std::vector<MethodScores> more = read(table, "two.csv");
  methods.insert(methods.end(), more.begin(), more.end());
  EXPECT_THAT(align_methods(methods, {}).methods, ElementsAre("one: a", "one: b", "two: a", "two: b"));
}

TEST_F(MethodScoreTables, RejectScoresOfDifferentQueriesClassesProtocolsOrMeasures) {
  const auto align_error = [&](const std::string& more, const std::vector<std::string>& measures = {}) {
    std::vector<MethodScores> methods = read(table);
    const std::vector<MethodScores> others = read(more, "other.csv");
    methods.insert(methods.end(), others.begin(), others.end());
    return test::input_error_of([&] { align_methods(methods, measures); });
  };
  const std::string header = "method,protocol,id,class,NN\n";
  EXPECT_THAT(
      align_error(header + "c,psb,1,ant,1\n"),
      testing::AllOf(HasSubstr("other.csv: \"c\" lacks the query \"2\", which \"a\" ("), HasSubstr("csv) has;")));
  EXPECT_THAT(align_error(header + "c,psb,1,ant,1\nc,psb,2,ant,1\nc,psb,3,ant,1\n"),
              HasSubstr("other.csv: \"c\" has the query \"3\""));
  EXPECT_THAT(align_error(header + "c,psb,1,ant,1\nc,psb,2,bee,1\n"), HasSubstr("the query \"2\" is of class \"bee\""));
  EXPECT_THAT(align_error(header + "c,trec,1,ant,1\nc,trec,2,ant,1\n"), HasSubstr("trec"));
  EXPECT_THAT(align_error(header + "c,psb,1,ant,1\nc,psb,2,ant,1\n", {"FT"}), HasSubstr("no measure \"FT\" for \"c\""));
  EXPECT_THAT(align_error("method,protocol,id,class,ST\nc,psb,1,ant,1\nc,psb,2,ant,1\n"),
              HasSubstr("no measure in common"));
}

TEST_F(MethodScoreTables, RejectInvalidRowsNamingTheirLineNumber) {
  EXPECT_THAT(error_of("method,protocol,average,NN\n"), HasSubstr("expected a table of scores by query"));
  EXPECT_THAT(error_of("method,protocol,id,class,NN\na,psb,1,ant\n"),
              HasSubstr("per_query.csv:2: expected 5 cells as in the first row, found 4"));
  for (const char* figure : {"x", "nan", "-1", "101"}) {
    EXPECT_THAT(error_of("method,protocol,id,class,NN\na,psb,1,ant," + std::string(figure) + "\n"),
                HasSubstr("per_query.csv:2: \"" + std::string(figure) + "\" is not a number from 0 to 100"));
  }
  EXPECT_THAT(error_of("method,protocol,id,class,NN,shrec21.FT\na,psb,1,ant,1,201\n"), HasSubstr("from 0 to 200"));
  EXPECT_THAT(error_of("method,protocol,id,class,NN\na,psb,1,ant,1\na,psb,T1,ant,1\n"),
              HasSubstr("per_query.csv: repeated query \"T1\" for \"a\""));
}

// Names of methods derived from file names.
std::vector<std::string> names_of(const std::vector<std::string>& files, const std::vector<std::string>& names = {}) {
  std::vector<MethodScores> methods;
  for (const std::string& file : files) {
    methods.push_back({.method = std::filesystem::path(file).stem().string(),
                       .source = file,
                       .protocol = "psb",
                       .measures = {"NN"},
                       .queries = {"1"},
                       .classes = {"ant"},
                       .values = Eigen::MatrixXd::Ones(1, 1)});
  }
  return align_methods(methods, {}, names).methods;
}

TEST(MethodNames, AreTheShortestUniquePartsOfFilePaths) {
  EXPECT_THAT(names_of({"a/d.npy", "a/e.npy"}), ElementsAre("d", "e"));
  EXPECT_THAT(names_of({"d.npy", "x/d.npy"}), ElementsAre("d", "x/d"));
  EXPECT_THAT(names_of({"d.npy", "d.csv", "e.npy"}), ElementsAre("d.npy", "d.csv", "e"));
  EXPECT_THAT(names_of({"/r/a/x/d.npy", "/r/b/x/d.npy", "/r/b/y/d.npy"}), ElementsAre("a/x/d", "b/x/d", "b/y/d"));
  EXPECT_THAT(names_of({"a/d.npy", "./a/d.npy"}), ElementsAre("d", "d (2)"));
}

TEST(MethodNames, RequestedByTheUserMustBeUniqueAndOnePerMethod) {
  EXPECT_THAT(names_of({"d.npy", "x/d.npy"}, {"ours", "theirs"}), ElementsAre("ours", "theirs"));
  EXPECT_THAT(test::input_error_of([] {
                names_of({"d.npy", "x/d.npy"}, {"ours"});
              }),
              HasSubstr("1 names for 2 methods (d, x/d)"));
  EXPECT_THAT(test::input_error_of([] {
                names_of({"d.npy", "e.npy"}, {"a", "a"});
              }),
              HasSubstr("two methods have the name"));
  EXPECT_THAT(test::input_error_of([] { names_of({"d.npy", "e.npy"}, {"a", ""}); }), HasSubstr("is empty"));
}

}  // namespace

}  // namespace shapegauge
