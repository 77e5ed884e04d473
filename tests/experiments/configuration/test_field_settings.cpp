// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/configuration/field_settings.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

TEST(ReadField, ReadsSettingsAndFillsInDefaults) {
  const Field field = read_field({{"type", "offset_sdf"}, {"offset", 0.03}, {"at", "vertices"}});
  EXPECT_EQ(field.settings.samples.site, SampleSite::vertices);
  EXPECT_EQ(field.settings.values.number("offset"), 0.03);
  EXPECT_EQ(to_json(field.settings),
            (Json{{"type", "offset_sdf"}, {"offset", 0.03}, {"accuracy", "standard"}, {"at", "vertices"}}));
  EXPECT_EQ(to_json(read_field({{"type", "offset_sdf"}, {"offset", "auto"}}).settings)["offset"], "auto");
  EXPECT_EQ(read_field({{"type", "cone_sdf"}, {"rays", 9}}).settings.samples.site, SampleSite::faces);
  EXPECT_EQ(read_field({{"type", "cone_sdf"}, {"at", {{"surface", 50}}}}).settings.samples,
            (SamplePlan{.site = SampleSite::surface, .count = 50}));
}

TEST(ReadField, ReadsBilateralSmoothing) {
  const Field field = read_field({{"type", "cone_sdf"}, {"bilateral", {{"spatial_width", 0.2}}}});
  EXPECT_EQ(field.settings.smoothing.value().number("spatial_width"), 0.2);
  EXPECT_EQ(to_json(field.settings)["bilateral"]["iterations"], 1);
  EXPECT_FALSE(read_field({{"type", "cone_sdf"}}).settings.smoothing.has_value());
}

}  // namespace

}  // namespace shapegauge
