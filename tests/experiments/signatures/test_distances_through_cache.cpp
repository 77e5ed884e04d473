// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/experiments/cache/cache_folder.h"
#include "shapegauge/experiments/signatures/signature_tables.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

CacheUse use_of(const Cache& cache) { return cache.report().uses.at(static_cast<std::size_t>(EntryKind::distances)); }

TEST(DistancesThroughCache, AreComputedOnce) {
  const test::TemporaryFolder folder;
  const Signatures signatures = Signatures::Random(7, 5);
  const DistanceMatrix expected = distance_matrix(signatures);
  Cache first(folder.path() / "cache");
  EXPECT_EQ(distances_through_cache(signatures, distances().at("l1"), first), expected);
  EXPECT_EQ(use_of(first).computed, 1U);
  Cache second(folder.path() / "cache");
  EXPECT_EQ(distances_through_cache(signatures, distances().at("l1"), second), expected);
  EXPECT_EQ(use_of(second).hits, 1U);
  Signatures other = signatures;
  other(3, 3) += 1;
  EXPECT_EQ(distances_through_cache(other, distances().at("l1"), second), distance_matrix(other));
  EXPECT_EQ(use_of(second).computed, 1U);
}

TEST(DistancesThroughCache, AreNotStoredForLargeMatrices) {
  const test::TemporaryFolder folder;
  Cache cache(folder.path() / "cache");
  distances_through_cache(Signatures::Random(max_models_of_cached_distances + 1, 1), distances().at("l1"), cache);
  EXPECT_EQ(cache_contents(folder.path() / "cache").total().entries, 0U);
}

TEST(DistancesThroughCache, AreComputedWithoutACache) {
  Cache none;
  const Signatures signatures = Signatures::Random(4, 5);
  EXPECT_EQ(distances_through_cache(signatures, distances().at("l1"), none), distance_matrix(signatures));
}

}  // namespace

}  // namespace shapegauge
