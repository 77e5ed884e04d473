#include <gmock/gmock.h>

#include "shapegauge/experiments/report/heat_map.h"
#include "shapegauge/experiments/report/packed_values.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {
namespace {

using testing::ElementsAre;

TEST(OrderByClass, ClassByClassInTheModelsOrder) {
  EXPECT_THAT(order_by_class(std::vector<int>{2, 0, 1, 0, 2}), ElementsAre(1, 3, 2, 0, 4));
}

TEST(HeatMap, OfASymmetricMatrixHasTheUpperHalfInTheClassesOrder) {
  // Models 1 and 2 are of the first class, 0 of the second.
  const DistanceMatrix distances{{0, 1, 2}, {1, 0, 4}, {2, 4, 0}};
  const auto json = heat_map(distances, std::vector<int>{1, 0, 0});
  EXPECT_EQ(json["side"], 3);
  EXPECT_EQ(json["block"], 1);
  EXPECT_EQ(json["symmetric"], true);
  EXPECT_EQ(json["values"], packed(Eigen::VectorXd{{0, 4, 1, 0, 2, 0}})["values"]);
  EXPECT_EQ(json["scale"], 4);
}

TEST(HeatMap, OfAnyOtherMatrixHasAllCellsAndTheDiagonalPlaysNoPart) {
  const DistanceMatrix distances{{9, 1}, {3, 9}};
  const auto json = heat_map(distances, std::vector<int>{0, 0});
  EXPECT_EQ(json["symmetric"], false);
  EXPECT_EQ(json["values"], packed(Eigen::VectorXd{{0, 1, 3, 0}})["values"]);
}

TEST(HeatMap, OfManyModelsIsOfTheMeansOfBlocks) {
  const Eigen::Index models = 2 * largest_heat_map + 1;
  DistanceMatrix distances = DistanceMatrix::Constant(models, models, 6);
  distances.diagonal().setConstant(1e9);
  const auto json = heat_map(distances, std::vector<int>(static_cast<std::size_t>(models), 0));
  EXPECT_EQ(json["block"], 3);
  const Eigen::Index side = json["side"];
  EXPECT_EQ(side, 667);
  EXPECT_EQ(json["symmetric"], true);
  EXPECT_EQ(json["scale"], 6);
  // In the first cell three of nine pairs are of a model with itself: the mean is 4.
  EXPECT_EQ(json["values"].get<std::string>().substr(0, 4), base64(std::string("\xa9\xaa\xfe", 3)));
}

}  // namespace
}  // namespace shapegauge
