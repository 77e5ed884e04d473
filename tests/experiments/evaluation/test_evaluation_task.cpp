// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <gmock/gmock.h>

#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/experiments/evaluation/evaluate_files.h"
#include "shapegauge/metrics/evaluation.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using test::write_text;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class EvaluationTaskTest : public test::FolderTest {
 protected:
  std::filesystem::path file(const std::string& name, const std::string& text) {
    write_text(at(name), text);
    return at(name);
  }
  std::filesystem::path two_classes() { return file("labels.csv", "id,class\n1,ant\n2,ant\n10,bee\n11,bee\n"); }
};

double measure(const EvaluationData& input, const std::string& name, Protocol protocol = Protocol::trec) {
  EvaluationOptions options;
  options.protocol = protocol;
  options.measures = {measure_of(name)};
  if (input.task.coverage) return evaluate(input.answers, input.task.retrieval, options).micro[0];
  return evaluate(whole_matrix(input.distances), input.task.retrieval, options).micro[0];
}

TEST_F(EvaluationTaskTest, AssignsRowsToLabelsInNaturalOrder) {
  write_npy(at("d.npy"), DistanceMatrix::Ones(4, 4));
  const EvaluationData input = open_evaluation_files({.matrix = at("d.npy"), .labels = two_classes()});
  EXPECT_THAT(input.task.query_ids, ElementsAre("1", "2", "10", "11"));
  EXPECT_THAT(input.task.retrieval.query_classes, ElementsAre(0, 0, 1, 1));
  EXPECT_THAT(input.task.retrieval.own_column, ElementsAre(0, 1, 2, 3));
  EXPECT_TRUE(input.task.same_rows_and_columns);
}

TEST_F(EvaluationTaskTest, RanksModelsByDecreasingSimilarity) {
  const auto labels = two_classes();
  const auto matrix = file("s.txt", "9 5 1 0\n5 9 0 1\n1 0 9 5\n0 1 5 9\n");
  EXPECT_EQ(measure(open_evaluation_files({.matrix = matrix, .labels = labels, .similarity = true}), "FT"), 1);
  EXPECT_EQ(measure(open_evaluation_files({.matrix = matrix, .labels = labels}), "FT"), 0);
}

TEST_F(EvaluationTaskTest, ComputesDistancesOfFeatures) {
  const auto labels = two_classes();
  for (const char* table : {"10,5,0\n1,0,0\n11,6,1\n2,1,0\n", "id,x,y\n10,5,0\n1,0,0\n11,6,1\n2,1,0\n"}) {
    // Without a header, numeric ids are read as features: rows are 1, 2, 10, 11 then.
    const EvaluationData input =
        open_evaluation_files({.matrix = file("f.csv", table), .labels = labels, .distance = "l2"});
    const bool header = table[0] == 'i';
    EXPECT_EQ(input.task.query_ids[0], header ? "10" : "1");
    EXPECT_DOUBLE_EQ(whole_matrix(input.distances)(0, 2), header ? std::sqrt(2.0) : std::sqrt(3.0));
  }
  const auto bad = file("g.csv", "1,-1\n2,1\n3,1\n4,1\n");
  EXPECT_THAT(
      test::input_error_of([&] { open_evaluation_files({.matrix = bad, .labels = labels, .distance = "emd"}); }),
      HasSubstr("g.csv: the distance emd is not defined for signature 0"));
}

