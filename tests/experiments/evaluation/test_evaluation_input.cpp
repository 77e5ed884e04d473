#include <cmath>
#include <filesystem>
#include <gmock/gmock.h>

#include "shapegauge/experiments/evaluation/evaluation_input.h"
#include "shapegauge/experiments/files/npy.h"
#include "shapegauge/metrics/evaluation.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/experiments/input_error.h"
#include "tests/experiments/text_files.h"

namespace shapegauge {

namespace {

using test_experiments::write_text;
using testing::ElementsAre;
using testing::HasSubstr;

class EvaluationInputTest : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& name, const std::string& text) {
    write_text(folder_.path() / name, text);
    return folder_.path() / name;
  }
  [[nodiscard]] std::filesystem::path at(const std::string& name) const { return folder_.path() / name; }
  std::filesystem::path two_classes() { return file("labels.csv", "id,class\n1,ant\n2,ant\n10,bee\n11,bee\n"); }

 private:
  test_io::TemporaryFolder folder_;
};

double measure(const EvaluationInput& input, const std::string& name, Protocol protocol = Protocol::trec) {
  EvaluationOptions options;
  options.protocol = protocol;
  options.measures = {measure_of(name)};
  return evaluate(input.distances, input.task, options).micro[0];
}

TEST_F(EvaluationInputTest, RowsAreInNaturalOrder) {
  write_npy(at("d.npy"), DistanceMatrix::Ones(4, 4));
  const EvaluationInput input = read_evaluation_input({.matrix = at("d.npy"), .labels = two_classes()});
  EXPECT_THAT(input.query_ids, ElementsAre("1", "2", "10", "11"));
  EXPECT_THAT(input.task.query_classes, ElementsAre(0, 0, 1, 1));
  EXPECT_THAT(input.task.own_column, ElementsAre(0, 1, 2, 3));
  EXPECT_TRUE(input.same_rows_and_columns);
}

TEST_F(EvaluationInputTest, SimilaritiesAreTurnedRound) {
  const auto labels = two_classes();
  const auto matrix = file("s.txt", "9 5 1 0\n5 9 0 1\n1 0 9 5\n0 1 5 9\n");
  EXPECT_EQ(measure(read_evaluation_input({.matrix = matrix, .labels = labels, .similarity = true}), "FT"), 1);
  EXPECT_EQ(measure(read_evaluation_input({.matrix = matrix, .labels = labels}), "FT"), 0);
}

TEST_F(EvaluationInputTest, FeaturesAreCompared) {
  const auto labels = two_classes();
  for (const char* table : {"10,5,0\n1,0,0\n11,6,1\n2,1,0\n", "id,x,y\n10,5,0\n1,0,0\n11,6,1\n2,1,0\n"}) {
    // Without a header the ids are numbers, and taken as features: the rows are 1, 2, 10, 11 then.
    const EvaluationInput input =
        read_evaluation_input({.matrix = file("f.csv", table), .labels = labels, .distance = "l2"});
    const bool header = table[0] == 'i';
    EXPECT_EQ(input.query_ids[0], header ? "10" : "1");
    const DistanceMatrix row = distance_rows(input.features->features, 0, 1, input.features->distance);
    EXPECT_DOUBLE_EQ(row(0, 2), header ? std::sqrt(2.0) : std::sqrt(3.0));
    EXPECT_EQ(input.distances.size(), 0);
  }
  const auto bad = file("g.csv", "1,-1\n2,1\n3,1\n4,1\n");
  EXPECT_THAT(input_error_of([&] { read_evaluation_input({.matrix = bad, .labels = labels, .distance = "emd"}); }),
              HasSubstr("g.csv: the distance emd is not defined for signature 0"));
}

TEST_F(EvaluationInputTest, OfFeaturesTheWholeMatrixWhereItIsWanted) {
  const auto features = file("f.csv", "5,0\n0,0\n6,1\n1,0\n");
  const EvaluationInput input =
      read_evaluation_input({.matrix = features, .labels = two_classes(), .distance = "l1", .whole_matrix = true});
  EXPECT_FALSE(input.features.has_value());
  EXPECT_EQ(input.distances(0, 3), 4);
}

TEST_F(EvaluationInputTest, QueriesByTargetsOrAllByAll) {
  const auto labels = file("split.csv", "id,class,split\n1,ant,query\n2,ant,target\n3,bee,target\n4,bee,both\n");
  const EvaluationInput small = read_evaluation_input({.matrix = file("d.txt", "1 2 3\n2 1 0\n"), .labels = labels});
  EXPECT_THAT(small.query_ids, ElementsAre("1", "4"));
  EXPECT_THAT(small.task.target_classes, ElementsAre(0, 1, 1));
  EXPECT_THAT(small.task.own_column, ElementsAre(-1, 2));
  EXPECT_FALSE(small.same_rows_and_columns);
  EXPECT_EQ(measure(small, "NN"), 1);

  write_npy(at("all.npy"), DistanceMatrix::Ones(4, 4));
  const EvaluationInput all = read_evaluation_input({.matrix = at("all.npy"), .labels = labels});
  EXPECT_THAT(all.task.query_classes, ElementsAre(0, no_class, no_class, 1));
  EXPECT_THAT(all.task.target_classes, ElementsAre(no_class, 0, 1, 1));
  EXPECT_TRUE(all.same_rows_and_columns);
}

