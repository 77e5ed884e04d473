// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/retrieval/manifest_entries.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using OrderedJson = nlohmann::ordered_json;
using test::write_text;

// SHA-256 of "abc" and of the empty text: FIPS 180-4.
constexpr const char* hash_of_abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

TEST(ManifestEntries, ListInputsAndFailures) {
  const test::TemporaryFolder folder;
  write_text(folder.path() / "failed.off", "abc");
  ExperimentResults results;
  results.configuration.location =
      DatasetLocation{.layout = "shrec11", .root = folder.path(), .classification = folder.path() / "failed.off"};
  results.configuration.seed = 17;
  results.configuration.report.enabled = false;
  results.models = {{.id = "3", .file = "", .label = 1}, {.id = "5", .file = "", .label = 0}};
  results.shapes.resize(2);
  results.shapes[0].sha256 = "aa";
  results.shapes[1].sha256 = "bb";
  results.failures = {{.id = "7", .message = "broken", .file = folder.path() / "failed.off"},
                      {.id = "8", .message = "absent", .file = folder.path() / "absent.off"}};
  const OrderedJson json = manifest_entries(results);
  EXPECT_EQ(json["inputs"]["models"], (OrderedJson{{"3", "aa"}, {"5", "bb"}, {"7", hash_of_abc}}));
  EXPECT_EQ(json["inputs"]["classification"], hash_of_abc);
  EXPECT_EQ(json["seed"], 17);
  EXPECT_EQ(json["models"], 2);
  EXPECT_EQ(json["failed_models"],
            (OrderedJson::array({{{"model", "7"}, {"error", "broken"}}, {{"model", "8"}, {"error", "absent"}}})));
}

}  // namespace

}  // namespace shapegauge
