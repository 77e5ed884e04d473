#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapegauge/experiments/evaluation/matrix_remarks.h"

namespace shapegauge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<std::string> ids = {"a", "b", "c", "d"};

TEST(MatrixRemarks, NothingOddIsNoRemark) { EXPECT_THAT(matrix_remarks({}, ids, false), IsEmpty()); }

TEST(MatrixRemarks, SayWhatWasFoundAndWhatItDoes) {
  MatrixFindings findings;
  findings.negative = 1;
  findings.infinite = 2;
  findings.asymmetric_pairs = 3;
  findings.largest_asymmetry = 0.25;
  findings.nonzero_diagonal = 4;
  findings.rows_nearest_to_others = 4;
  findings.equal_rows = {{3, 1}};
  findings.constant_rows = {0, 2};
  EXPECT_THAT(matrix_remarks(findings, ids, false),
              ElementsAre(HasSubstr("1 distance is negative"), HasSubstr("2 distances are infinite"),
                          HasSubstr("in 4 of 4 rows the query is the farthest"),
                          HasSubstr("not symmetric: 3 pairs of entries (i, j) and (j, i) differ, by up to 0.25"),
                          HasSubstr("4 entries are not 0 on the diagonal"),
                          HasSubstr("1 row repeats an earlier one (first: d repeats b)"),
                          HasSubstr("2 rows have all distances equal (first: a)")));
}

TEST(MatrixRemarks, OfSimilaritiesSayNothingOfSignsAndTheDiagonal) {
  MatrixFindings findings;
  findings.negative = 12;
  findings.nonzero_diagonal = 4;
  EXPECT_THAT(matrix_remarks(findings, ids, true), IsEmpty());
}

}  // namespace
}  // namespace shapegauge
