// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/datasets/files/model_ids.h"

namespace shapegauge {

namespace {

TEST(ModelKeys, AreModelNumbersOrNamesWithoutExtension) {
  const ModelKeys keys({"T12.off", "m0.off", "12", "m0"});
  for (const char* id : {"12", "T12", "T12.off", "12.obj"}) EXPECT_EQ(keys.of(id), "12") << id;
  EXPECT_EQ(keys.of("m0.obj"), "m0");
  EXPECT_EQ(ModelKeys().of("m0.off"), "m0");
}

TEST(ModelKeys, KeepExtensionsIfIdsDifferOnlyInThem) {
  ModelKeys keys({"m0.off", "m0.obj", "m0.off", "m1.off"});
  EXPECT_EQ(keys.of("m0.off"), "m0.off");
  EXPECT_EQ(keys.of("m0.obj"), "m0.obj");
  EXPECT_EQ(keys.of("m0"), "m0");
  EXPECT_EQ(keys.of("m1.obj"), "m1");
  keys.add(ModelKeys({"m1.off", "m1.ply"}));
  EXPECT_EQ(keys.of("m1.ply"), "m1.ply");
}

}  // namespace

}  // namespace shapegauge
