#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapegauge/experiments/datasets/classification.h"
#include "tests/experiments/input_error.h"

namespace shapegauge {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

const Classification animals = {{{"animal", std::nullopt, {}}, {"horse", 0, {"10", "2"}}, {"bird", 0, {"1"}}}};

TEST(Classification, CountsAndListsItsModels) {
  EXPECT_EQ(model_count(animals), 3U);
  EXPECT_THAT(models_in_file_order(animals), ElementsAre("10", "2", "1"));
  EXPECT_THAT(models_in_natural_order(animals), ElementsAre("1", "2", "10"));
}

TEST(ClassLabels, FollowTheIdsInAnySpelling) {
  const std::vector<std::string> ids = {"T1.off", "T2", "10"};
  EXPECT_THAT(class_labels(animals, ids, "x.cla"), ElementsAre(2, 1, 1));
}

TEST(ClassLabels, NameTheModelThatDoesNotFit) {
  const auto error_for = [](const std::vector<std::string>& ids) {
    return input_error_of([&] { class_labels(animals, ids, "x.cla"); });
  };
  EXPECT_THAT(error_for({"1", "2", "10", "T3"}), AllOf(HasSubstr("x.cla: "), HasSubstr("\"T3\" is in no class")));
  EXPECT_THAT(error_for({"1", "10"}), AllOf(HasSubstr("x.cla: "), HasSubstr("\"2\" is classified")));
  EXPECT_THAT(error_for({"1", "2", "10", "T2.off"}), HasSubstr("\"T2.off\" occurs twice"));
}

}  // namespace
}  // namespace shapegauge
