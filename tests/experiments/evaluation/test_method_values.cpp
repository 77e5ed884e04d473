#include <filesystem>
#include <gmock/gmock.h>

#include "shapegauge/experiments/evaluation/method_values.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/experiments/input_error.h"
#include "tests/experiments/text_files.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string table =
    "method,protocol,id,class,NN,FT\n"
    "a,psb,1,ant,100.0000,50.0000\na,psb,2,ant,0,25\nb,psb,2,ant,100,75\nb,psb,1,ant,0,100\n";

class MethodValuesTest : public testing::Test {
 protected:
  std::vector<MethodValues> read(const std::string& text, const std::string& name = "per_query.csv") {
    test_experiments::write_text(folder_.path() / name, text);
    return read_method_values(folder_.path() / name);
  }
  std::string error_of(const std::string& text) {
    return input_error_of([&] { read(text); });
  }

 private:
  test_io::TemporaryFolder folder_;
};

TEST_F(MethodValuesTest, AreReadByMethodAndAlignedByQuery) {
  const std::vector<MethodValues> methods = read(table);
  ASSERT_EQ(methods.size(), 2U);
  EXPECT_EQ(methods[0].values(1, 1), 0.25);
  const AlignedMethods aligned = align_methods(methods, {});
  EXPECT_THAT(aligned.methods, ElementsAre("a", "b"));
  EXPECT_THAT(aligned.measures, ElementsAre("NN", "FT"));
  EXPECT_THAT(aligned.classes, ElementsAre(0, 0));
  EXPECT_EQ(aligned.values[1], (Eigen::MatrixXd(2, 2) << 0.5, 1, 0.25, 0.75).finished());
  EXPECT_THAT(align_methods(methods, std::vector<std::string>{"FT"}).measures, ElementsAre("FT"));
}

TEST_F(MethodValuesTest, EqualNamesGetThatOfTheirFile) {
  std::vector<MethodValues> methods = read(table, "one/per_query.csv");
  const std::vector<MethodValues> more = read(table, "two.csv");
  methods.insert(methods.end(), more.begin(), more.end());
  EXPECT_THAT(align_methods(methods, {}).methods, ElementsAre("one: a", "one: b", "two: a", "two: b"));
}

TEST_F(MethodValuesTest, WhatCannotBeComparedIsOneError) {
  const auto align_error = [&](const std::string& more, const std::vector<std::string>& measures = {}) {
    std::vector<MethodValues> methods = read(table);
    const std::vector<MethodValues> others = read(more, "other.csv");
    methods.insert(methods.end(), others.begin(), others.end());
    return input_error_of([&] { align_methods(methods, measures); });
  };
  const std::string header = "method,protocol,id,class,NN\n";
  EXPECT_THAT(align_error(header + "c,psb,1,ant,1\n"), HasSubstr("\"c\" has no query \"2\", which \"a\" has"));
  EXPECT_THAT(align_error(header + "c,psb,1,ant,1\nc,psb,2,ant,1\nc,psb,3,ant,1\n"),
              HasSubstr("\"c\" has the query \"3\", which \"a\" has not"));
  EXPECT_THAT(align_error(header + "c,psb,1,ant,1\nc,psb,2,bee,1\n"), HasSubstr("the query \"2\" is of class \"bee\""));
  EXPECT_THAT(align_error(header + "c,trec,1,ant,1\nc,trec,2,ant,1\n"), HasSubstr("under trec"));
  EXPECT_THAT(align_error(header + "c,psb,1,ant,1\nc,psb,2,ant,1\n", {"FT"}), HasSubstr("no measure \"FT\" for \"c\""));
  EXPECT_THAT(align_error("method,protocol,id,class,ST\nc,psb,1,ant,1\nc,psb,2,ant,1\n"),
              HasSubstr("no measure in common"));
  const std::vector<MethodValues> one = {read(table)[0]};
  EXPECT_THAT(input_error_of([&] { align_methods(one, {}); }), HasSubstr("one method only"));
}

TEST_F(MethodValuesTest, FaultsAreOneErrorWithTheLine) {
  EXPECT_THAT(error_of("method,protocol,average,NN\n"), HasSubstr("expected figures of each query"));
  EXPECT_THAT(error_of("method,protocol,id,class,NN\na,psb,1,ant\n"), HasSubstr("per_query.csv:2: 4 cells"));
  for (const char* figure : {"x", "nan", "-1", "101"}) {
    EXPECT_THAT(error_of("method,protocol,id,class,NN\na,psb,1,ant," + std::string(figure) + "\n"),
                HasSubstr("per_query.csv:2: \"" + std::string(figure) + "\" is no number from 0 to 100"));
  }
  EXPECT_THAT(error_of("method,protocol,id,class,NN\na,psb,1,ant,1\na,psb,T1,ant,1\n"), HasSubstr("occurs twice"));
}

}  // namespace

}  // namespace shapegauge