TEST_F(EvaluationTaskTest, AcceptsMatricesOfQueriesByTargetsOrOfAllModels) {
  const auto labels = file("split.csv", "id,class,split\n1,ant,query\n2,ant,target\n3,bee,target\n4,bee,both\n");
  const EvaluationData small = open_evaluation_files({.matrix = file("d.txt", "1 2 3\n2 1 0\n"), .labels = labels});
  EXPECT_THAT(small.task.query_ids, ElementsAre("1", "4"));
  EXPECT_THAT(small.task.retrieval.target_classes, ElementsAre(0, 1, 1));
  EXPECT_THAT(small.task.retrieval.own_column, ElementsAre(-1, 2));
  EXPECT_FALSE(small.task.same_rows_and_columns);
  EXPECT_EQ(measure(small, "NN"), 1);

  write_npy(at("all.npy"), DistanceMatrix::Ones(4, 4));
  const EvaluationData all = open_evaluation_files({.matrix = at("all.npy"), .labels = labels});
  EXPECT_THAT(all.task.retrieval.query_classes, ElementsAre(0, no_class, no_class, 1));
  EXPECT_THAT(all.task.warnings, testing::Contains(HasSubstr("split makes 2 of 4 models queries, and 3 targets")));
  EXPECT_THAT(all.task.retrieval.target_classes, ElementsAre(no_class, 0, 1, 1));
  EXPECT_TRUE(all.task.same_rows_and_columns);
}

TEST_F(EvaluationTaskTest, MatchesRowsAndColumnsOfATableById) {
  const auto labels = file("split.csv", "id,class,split\n1,ant,query\n2,ant,target\n3,bee,target\n");
  const EvaluationData input =
      open_evaluation_files({.matrix = file("d.csv", "id,T3.off,T2\nT1,5,6\n"), .labels = labels});
  EXPECT_THAT(input.task.retrieval.target_classes, ElementsAre(1, 0));
  EXPECT_EQ(measure(input, "MRR"), 0.5);
}

// trec_eval's own conventions on a run of two queries, worked by hand: relevant a, c, x (never found) and b.
TEST_F(EvaluationTaskTest, ScoresATrecRunByItsJudgements) {
  const auto run = file("r.run",
                        "q1 Q0 a 1 0.9 t\nq1 Q0 b 2 0.8 t\nq1 Q0 c 3 0.7 t\n"
                        "q2 Q0 a 1 0.5 t\nq2 Q0 b 2 0.5 t\nq3 Q0 a 1 1 t\n");
  const auto qrels = file("j.txt", "q1 0 a 1\nq1 0 c 1\nq1 0 x 2\nq1 0 b 0\nq1 0 d 0\nq1 0 e 0\nq2 0 b 1\nq4 0 a 1\n");
  const EvaluationData input = open_evaluation_files({.matrix = run, .qrels = qrels});
  EXPECT_THAT(input.task.query_ids, ElementsAre("q1", "q2"));
  // q1: (1 + 2/3 + 0) / 3; q2: equal scores, the larger id first as trec_eval has it: b is first.
  EXPECT_DOUBLE_EQ(measure(input, "mAP"), ((1 + 2.0 / 3) / 3 + 1) / 2);
  EXPECT_DOUBLE_EQ(measure(input, "P@10"), (0.2 + 0.1) / 2);
  EXPECT_DOUBLE_EQ(measure(input, "R@10"), (2.0 / 3 + 1) / 2);
  EXPECT_DOUBLE_EQ(measure(input, "R-prec"), (2.0 / 3 + 1) / 2);
  // q1: a gains 1, c at rank 3 gains 1/2; the best list is x (grade 2), a, c.
  EXPECT_DOUBLE_EQ(measure(input, "nDCG"), (1.5 / (2 + 1 / std::log2(3) + 0.5) + 1) / 2);
  // q1: of three models that are judged and not relevant b is before c, and x is never found; q2 has none such.
  EXPECT_DOUBLE_EQ(measure(input, "bpref"), ((1 + 2.0 / 3 + 0) / 3.0 + 1) / 2);
  EXPECT_THAT(
      input.task.warnings,
      ElementsAre(HasSubstr("1 query has no judgements"), HasSubstr("1 of 3 judged queries have no ranked list"),
                  HasSubstr("the lists have 2 to 3 of 6 models"), HasSubstr("grades above 1")));
  const EvaluationFiles other_ids{.matrix = run, .qrels = file("other.txt", "Q1 0 a 1\n")};
  EXPECT_THAT(test::input_error_of([&] { open_evaluation_files(other_ids); }),
              HasSubstr("none of the queries is judged"));
}

