// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <gmock/gmock.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/configuration/segmentation_experiment.h"
#include "shapegauge/experiments/configuration/shape_comparison.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

/// Experiment configurations shipped with the program.
std::vector<Json> all_experiments() {
  std::set<fs::path> files;
  for (const char* folder : {"", "/paper", "/studies"}) {
    for (const auto& entry : fs::directory_iterator(SHAPEGAUGE_SOURCE_FOLDER "/configs" + std::string(folder))) {
      if (entry.is_regular_file()) files.insert(entry.path());
    }
  }
  std::vector<Json> experiments;
  for (const fs::path& file : files) {
    if (file.filename() != "experiment.schema.json") experiments.push_back(read_json(file));
  }
  return experiments;
}

bool is_comparison(const Json& document) { return document.contains("shapes"); }

bool is_segmentation(const Json& document) { return document.contains("segmentation"); }

void read(const Json& document) {
  if (is_comparison(document)) {
    comparison_from_json(document, "x.json", "/configs");
  } else if (is_segmentation(document)) {
    segmentation_from_json(document, "x.json", "/configs");
  } else {
    configuration_from_json(document, "x.json", "/configs");
  }
}

/// Error of reading a document, or "". Fails on exceptions other than user errors.
std::string error_of(const Json& document) {
  try {
    read(document);
    return "";
  } catch (const InputError& error) {
    return error.what();
  } catch (const std::exception& error) {
    ADD_FAILURE() << error.what() << " is what reading gives of " << document.dump();
    return error.what();
  }
}

/// JSON pointers of all values of a document.
void add_pointers(const Json& value, const Json::json_pointer& pointer, std::vector<Json::json_pointer>& pointers) {
  if (!pointer.empty()) pointers.push_back(pointer);
  if (value.is_object()) {
    for (const auto& [key, child] : value.items()) add_pointers(child, pointer / key, pointers);
  }
  for (std::size_t i = 0; value.is_array() && i < value.size(); ++i) add_pointers(value[i], pointer / i, pointers);
}

/// Path as in messages, such as "signatures.0.field".
std::string dotted(const Json::json_pointer& pointer) {
  std::string text = pointer.to_string().substr(1);
  std::ranges::replace(text, '/', '.');
  return text;
}

/// First occurrence of each path (without indices) and value type in all experiments.
std::vector<std::pair<Json, Json::json_pointer>> pointers_of_every_kind() {
  std::vector<std::pair<Json, Json::json_pointer>> result;
  std::set<std::string> seen;
  for (const Json& experiment : all_experiments()) {
    const std::string kind = is_comparison(experiment) ? "shapes" : is_segmentation(experiment) ? "parts" : "retrieval";
    std::vector<Json::json_pointer> pointers;
    add_pointers(experiment, Json::json_pointer(), pointers);
    for (const Json::json_pointer& pointer : pointers) {
      const std::string name = std::regex_replace(pointer.to_string(), std::regex("/[0-9]+"), "/N");
      const Json& parent = experiment[pointer.parent_pointer()];
      const std::string type = parent.is_object() ? parent.value("type", "") : "";
      if (seen.insert(kind + name + experiment[pointer].type_name() + type).second)
        result.emplace_back(experiment, pointer);
    }
  }
  return result;
}

class ConfigurationCheck : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* folder : {"SHAPEGAUGE_DATA", "SHREC11_ROOT"}) setenv(folder, "/data", 0);
  }
};

TEST_F(ConfigurationCheck, AcceptsEveryShippedConfigurationFile) {
  for (const Json& experiment : all_experiments()) EXPECT_EQ(error_of(experiment), "");
}

TEST_F(ConfigurationCheck, RejectsInvalidValuesWithTheirLocation) {
  const std::vector<Json> values = {
      nullptr,   true, -1.5, 1e300, std::numeric_limits<std::uint64_t>::max(), "x", Json::array({1, "x", nullptr}),
      {{"x", 1}}};
  std::size_t errors = 0;
  for (const auto& [experiment, pointer] : pointers_of_every_kind()) {
    for (const Json& value : values) {
      Json changed = experiment;
      changed[pointer] = value;
      const std::string error = error_of(changed);
      if (error.empty()) continue;
      ++errors;
      EXPECT_THAT(error, Not(HasSubstr("json.exception"))) << pointer << " " << value;
      EXPECT_THAT(error, HasSubstr("x.json: ")) << pointer << " " << value;
      const bool is_of_no_type = value.is_null() || value.is_array() || value.is_object();
      if (is_of_no_type && !experiment[pointer].is_structured()) {
        EXPECT_THAT(error, HasSubstr(dotted(pointer))) << pointer << " " << value;
      }
    }
  }
  EXPECT_GT(errors, 500U);
}

TEST_F(ConfigurationCheck, ReportsMissingKeysAsInputErrors) {
  for (const auto& [experiment, pointer] : pointers_of_every_kind()) {
    Json changed = experiment;
    Json& parent = changed[pointer.parent_pointer()];
    if (parent.is_object()) {
      parent.erase(pointer.back());
    } else {
      parent.erase(std::stoul(pointer.back()));
    }
    EXPECT_THAT(error_of(changed), Not(HasSubstr("json.exception"))) << pointer;
  }
}

TEST_F(ConfigurationCheck, RejectsConfigurationsOfAnotherKindOfExperiment) {
  for (const Json& experiment : all_experiments()) {
    const auto refuses = [&](auto&& reading) {
      try {
        reading();
      } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("x.json: "));
        return true;
      }
      return false;
    };
    const bool shapes = is_comparison(experiment);
    const bool parts = is_segmentation(experiment);
    EXPECT_EQ(refuses([&] { configuration_from_json(experiment, "x.json", "/configs"); }), shapes || parts);
    EXPECT_EQ(refuses([&] { comparison_from_json(experiment, "x.json", "/configs"); }), !shapes);
    EXPECT_EQ(refuses([&] { segmentation_from_json(experiment, "x.json", "/configs"); }), !parts);
  }
}

TEST_F(ConfigurationCheck, RejectsDocumentsThatAreNotObjects) {
  for (const Json& document : {Json(), Json(3), Json("x"), Json::array(), Json::object()}) {
    EXPECT_NE(error_of(document), "") << document;
  }
}

}  // namespace

}  // namespace shapegauge