TEST_F(EvaluationInputTest, ATableNamesItsRowsAndColumns) {
  const auto labels = file("split.csv", "id,class,split\n1,ant,query\n2,ant,target\n3,bee,target\n");
  const EvaluationInput input =
      read_evaluation_input({.matrix = file("d.csv", "id,T3.off,T2\nT1,5,6\n"), .labels = labels});
  EXPECT_THAT(input.task.target_classes, ElementsAre(1, 0));
  EXPECT_EQ(measure(input, "MRR"), 0.5);
}

// trec_eval's own conventions on a run of two queries, worked by hand: relevant a, c, x (never found) and b.
TEST_F(EvaluationInputTest, ATrecRunUnderJudgements) {
  const auto run = file("r.run",
                        "q1 Q0 a 1 0.9 t\nq1 Q0 b 2 0.8 t\nq1 Q0 c 3 0.7 t\n"
                        "q2 Q0 a 1 0.5 t\nq2 Q0 b 2 0.5 t\nq3 Q0 a 1 1 t\n");
  const auto qrels = file("j.txt", "q1 0 a 1\nq1 0 c 1\nq1 0 x 2\nq1 0 b 0\nq2 0 b 1\nq4 0 a 1\n");
  const EvaluationInput input = read_evaluation_input({.matrix = run, .qrels = qrels});
  EXPECT_THAT(input.query_ids, ElementsAre("q1", "q2"));
  // q1: (1 + 2/3 + 0) / 3; q2: equal scores, the larger id first as trec_eval has it: b is first.
  EXPECT_DOUBLE_EQ(measure(input, "mAP"), ((1 + 2.0 / 3) / 3 + 1) / 2);
  EXPECT_DOUBLE_EQ(measure(input, "P@10"), (0.2 + 0.1) / 2);
  EXPECT_DOUBLE_EQ(measure(input, "R@10"), (2.0 / 3 + 1) / 2);
  EXPECT_DOUBLE_EQ(measure(input, "R-prec"), (2.0 / 3 + 1) / 2);
  EXPECT_DOUBLE_EQ(measure(input, "nDCG"), (1.5 / (1.5 + 1 / std::log2(3)) + 1) / 2);
  EXPECT_THAT(input.notes, ElementsAre(HasSubstr("1 queries have no judgements"),
                                       HasSubstr("1 judged queries have no answer"), HasSubstr("grades above 1")));
}

TEST_F(EvaluationInputTest, RankedListsUnderClasses) {
  const EvaluationInput input =
      read_evaluation_input({.matrix = file("r.lists", "1 1 2 10\n10 2 11\n11 1\n"), .labels = two_classes()});
  // The query itself is passed over in its list; 11 finds nothing that is relevant.
  EXPECT_DOUBLE_EQ(measure(input, "MRR"), (1 + 0.5 + 0) / 3);
  EXPECT_THAT(input.notes, ElementsAre(HasSubstr("1 queries have no answer")));
}

TEST_F(EvaluationInputTest, AMatrixUnderJudgementsNeedsIds) {
  const auto qrels = file("j.txt", "2 0 10 1\n");
  const auto matrix = file("d.txt", "0 1 2\n1 0 2\n2 3 0\n");
  EXPECT_THAT(input_error_of([&] { read_evaluation_input({.matrix = matrix, .qrels = qrels}); }),
              HasSubstr("need ids"));
  const auto ids = file("ids.txt", "1\n2\n10\n");
  const EvaluationInput input = read_evaluation_input({.matrix = matrix, .qrels = qrels, .ids = ids});
  EXPECT_THAT(input.task.query_classes, ElementsAre(no_class, 1, no_class));
  EXPECT_EQ(measure(input, "MRR"), 0.5);
  const auto unknown = file("k.txt", "2 0 11 1\n");
  EXPECT_THAT(input_error_of([&] { read_evaluation_input({.matrix = matrix, .qrels = unknown, .ids = ids}); }),
              HasSubstr("\"11\" is judged but is not in the matrix"));
}

TEST_F(EvaluationInputTest, WhatDoesNotFitIsOneError) {
  const auto labels = two_classes();
  const auto three = file("d.txt", "0 1 2\n1 0 2\n2 3 0\n");
  const auto error = [&](const EvaluationFiles& files) {
    return input_error_of([&] { read_evaluation_input(files); });
  };
  EXPECT_THAT(error({.matrix = three, .labels = labels}), HasSubstr("d.txt has 3 rows, but there are 4 models in"));
  EXPECT_THAT(error({.matrix = three}), HasSubstr("give either --labels"));
  EXPECT_THAT(error({.matrix = three, .labels = labels, .qrels = labels}), HasSubstr("give either --labels"));
  const auto ids = file("ids.txt", "1\n2\n3\n");
  EXPECT_THAT(error({.matrix = three, .labels = labels, .ids = ids}), HasSubstr("model \"3\" is in no class"));
  const auto twice = file("twice.txt", "1\n2\nT2\n");
  EXPECT_THAT(error({.matrix = three, .labels = labels, .ids = twice}), HasSubstr("model \"T2\" occurs twice"));
  const auto few = file("few.txt", "1\n2\n10\n");
  EXPECT_THAT(error({.matrix = three, .labels = labels, .ids = few}),
              HasSubstr("model \"11\" is classified but is not"));
  EXPECT_THAT(error({.matrix = file("r.run", "1 Q0 77 1 1 t\n"), .labels = labels}),
              HasSubstr("model \"77\" is in no class"));
}

}  // namespace

}  // namespace shapegauge