TEST_F(EvaluationTaskTest, ScoresRankedListsByClasses) {
  const EvaluationData input =
      open_evaluation_files({.matrix = file("r.lists", "1 1 2 10\n10 2 11\n11 1\n"), .labels = two_classes()});
  // The query itself is skipped in its list; 11 finds no relevant model.
  EXPECT_DOUBLE_EQ(measure(input, "MRR"), (1 + 0.5 + 0) / 3);
  EXPECT_THAT(input.task.warnings, ElementsAre(HasSubstr("1 of 4 queries have no ranked list"),
                                               HasSubstr("the lists have 1 to 2 of 4 models")));
  const ListCoverage& coverage = input.task.coverage.value();
  EXPECT_EQ(coverage.queries, 4U);
  EXPECT_EQ(coverage.answered, 3U);
  EXPECT_EQ(coverage.shortest, 1);  // of 11; the query 1 is in its own list
  EXPECT_EQ(coverage.longest, 2);
  EXPECT_EQ(coverage.incomplete, 0U);
  const auto all = file("all.lists", "1 2 10 11\n2 1 10 11\n10 11 1 2\n11 10 1 2\n");
  EXPECT_THAT(open_evaluation_files({.matrix = all, .labels = two_classes()}).task.warnings, testing::IsEmpty());
  const auto tied = file("tied.run", "1 Q0 10 1 0.5 t\n1 Q0 2 2 0.5 t\n");
  EXPECT_EQ(measure(open_evaluation_files({.matrix = tied, .labels = two_classes()}), "MRR"), 1) << "2 > 10 as text";
}

TEST_F(EvaluationTaskTest, GradesRelevanceBySubclassInRankedListsAndMatrices) {
  const auto labels =
      file("sub.csv", "id,class,subclass\n1,ant,red\n2,ant,ant\n3,ant,red\n4,ant,blue\n5,bee,\n6,bee,\n");
  // For 1: itself 3, then 2 (of the class as such), 5 (a miss), 4 (another subclass); 3 would have gained 3.
  const double found = 3 + 2 + 1 / std::log2(4);
  const double ideal = 3 + 3 + 2 / std::log2(3) + 1 / std::log2(4);
  const EvaluationData lists = open_evaluation_files({.matrix = file("r.lists", "1 1 2 5 4\n"), .labels = labels});
  EXPECT_DOUBLE_EQ(measure(lists, "nDCG@N", Protocol::paper), found / ideal);
  EXPECT_DOUBLE_EQ(measure(lists, "P@N", Protocol::paper), 3.0 / 4);

  const auto queries = file("q.csv", "id,class,subclass\n1,ant,red\n");
  const auto targets = file("t.csv", "id,class,subclass\n2,ant,\n3,ant,red\n4,ant,blue\n5,bee,\n");
  const EvaluationData matrix =
      open_evaluation_files({.matrix = file("d.txt", "1 4 3 2\n"), .labels = queries, .targets = targets});
  const double all_found = 3 + 2 + 1 / std::log2(4) + 3 / std::log2(5);
  EXPECT_DOUBLE_EQ(measure(matrix, "nDCG@N", Protocol::paper), all_found / ideal);
}

