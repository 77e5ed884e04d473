#include <gtest/gtest.h>
#include <stdexcept>

#include "shapegauge/metrics/statistics/units.h"

namespace shapegauge {
namespace {

// Class 7: values 1, 2, 3; class 4: value 10.
const Eigen::MatrixXd values = (Eigen::MatrixXd(4, 1) << 1, 10, 2, 3).finished();
const std::vector<int> classes = {7, 4, 7, 7};

TEST(Units, GiveTheSameAverageWhateverTheBlocksAre) {
  for (const Blocks blocks : {Blocks::classes, Blocks::queries}) {
    EXPECT_DOUBLE_EQ(averages_of(units_of(values, classes, blocks, Average::micro))[0], 4);
    EXPECT_DOUBLE_EQ(averages_of(units_of(values, classes, blocks, Average::macro))[0], 6);
  }
}

TEST(Units, AreClassesOrQueries) {
  const Units of_classes = units_of(values, classes, Blocks::classes, Average::micro);
  EXPECT_EQ(of_classes.values, (Eigen::MatrixXd(2, 1) << 10, 2).finished());
  EXPECT_EQ(of_classes.weights, (Eigen::VectorXd(2) << 0.25, 0.75).finished());
  EXPECT_EQ(units_of(values, classes, Blocks::queries, Average::macro).weights,
            (Eigen::VectorXd(4) << 1.0 / 6, 0.5, 1.0 / 6, 1.0 / 6).finished());
}

TEST(Units, ContributionsHaveTheAverageAsTheirMean) {
  const Units units = units_of(values, classes, Blocks::classes, Average::micro);
  EXPECT_DOUBLE_EQ(contributions(units.values.col(0), units.weights).mean(), 4);
}

TEST(Units, HaveTheirNamesBothWays) {
  for (const std::string& name : blocks_names()) EXPECT_EQ(name_of(blocks_of(name).value()), name);
  for (const std::string& name : average_names()) EXPECT_EQ(name_of(average_of(name).value()), name);
  EXPECT_FALSE(blocks_of("models"));
  EXPECT_FALSE(average_of("mean"));
}

TEST(Units, RefuseWhatDoesNotFit) {
  EXPECT_THROW(units_of(values, std::vector<int>{1}, Blocks::classes, Average::micro), std::invalid_argument);
  EXPECT_THROW(units_of(Eigen::MatrixXd(0, 1), {}, Blocks::classes, Average::micro), std::invalid_argument);
}

}  // namespace
}  // namespace shapegauge
