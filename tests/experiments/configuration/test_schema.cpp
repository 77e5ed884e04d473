// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/configuration/schema.h"

namespace shapegauge {

namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

TEST(ParameterGroups, StateTheUnitsOfAnglesAndOffsets) {
  std::size_t angles = 0;
  std::size_t offsets = 0;
  for (const ParameterGroup& field : field_groups()) {
    for (const Parameter& parameter : field.parameters) {
      const bool angle = parameter.name.ends_with("_degrees");
      const bool offset = parameter.name == "offset";
      angles += angle;
      offsets += offset;
      EXPECT_EQ(parameter.unit == "degrees", angle) << field.name << ' ' << parameter.name;
      EXPECT_EQ(parameter.unit == bounding_box_diagonals, offset) << field.name << ' ' << parameter.name;
    }
  }
  EXPECT_GE(angles, 2);
  EXPECT_GE(offsets, 1);
}

Json schema_at(const std::string& pointer) { return Json(schema_definitions()).at(Json::json_pointer(pointer)); }

TEST(ExperimentSchema, ContainsParametersOfFieldsGeneratedShapesAndHistograms) {
  const Json cone = schema_at("/field/allOf/1/then");
  EXPECT_EQ(cone["properties"]["type"]["const"], "cone_sdf");
  EXPECT_EQ(cone["properties"]["rays"]["minimum"], 1);
  EXPECT_EQ(cone["properties"]["rays"]["default"], 25);
  EXPECT_EQ(cone["required"], Json({"type"}));
  EXPECT_EQ(schema_at("/field/allOf/0/then/required"), Json({"type", "offset"}));
  EXPECT_EQ(schema_at("/generated_shape/required"), Json({"class"}));
  EXPECT_EQ(schema_at("/histogram/required"), Json({"range"}));
  EXPECT_EQ(schema_at("/histogram/properties/bins/maximum"), 100000);
}

TEST(ConfigurationReference, ShowsAValidConfiguration) {
  const std::string page = read_file_bytes(SHAPEGAUGE_SOURCE_FOLDER "/docs/reference/configuration.md");
  const std::string_view fence = "```json\n";
  const std::size_t begin = page.find(fence) + fence.size();
  const Json document = Json::parse(page.substr(begin, page.find("```", begin) - begin));
  const Configuration configuration = configuration_from_json(document, "example", ".");
  EXPECT_EQ(configuration.signatures.size(), document["signatures"].size());
}

TEST(ExtendingGuide, ShowsOnlyCodeOfTheTestedExampleProgram) {
  const std::string program = read_file_bytes(SHAPEGAUGE_SOURCE_FOLDER "/tests/package/consumer/extend.cpp");
  const std::string page = read_file_bytes(SHAPEGAUGE_SOURCE_FOLDER "/docs/developer/extending.md");
  const std::string_view fence = "```cpp\n";
  int shown = 0;
  for (auto begin = page.find(fence); begin != std::string::npos; begin = page.find(fence, begin + 1)) {
    const std::size_t code = begin + fence.size();
    EXPECT_THAT(program, HasSubstr(page.substr(code, page.find("```", code) - code)));
    ++shown;
  }
  EXPECT_EQ(shown, 9);  // one for each registry
}

/// Cells of the rows of a page's first table, without its head.
std::vector<std::vector<std::string>> first_table(const std::string& page) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string_view line : split_lines(std::string_view(page).substr(page.find("|---|")))) {
    if (!line.starts_with('|')) break;
    std::vector<std::string> cells;
    for (std::size_t begin = 1; begin < line.size();) {
      const std::size_t end = line.find('|', begin);
      cells.emplace_back(trim(line.substr(begin, end - begin)));
      begin = end + 1;
    }
    rows.push_back(cells);
  }
  rows.erase(rows.begin());
  return rows;
}

/// Words of a text between backquotes.
std::vector<std::string> code_words(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t begin = text.find('`'); begin != std::string::npos; begin = text.find('`', begin)) {
    const std::size_t end = text.find('`', begin + 1);
    words.push_back(text.substr(begin + 1, end - begin - 1));
    begin = end + 1;
  }
  return words;
}

TEST(ExtendingGuide, NamesExistingFilesForEachKindOfExtension) {
  const std::string program = read_file_bytes(SHAPEGAUGE_SOURCE_FOLDER "/tests/package/consumer/extend.cpp");
  const std::filesystem::path repository = SHAPEGAUGE_SOURCE_FOLDER;
  int from_outside = 0;
  for (const std::vector<std::string>& row :
       first_table(read_file_bytes(SHAPEGAUGE_SOURCE_FOLDER "/docs/developer/extending.md"))) {
    ASSERT_EQ(row.size(), 6U);
    for (const std::string& path : code_words(row[3] + row[4])) {
      EXPECT_TRUE(std::filesystem::exists(repository / path)) << path;
    }
    for (const std::string& folder : code_words(row[5])) {
      EXPECT_TRUE(std::filesystem::exists(repository / folder / "CMakeLists.txt")) << folder;
    }
    if (row[2] == "no") continue;
    ++from_outside;
    const std::string registration = "shapegauge::" + code_words(row[1]).at(0) + ".add(";
    EXPECT_NE(program.find(registration), std::string::npos) << registration;
    EXPECT_EQ(program.find(registration), program.rfind(registration)) << registration << " more than once";
  }
  EXPECT_EQ(from_outside, 9);
}

}  // namespace

}  // namespace shapegauge
