// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/engine/manifest.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using OrderedJson = nlohmann::ordered_json;
using test::write_text;

// SHA-256 of "abc" and of the empty text: FIPS 180-4.
constexpr const char* hash_of_abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

TEST(RunManifest, HashesOutputsExceptTimings) {
  const test::TemporaryFolder folder;
  write_text(folder.path() / "summary.csv", "abc");
  write_text(folder.path() / "shape_seconds.csv", "1");
  const std::vector<std::string> files{"summary.csv", "shape_seconds.csv"};
  EXPECT_EQ(outputs_json(folder.path(), files),
            (OrderedJson{{"algorithm", "SHA-256"}, {"files", {{"summary.csv", hash_of_abc}}}}));
}

TEST(RunManifest, CountsCachedAndComputedResultsByKind) {
  EXPECT_EQ(cache_json({}), nullptr);
  CacheReport report{.folder = "cache", .uses = {}};
  report.uses.at(static_cast<std::size_t>(EntryKind::field)) = {.hits = 2, .computed = 1};
  report.uses.at(static_cast<std::size_t>(EntryKind::comparison)) = {.hits = 0, .computed = 4};
  EXPECT_EQ(cache_json(report), (OrderedJson{{"field", {{"from_cache", 2}, {"computed", 1}}},
                                             {"comparison", {{"from_cache", 0}, {"computed", 4}}}}));
}

}  // namespace

}  // namespace shapegauge
