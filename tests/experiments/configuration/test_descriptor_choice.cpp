// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/configuration/descriptor_choice.h"
#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/retrieval/descriptors/d2.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

Json joint_settings() {
  return Json::parse(R"({"type": "joint_histogram", "fields": [{"type": "cone_sdf"}, {"type": "centricity"}],
                         "axes": [{"bins": 3}]})");
}

Configuration configuration_of_descriptor(const Json& descriptor) {
  return configuration_from_json({{"name", "x"},
                                  {"dataset", {{"generate", Json::object()}}},
                                  {"signatures", {{{"name", "a"}, {"descriptor", descriptor}}}}},
                                 "x.json", ".");
}

std::string descriptor_error_with(const Json& descriptor) {
  return test::input_error_of([&] { configuration_of_descriptor(descriptor); });
}

TEST(MakeDescriptor, AppliesSettingsToTheRegisteredDescriptor) {
  const DescriptorChoice choice = make_descriptor({{"type", "d2"}, {"bins", 10}});
  EXPECT_EQ(to_json(choice), (Json{{"type", "d2"}, {"bins", 10}, {"points", 1024}, {"longest", 3.0}}));
  const Shape shape = test::sphere(1, 2);
  EXPECT_EQ(choice.descriptor.describe({shape, {}}, {}, choice.values), d2(shape, {.bins = 10}));
}

TEST(MakeDescriptor, FillsInTheDefaultsOfFieldsAndAxes) {
  const DescriptorChoice choice = make_descriptor(joint_settings());
  ASSERT_EQ(choice.fields.size(), 2U);
  EXPECT_EQ(to_json(choice)["fields"][1], to_json(choice.fields[1].settings));
  EXPECT_EQ(choice.values.axes[0].integer("bins"), 3);
  EXPECT_EQ(choice.values.axes[1].integer("bins"), 40);
  EXPECT_EQ(to_json(make_descriptor(to_json(choice))), to_json(choice));
}

TEST(DescriptorConfiguration, IsReadBackAsWritten) {
  const Json filled = to_json(configuration_of_descriptor(joint_settings()));
  EXPECT_EQ(to_json(configuration_from_json(filled, "again.json", ".")), filled);
  EXPECT_EQ(filled["signatures"][0]["descriptor"]["axes"].size(), 2U);
}

TEST(DescriptorConfiguration, ErrorsNameTheLocationInTheDocument) {
  EXPECT_THAT(descriptor_error_with({{"type", "d3"}}), HasSubstr("signatures.0.descriptor.type"));
  EXPECT_THAT(descriptor_error_with({{"type", "d2"}, {"bin", 3}}), HasSubstr("did you mean \"bins\"?"));
  EXPECT_THAT(descriptor_error_with({{"type", "d2"}, {"bins", 0}}), HasSubstr("signatures.0.descriptor.bins"));
  EXPECT_THAT(descriptor_error_with({{"type", "d2"}, {"fields", Json::array()}}), HasSubstr("fields"));
  Json wrong = joint_settings();
  wrong["fields"].erase(1);
  EXPECT_THAT(descriptor_error_with(wrong), HasSubstr("signatures.0.descriptor.fields"));
  wrong = joint_settings();
  wrong["fields"][1]["at"] = "vertices";
  EXPECT_THAT(descriptor_error_with(wrong), HasSubstr("signatures.0.descriptor.fields.1.at"));
  wrong = joint_settings();
  wrong["axes"] = {Json::object(), Json::object(), Json::object()};
  EXPECT_THAT(descriptor_error_with(wrong), HasSubstr("signatures.0.descriptor.axes"));
  wrong = joint_settings();
  wrong["axes"][0] = {{"low", 2}};
  EXPECT_THAT(descriptor_error_with(wrong), HasSubstr("signatures.0.descriptor"));
}

TEST(OffsetWarnings, WarnOfGapsAndHollowShapes) {
  const auto warnings = [](const Json& offset, const Shape& shape) {
    const Json fields{{{"type", "offset_sdf"}, {"offset", offset}}, {{"type", "offset_sdf"}, {"offset", offset}}};
    FieldSource source(shape);
    return compute_fields(make_descriptor({{"type", "joint_histogram"}, {"fields", fields}}), source).warnings;
  };
  const Shape box = test::box({4, 3, 1}, 1);
  EXPECT_THAT(warnings(0.01, box), testing::IsEmpty());
  Shape open = box;
  open.triangles = box.triangles.topRows(box.triangles.rows() - 2);
  for (const Json& offset : {Json(0.01), Json("auto")}) {
    const std::vector<std::string> found = warnings(offset, open);
    EXPECT_THAT(found, testing::ElementsAre(HasSubstr("on both sides"))) << "one for both fields";
  }
  const Shape wall =
      test::joined({box, test::flipped(test::transformed(box, 0.5, Eigen::Matrix3d::Identity(), {0, 0, 0}))});
  EXPECT_THAT(warnings(0.01, wall), testing::ElementsAre(HasSubstr("hollow")));
  FieldSource source(open);
  const Json cones{{{"type", "cone_sdf"}}, {{"type", "cone_sdf"}}};
  const DescriptorChoice choice = make_descriptor({{"type", "joint_histogram"}, {"fields", cones}});
  EXPECT_THAT(compute_fields(choice, source).warnings, testing::ElementsAre(HasSubstr("missing")));
}

TEST(DescriptorConfiguration, EnablesReportPicturesOnlyForDescriptorsOfFields) {
  const ReportConfiguration with_fields = configuration_of_descriptor(joint_settings()).report;
  EXPECT_TRUE(with_fields.pictures);
  EXPECT_EQ(with_fields.pictured_signature, 0U);
  EXPECT_FALSE(configuration_of_descriptor({{"type", "d2"}}).report.pictures);
}

}  // namespace

}  // namespace shapegauge
