#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/datasets/files/sha256.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

// FIPS 180-2, appendix B.1, and the digest of the empty message.
TEST(Sha256, PublishedDigests) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256, OfAFile) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(sha256_of_file(folder.file("x", "abc")), sha256("abc"));
  EXPECT_THROW(sha256_of_file(folder.path() / "absent"), InputError);
}

}  // namespace

}  // namespace shapegauge