TEST_F(EvaluationTaskTest, RejectsAMatrixWithoutIdsIfScoredByRelevanceJudgements) {
  const auto qrels = file("j.txt", "2 0 10 1\n");
  const auto matrix = file("d.txt", "0 1 2\n1 0 2\n2 3 0\n");
  EXPECT_THAT(test::input_error_of([&] { open_evaluation_files({.matrix = matrix, .qrels = qrels}); }),
              HasSubstr("need ids"));
  const auto ids = file("ids.txt", "1\n2\n10\n");
  const EvaluationData input = open_evaluation_files({.matrix = matrix, .qrels = qrels, .ids = ids});
  EXPECT_THAT(input.task.retrieval.query_classes, ElementsAre(no_class, 1, no_class));
  EXPECT_EQ(measure(input, "MRR"), 0.5);
  const auto unknown = file("k.txt", "2 0 11 1\n");
  EXPECT_THAT(test::input_error_of([&] { open_evaluation_files({.matrix = matrix, .qrels = unknown, .ids = ids}); }),
              HasSubstr("\"11\" is judged but is not in the matrix"));
}

TEST_F(EvaluationTaskTest, DistinguishesIdsThatDifferOnlyInTheExtension) {
  const auto labels = file("pairs.csv", "id,class\nm0.off,x\nm0.obj,y\nm1.off,y\nm2,x\n");
  const auto matrix =
      file("d.csv", "id,m0.obj,m0.off,m1.obj,m2\nm0.obj,0,1,2,3\nm0.off,1,0,2,3\nm1.obj,2,2,0,3\nm2,3,3,3,0\n");
  const EvaluationData input = open_evaluation_files({.matrix = matrix, .labels = labels});
  EXPECT_THAT(input.task.retrieval.query_classes, ElementsAre(1, 0, 1, 0));
  EXPECT_THAT(input.task.retrieval.own_column, ElementsAre(0, 1, 2, 3));
  const auto run = file("r.run", "m0.off Q0 m0.obj 1 3 t\nm0.off Q0 m2 2 2 t\n");
  const EvaluationData ranked = open_evaluation_files({.matrix = run, .labels = labels});
  EXPECT_EQ(measure(ranked, "MRR"), 0.5);
  const auto qrels = file("qrels.txt", "m0.off 0 m0.obj 1\n");
  const EvaluationData judged = open_evaluation_files({.matrix = matrix, .qrels = qrels});
  EXPECT_THAT(judged.task.retrieval.judged,
              ElementsAre(testing::IsEmpty(), ElementsAre(0), testing::IsEmpty(), testing::IsEmpty()));
}

TEST_F(EvaluationTaskTest, RejectsMatricesWhoseSizeOrIdsDoNotMatchTheLabels) {
  const auto labels = two_classes();
  const auto three = file("d.txt", "0 1 2\n1 0 2\n2 3 0\n");
  const auto error = [&](const EvaluationFiles& files) {
    return test::input_error_of([&] { open_evaluation_files(files); });
  };
  EXPECT_THAT(error({.matrix = three, .labels = labels}), HasSubstr("d.txt has 3 rows, but there are 4 models in"));
  EXPECT_THAT(error({.matrix = three}), HasSubstr("`labels`"));
  EXPECT_THAT(error({.matrix = three, .labels = labels, .qrels = labels}), HasSubstr("`labels`"));
  const auto ids = file("ids.txt", "1\n2\n3\n");
  EXPECT_THAT(error({.matrix = three, .labels = labels, .ids = ids}), HasSubstr("model \"3\" is in no class"));
  const auto twice = file("twice.txt", "1\n2\nT2\n");
  EXPECT_THAT(error({.matrix = three, .labels = labels, .ids = twice}), HasSubstr("model \"T2\" is repeated"));
  for (const char* first : {"x", "0%"}) {
    const std::string text = std::string(first) + ",0.5,0.7,0.9\n0.5,0,1,1\n0.7,1,0,1\n0.9,1,1,0\n";
    for (const auto& of_four : {labels, file("classes.txt", "x\nx\ny\ny\n")}) {
      EXPECT_THAT(error({.matrix = file("na.csv", text), .labels = of_four}),
                  AllOf(HasSubstr("na.csv: the first row is taken for the ids of 3 models"), HasSubstr("4 models")));
    }
  }
  const auto few = file("few.txt", "1\n2\n10\n");
  EXPECT_THAT(error({.matrix = three, .labels = labels, .ids = few}),
              HasSubstr("model \"11\" has a class but is not among"));
  EXPECT_THAT(error({.matrix = file("r.run", "1 Q0 77 1 1 t\n"), .labels = labels}),
              HasSubstr("model \"77\" is in no class"));
  EXPECT_THAT(error({.matrix = file("r.lists", "1 2 10 T2\n"), .labels = labels}),
              HasSubstr("query \"1\" has the model \"T2\" more than once"));
}

