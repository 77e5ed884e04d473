// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/results/protocol_audit.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;

// Two queries of a class and four targets, two of them relevant. `good` finds these first, `late` at ranks 1 and 4.
class ProtocolAuditOfTwoMethods : public test::FolderTest {
 protected:
  [[nodiscard]] ProtocolAudit audit() const {
    return audit_protocols(std::vector{late_, good_}, files_, {.resampling = {.resamples = 20}});
  }

 private:
  std::filesystem::path good_ = folder_.file("good.txt", "1 2 3 4\n4 3 2 1\n");
  std::filesystem::path late_ = folder_.file("late.txt", "1 4 2 3\n3 2 4 1\n");
  EvaluationFiles files_{.matrix = {},
                         .labels = folder_.file("q.csv", "id,class\n0,a\n1,b\n"),
                         .targets = folder_.file("t.csv", "id,class\n5,a\n6,a\n7,b\n8,b\n")};
};

const AuditedScore& score_of(const ProtocolAudit& audit, const std::string& evaluator, const std::string& measure) {
  for (const AuditedScore& score : audit.scores) {
    if (score.evaluator == evaluator && score.measure == measure) return score;
  }
  throw std::runtime_error(evaluator + " has no " + measure);
}

TEST_F(ProtocolAuditOfTwoMethods, ContainsTheScoresOfEachEvaluationProgram) {
  const ProtocolAudit found = audit();
  EXPECT_THAT(found.methods, ElementsAre("late", "good"));
  EXPECT_EQ(score_of(found, "shapegauge", "FT").values, Eigen::Vector2d(0.5, 1));
  EXPECT_EQ(score_of(found, "shrec21", "shrec21.FT").values, Eigen::Vector2d(1, 1.5));
  EXPECT_EQ(score_of(found, "shrec21", "shrec21.ST").values, Eigen::Vector2d(0.75, 1));
  EXPECT_EQ(score_of(found, "pytorch_metric_learning", "pytorch_metric_learning.MAP@R").values,
            Eigen::Vector2d(0.5, 1));
  EXPECT_THAT(score_of(found, "shrec21", "shrec21.FT").ranks, ElementsAre(2U, 1U));
  EXPECT_THAT(score_of(found, "shrec21", "NN").ranks, ElementsAre(1U, 1U));
}

TEST_F(ProtocolAuditOfTwoMethods, TabulatesAMeasureWithColumnsForProgramsWhoseScoresDiffer) {
  const ProtocolAudit found = audit();
  EXPECT_THAT(audited_quantities(found), ElementsAre("NN", "FT", "ST", "mAP", "nDCG"));
  const TextTable table = audit_table(found, "FT", {.percent = true, .decimals = 0});
  // The other programs have the scores of shapegauge.
  EXPECT_THAT(table.header,
              ElementsAre("method", "tied", "shapegauge", "low", "high", "ranks", "shrec21 shrec21.FT", "rank"));
  EXPECT_THAT(table.rows[0], testing::IsSupersetOf({"good", "100", "150", "1"}));
  EXPECT_THAT(table.rows[1], testing::IsSupersetOf({"late", "50", "100", "2"}));
  // SHREC'21's second tier separates the two, which the usual one does not.
  for (const std::vector<std::string>& row : audit_summary(found).rows) {
    EXPECT_EQ(row[5], row[2] == "shrec21.ST" ? "1" : "0") << row[1] << " " << row[2];
  }
  EXPECT_EQ(audit_csv_table(found).rows.size(), 2 * found.scores.size());
  EXPECT_THAT(audit_csv_table(found).rows[3], testing::Contains("100.0000")) << "the interval of good's FT";
  EXPECT_EQ(audit_json(found)["scores"][1]["values"][1], 1);
  EXPECT_EQ(audit_json(found)["scores"][1]["possible_ranks"].size(), 2U);
}

// The labels are those of both files.
TEST_F(ProtocolAuditOfTwoMethods, WarnsOnlyOnceOfASuspectLabelSharedByBothMethods) {
  test::TemporaryFolder folder;
  const std::vector matrices{folder.file("a.csv", "0,1,2\n1,0,3\n2,3,0\n"),
                             folder.file("b.csv", "0,1,4\n1,0,3\n4,3,0\n")};
  const ProtocolAudit found =
      audit_protocols(matrices, {.matrix = {}, .labels = folder.file("l.csv", "id,class\n0,a\n1,a\n2,nan\n")},
                      {.resampling = {.resamples = 20}});
  EXPECT_EQ(std::ranges::count_if(found.warnings,
                                  [](const std::string& text) { return text.find("nan") != std::string::npos; }),
            1)
      << testing::PrintToString(found.warnings);
}

// All lists are equal, so that all queries of the class a have a first tier of 1 and those of b 0: resampled classes
// range from 0 to 1, unless the rows of a file are assigned to other queries.
TEST_F(ProtocolAuditOfTwoMethods, AcceptsFilesWithQueriesInAnyOrder) {
  const auto list = [](const std::string& query) {
    return query + " Q0 5 1 4 run\n" + query + " Q0 6 2 3 run\n" + query + " Q0 7 3 2 run\n" + query +
           " Q0 8 4 1 run\n";
  };
  test::TemporaryFolder folder;
  const std::vector runs{folder.file("one.run", list("0") + list("1") + list("2") + list("3")),
                         folder.file("other.run", list("3") + list("0") + list("2") + list("1"))};
  const ProtocolAudit found = audit_protocols(runs,
                                              {.matrix = {},
                                               .labels = folder.file("q.csv", "id,class\n0,a\n1,a\n2,b\n3,b\n"),
                                               .targets = folder.file("t.csv", "id,class\n5,a\n6,a\n7,b\n8,b\n")},
                                              {.resampling = {.resamples = 100}});
  for (const MethodStanding& standing : found.standings[1]) {
    EXPECT_EQ(standing.interval->low, 0);
    EXPECT_EQ(standing.interval->high, 1);
  }
}

}  // namespace

}  // namespace shapegauge
