// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <string>
#include <vector>

#include "shapegauge/datasets/files/model_ids.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;

std::vector<std::string> sorted(std::vector<std::string> names) {
  std::ranges::sort(names, natural_less);
  return names;
}

TEST(DistinguishingEnds, AreTheShortestUniqueEndsOfPaths) {
  EXPECT_THAT(distinguishing_suffixes({"a/x.off", "b/y.off"}), ElementsAre("x", "y"));
  EXPECT_THAT(distinguishing_suffixes({"a/x.off", "b/x.obj"}), ElementsAre("x.off", "x.obj"));
  EXPECT_THAT(distinguishing_suffixes({"a/x.off", "b/x.off"}), ElementsAre("a/x", "b/x"));
  EXPECT_THAT(distinguishing_suffixes({"a/c/x.off", "b/c/x.off", "y.off"}), ElementsAre("a/c/x", "b/c/x", "y"));
  EXPECT_THAT(distinguishing_suffixes({"a/x.off", "a/x.off"}), ElementsAre("x", "x"));
}

TEST(NaturalOrder, ComparesNumbersByValue) {
  EXPECT_THAT(sorted({"T10", "T2", "T1", "T100", "T0"}), ElementsAre("T0", "T1", "T2", "T10", "T100"));
  EXPECT_THAT(sorted({"a10b2", "a10b10", "a9b99"}), ElementsAre("a9b99", "a10b2", "a10b10"));
}

TEST(NaturalOrder, ComparesNumbersLongerThanAnyInteger) {
  EXPECT_TRUE(natural_less("x99999999999999999999", "x100000000000000000000"));
}

TEST(NaturalOrder, SortsAPrefixBeforeLongerNames) {
  EXPECT_THAT(sorted({"T1.off", "T1", "T", ""}), ElementsAre("", "T", "T1", "T1.off"));
}

TEST(NaturalOrder, SortsEqualNumbersWithMoreLeadingZerosFirst) {
  EXPECT_THAT(sorted({"a1", "a01b", "a01", "a2", "a001"}), ElementsAre("a001", "a01", "a1", "a01b", "a2"));
  EXPECT_THAT(sorted({"0", "00", "1"}), ElementsAre("0", "00", "1"));
}

TEST(NaturalOrder, ComparesBytesAsUnsigned) { EXPECT_TRUE(natural_less("z", "\xC3\xA9")); }

RC_GTEST_PROP(NaturalOrder, IsAStrictTotalOrder, ()) {
  const auto names = rc::gen::container<std::string>(rc::gen::element('0', '1', '9', 'a', 'T', '.'));
  const std::string a = *names;
  const std::string b = *names;
  const std::string c = *names;
  RC_ASSERT(!natural_less(a, a));
  RC_ASSERT((a == b) == (!natural_less(a, b) && !natural_less(b, a)));
  RC_ASSERT(!(natural_less(a, b) && natural_less(b, a)));
  if (natural_less(a, b) && natural_less(b, c)) RC_ASSERT(natural_less(a, c));
}

RC_GTEST_PROP(NaturalOrder, SortsNumberedNamesByTheirNumber, (unsigned a, unsigned b)) {
  const auto name_of = [](unsigned number) { return std::string("T").append(std::to_string(number)).append(".off"); };
  RC_ASSERT(natural_less(name_of(a), name_of(b)) == (a < b));
}

TEST(ModelIds, OmitLetterPrefixAndExtensionOfNumberedFileNames) {
  EXPECT_EQ(canonical_model_id("12"), "12");
  EXPECT_EQ(canonical_model_id("T12"), "12");
  EXPECT_EQ(canonical_model_id("T12.off"), "12");
  EXPECT_EQ(canonical_model_id("12.OFF"), "12");
}

TEST(ModelIds, OmitTheExtensionOfNamesWithoutAModelNumber) {
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