// In Python, row i of the list refers to row i of the matrix. Rows of the CSV: 10 and 2 of one class, 1 of the
// other.
TEST_F(EvaluationTaskTest, AssignsRowsWithoutIdsInTheOrderOfLabels) {
  const auto labels = file("labels.csv", "id,class\n10,ant\n2,ant\n1,bee\n");
  const auto matrix = file("d.txt", "0 1 5\n1 0 4\n5 4 0\n");
  const EvaluationData data = open_evaluation_files({.matrix = matrix, .labels = labels});
  EXPECT_THAT(data.task.query_ids, ElementsAre("10", "2", "1"));
  EXPECT_EQ(measure(data, "NN"), 1);
  EXPECT_THAT(data.task.warnings, ElementsAre(HasSubstr("`order=natural`")));
  const EvaluationData natural =
      open_evaluation_files({.matrix = matrix, .labels = labels, .order = RowOrder::natural});
  EXPECT_THAT(natural.task.query_ids, ElementsAre("1", "2", "10"));
  EXPECT_EQ(measure(natural, "NN"), 0.5);
  EXPECT_THAT(natural.task.warnings, testing::IsEmpty());
}

TEST_F(EvaluationTaskTest, AssignsRowsToModelsOfAClassificationFileInNaturalOrder) {
  const auto labels = file("labels.cla", "PSB 1\n2 3\nant 0 2\n10 2\nbee 0 1\n1\n");
  const auto matrix = file("d.txt", "0 1 5\n1 0 5\n5 5 0\n");
  const EvaluationData data = open_evaluation_files({.matrix = matrix, .labels = labels});
  EXPECT_THAT(data.task.query_ids, ElementsAre("1", "2", "10"));
  EXPECT_THAT(data.task.warnings, ElementsAre(HasSubstr("`order=file`")));
  const EvaluationData in_file = open_evaluation_files({.matrix = matrix, .labels = labels, .order = RowOrder::file});
  EXPECT_THAT(in_file.task.query_ids, ElementsAre("10", "2", "1"));
  EXPECT_THAT(in_file.task.warnings, testing::IsEmpty());
  // No warning if both orders agree or the matrix has ids.
  const auto sorted = file("sorted.cla", "PSB 1\n2 3\nant 0 2\n1 2\nbee 0 1\n10\n");
  EXPECT_THAT(open_evaluation_files({.matrix = matrix, .labels = sorted}).task.warnings, testing::IsEmpty());
  const auto named = file("d.csv", "id,2,1,10\n2,0,1,5\n1,1,0,5\n10,5,5,0\n");
  EXPECT_THAT(open_evaluation_files({.matrix = named, .labels = labels}).task.warnings, testing::IsEmpty());
}

TEST_F(EvaluationTaskTest, AssignsRowsInLabelFileOrderIfLabelsDefineASplit) {
  const auto labels = file("split.csv", "id,class,split\n3,bee,query\n1,ant,target\n2,bee,target\n4,ant,query\n");
  write_npy(at("all.npy"), DistanceMatrix::Ones(4, 4));
  const EvaluationData all = open_evaluation_files({.matrix = at("all.npy"), .labels = labels});
  EXPECT_THAT(all.task.query_ids, ElementsAre("3", "1", "2", "4"));
  EXPECT_THAT(all.task.retrieval.query_classes, ElementsAre(0, no_class, no_class, 1));
}

