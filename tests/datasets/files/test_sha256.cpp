// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/datasets/files/sha256.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

// FIPS 180-2, appendix B.1, and the digest of the empty message.
TEST(Sha256, MatchesPublishedDigests) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256, OfAFileEqualsTheDigestOfItsContents) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(sha256_of_file(folder.file("x", "abc")), sha256("abc"));
  EXPECT_THROW(sha256_of_file(folder.path() / "absent"), InputError);
  EXPECT_EQ(sha256_of_file_if_readable(folder.path() / "x"), sha256("abc"));
  EXPECT_EQ(sha256_of_file_if_readable(folder.path() / "absent"), "");
}

/// Format whose lines name files with one vertex each.
ShapeFormat format_of_parts() {
  static constexpr std::array<std::string_view, 1> extensions{".parts"};
  constexpr auto neighbours = [](const ShapeSource& source) {
    std::vector<std::string> names;
    for (const std::string_view line : split_lines(source.bytes)) names.emplace_back(line);
    return names;
  };
  return {.name = "parts",
          .description = "Names of files",
          .extensions = extensions,
          .check_header = [](const std::string& /*bytes*/, const std::string& /*name*/) {},
          .read = [](const ShapeSource& /*source*/) { return Shape{}; },
          .neighbours = neighbours};
}

TEST(Sha256, OfAShapeChangesWithAnyOfItsFiles) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(sha256_of_shape(read_shape_source(folder.file("x.off", "abc"))), sha256("abc"));

  shape_formats().add(format_of_parts());
  test::write_text(folder.path() / "a", "1");
  test::write_text(folder.path() / "b", "2");
  const ShapeSource shape = read_shape_source(folder.file("x.parts", "a\nb\n"));
  const std::string hash = sha256_of_shape(shape);
  EXPECT_NE(hash, sha256(shape.bytes));
  EXPECT_EQ(hash, sha256_of_shape(shape));
  test::write_text(folder.path() / "b", "3");
  EXPECT_NE(hash, sha256_of_shape(shape));
  EXPECT_NE(hash, sha256_of_shape(read_shape_source(folder.file("x.parts", "b\na\n"))));
  EXPECT_EQ(sha256_if_readable(folder.path() / "x.off"), sha256("abc"));
  EXPECT_EQ(sha256_if_readable(folder.path() / "absent.off"), "");
  EXPECT_NO_THROW(sha256_of_shape(read_shape_source(folder.file("x.parts", "a\n../b\nabsent\n"))));
}

}  // namespace

}  // namespace shapegauge
