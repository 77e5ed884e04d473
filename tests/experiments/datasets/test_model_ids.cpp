#include <gtest/gtest.h>

#include "shapegauge/experiments/datasets/model_ids.h"

namespace shapegauge {
namespace {

TEST(ModelIds, ThreeSpellingsOfOneModel) {
  EXPECT_EQ(canonical_model_id("12"), "12");
  EXPECT_EQ(canonical_model_id("T12"), "12");
  EXPECT_EQ(canonical_model_id("T12.off"), "12");
  EXPECT_EQ(canonical_model_id("12.OFF"), "12");
  EXPECT_TRUE(same_model("T12.off", "12"));
  EXPECT_FALSE(same_model("T12.off", "120"));
  EXPECT_FALSE(same_model("T12", "T1"));
}

TEST(ModelIds, OtherNamesKeepAllButTheExtension) {
  EXPECT_EQ(canonical_model_id("horse-1.ply"), "horse-1");
  EXPECT_EQ(canonical_model_id("Trex"), "Trex");
  EXPECT_EQ(canonical_model_id("T12a"), "T12a");
  EXPECT_EQ(canonical_model_id("TT12"), "TT12");
  EXPECT_EQ(canonical_model_id("t12"), "t12");
  EXPECT_EQ(canonical_model_id("T"), "T");
  EXPECT_EQ(canonical_model_id("notes.txt"), "notes.txt");
  EXPECT_EQ(canonical_model_id(".off"), ".off");
  EXPECT_EQ(canonical_model_id("a.off.off"), "a.off");
  EXPECT_EQ(canonical_model_id(""), "");
}

}  // namespace
}  // namespace shapegauge