TEST_F(EvaluationTaskTest, AssignsLabelsWithoutIdsInTheOrderOfRows) {
  const auto labels = file("labels.txt", "bee\nant\nbee\nant\n");
  const auto matrix = file("d.txt", "0 5 1 4\n5 0 4 1\n1 4 0 5\n4 1 5 0\n");
  const EvaluationData input = open_evaluation_files({.matrix = matrix, .labels = labels});
  EXPECT_THAT(input.task.query_ids, ElementsAre("0", "1", "2", "3"));
  EXPECT_THAT(input.task.class_names, ElementsAre("bee", "ant"));
  EXPECT_EQ(measure(input, "NN"), 1);
  EXPECT_THAT(input.task.warnings, testing::IsEmpty());
  const auto named = file("d.csv", "id,x,y,z,u\nx,0,5,1,4\ny,5,0,4,1\nz,1,4,0,5\nu,4,1,5,0\n");
  const EvaluationData with_ids = open_evaluation_files({.matrix = named, .labels = labels});
  EXPECT_THAT(with_ids.task.query_ids, ElementsAre("x", "y", "z", "u"));
  EXPECT_EQ(measure(with_ids, "NN"), 1);
  const auto few = file("few.txt", "bee\nant\n");
  EXPECT_THAT(test::input_error_of([&] { open_evaluation_files({.matrix = named, .labels = few}); }),
              HasSubstr("there are 2 of them, but the matrix names 4 models"));
}

// The documented behaviour of trec_eval's options, on one run: q1 and q2 are answered, q3 is judged only. -c divides by
// all three. Its -q is per_query here.
TEST_F(EvaluationTaskTest, CountsJudgedQueriesWithoutARankedListAsZeroOnRequest) {
  const auto run = file("r.txt", "q1 Q0 a 1 3 mine\nq1 Q0 b 2 2 mine\nq2 Q0 b 1 1 mine\n");
  const auto qrels = file("j.qrels", "q1 0 b 1\nq1 0 a 0\nq2 0 b 3\nq2 0 c 1\nq3 0 a 1\nq3 0 b 0\n");
  const EvaluationData answered = open_evaluation_files({.matrix = run, .qrels = qrels});
  EXPECT_EQ(answered.name, "mine");
  EXPECT_DOUBLE_EQ(measure(answered, "mAP"), (0.5 + 0.5) / 2);
  EXPECT_DOUBLE_EQ(measure(answered, "MRR"), (0.5 + 1) / 2);
  const EvaluationData all = open_evaluation_files({.matrix = run, .qrels = qrels, .unanswered = Unanswered::count});
  EXPECT_THAT(all.task.query_ids, ElementsAre("q1", "q2", "q3"));
  EXPECT_DOUBLE_EQ(measure(all, "mAP"), (0.5 + 0.5 + 0) / 3);
  EXPECT_DOUBLE_EQ(measure(all, "MRR"), (0.5 + 1 + 0) / 3);
  EXPECT_DOUBLE_EQ(measure(all, "P@5"), (0.2 + 0.2 + 0) / 3);
  // ndcg: gains are the grades, discounts log2(rank + 1).
  const double ideal = 3 + 1 / std::log2(3);
  EXPECT_DOUBLE_EQ(measure(all, "nDCG"), (1 / std::log2(3) + 3 / ideal + 0) / 3);
  // bpref: in q1 one judged model that is not relevant is before b; q2 and q3 find one of two, and none of one.
  EXPECT_DOUBLE_EQ(measure(all, "bpref"), (0 + 0.5 + 0) / 3);
  EXPECT_THAT(all.task.warnings,
              testing::Contains(HasSubstr("1 of 3 judged queries have no ranked list: their scores are 0")));
}

// One of six queries has an answer, which is perfect.
TEST_F(EvaluationTaskTest, ScoresMissingQueriesAsZeroUnderEveryProtocolAndMeasure) {
  const auto labels = file("six.csv", "id,class\na1,a\na2,a\na3,a\nb1,b\nb2,b\nb3,b\n");
  const auto lists = file("one.lists", "a1 a2 a3\n");
  const EvaluationData input =
      open_evaluation_files({.matrix = lists, .labels = labels, .unanswered = Unanswered::count});
  for (const std::string& protocol : list_of_words<Protocol>()) {
    for (const char* name :
         {"NN", "FT", "mAP", "MRR", "BEP", "DCG", "nDCG", "bpref", "AUC-PR", "P@N", "R@N", "nDCG@N"}) {
      EXPECT_DOUBLE_EQ(measure(input, name, value_of_word<Protocol>(protocol).value()), 1.0 / 6)
          << protocol << " " << name;
    }
  }
}

// Ids of the two files are names of two sets: the nearest target of query i is target i, which is another model.
TEST_F(EvaluationTaskTest, TreatsTwoLabelFilesAsSeparateSetsUnlessIdsAreShared) {
  const auto queries = file("q.cla", "PSB 1\n3 3\n\na 0 1\n0\n\nb 0 1\n1\n\nc 0 1\n2\n");
  const auto targets = file("t.cla", "PSB 1\n3 5\n\na 0 2\n0\n3\n\nb 0 2\n1\n4\n\nc 0 1\n2\n");
  const auto matrix = file("d.txt", "0.1 2 2 2 2\n2 0.1 2 2 2\n2 2 0.1 2 2\n");
  const EvaluationData two = open_evaluation_files({.matrix = matrix, .labels = queries, .targets = targets});
  EXPECT_EQ(measure(two, "NN"), 1);
  EXPECT_THAT(two.task.retrieval.own_column, testing::Each(-1));
  EXPECT_THAT(two.task.warnings, testing::Contains(AllOf(HasSubstr("3 ids are in both"), HasSubstr("`shared_ids`"))));
  const auto other = file("u.cla", "PSB 1\n3 5\n\na 0 1\n1\n\nb 0 2\n0\n4\n\nc 0 2\n2\n3\n");
  EXPECT_NO_THROW(open_evaluation_files({.matrix = matrix, .labels = queries, .targets = other}));

  const EvaluationData shared =
      open_evaluation_files({.matrix = matrix, .labels = queries, .targets = targets, .shared_ids = true});
  EXPECT_THAT(shared.task.retrieval.own_column, ElementsAre(0, 1, 2));
  EXPECT_EQ(measure(shared, "NN"), 0) << "each query is left out of its answer";
  EXPECT_THAT(shared.task.warnings, testing::Each(testing::Not(HasSubstr("in both"))));
}

TEST_F(EvaluationTaskTest, AcceptsASubsetOfQueriesOnlyWithSharedIds) {
  const auto all = file("all.csv", "id,class\n1,a\n2,b\n3,a\n4,b\n");
  const auto part = file("public.csv", "id,class\n4,b\n3,a\n");
  const auto matrix = file("d.txt", "0 9 1 9\n9 0 9 1\n1 9 0 9\n9 1 9 0\n");
  EXPECT_THAT(test::input_error_of([&] { open_evaluation_files({.matrix = matrix, .labels = part, .targets = all}); }),
              AllOf(HasSubstr("d.txt has 4 rows"), HasSubstr("`shared_ids`")));
  const EvaluationData shared =
      open_evaluation_files({.matrix = matrix, .labels = part, .targets = all, .shared_ids = true});
  EXPECT_THAT(shared.task.query_ids, ElementsAre("1", "2", "3", "4"));
  EXPECT_THAT(shared.task.retrieval.query_classes, ElementsAre(no_class, no_class, 1, 0));
  EXPECT_EQ(measure(shared, "NN"), 1);
}

}  // namespace

}  // namespace shapegauge
