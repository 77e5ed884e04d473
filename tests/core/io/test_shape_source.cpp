// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/shape_source.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

class ReadNeighbour : public test::FolderTest {
 protected:
  ReadNeighbour() {
    test::write_text(at("set/shape.x"), "shape");
    test::write_text(at("set/parts/one.bin"), "one of the parts");
    test::write_text(at("outside.bin"), "not to be read");
  }

  [[nodiscard]] ShapeSource source() const { return read_shape_source(at("set/shape.x")); }
};

TEST_F(ReadNeighbour, FindsReferencedFilesInTheFolderOfTheShapeAndBelow) {
  EXPECT_EQ(source().bytes, "shape");
  EXPECT_EQ(source().read_neighbour("parts/one.bin"), "one of the parts");
  EXPECT_EQ(source().read_neighbour("./parts//one.bin"), "one of the parts");
  EXPECT_EQ(source().read_neighbour("shape.x"), "shape");
}

TEST_F(ReadNeighbour, FollowsSymbolicLinksToReferencedFiles) {
  std::filesystem::create_symlink("../../outside.bin", at("set/parts/link.bin"));
  EXPECT_EQ(source().read_neighbour("parts/link.bin"), "not to be read");
}

TEST_F(ReadNeighbour, FindsFilesReferencedByAShapeInTheWorkingFolder) {
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(at("set"));
  EXPECT_EQ(read_shape_source("shape.x").read_neighbour("parts/one.bin"), "one of the parts");
  std::filesystem::current_path(before);
}

TEST_F(ReadNeighbour, RejectsReferencedFilesOutsideTheFolderOfTheShape) {
  const std::string absolute = at("outside.bin").string();
  for (const std::string& file :
       {std::string("../outside.bin"), std::string("parts/../../outside.bin"), std::string("parts/.."), absolute,
        "file://" + absolute, std::string("https://x/y.bin"), std::string(""),
        std::string("parts/one.bin\0.jpg", 18)}) {
    EXPECT_THROW(static_cast<void>(source().neighbour(file)), InputError) << file;
    EXPECT_THROW(static_cast<void>(source().read_neighbour(file)), InputError) << file;
  }
}

TEST_F(ReadNeighbour, ErrorsNameTheShapeAndTheReferencedFile) {
  const auto names_both = AllOf(StartsWith(source().name + ": "), HasSubstr("two.bin"));
  EXPECT_THAT([&] { return source().read_neighbour("two.bin"); }, ThrowsMessage<InputError>(names_both));
  EXPECT_THAT([&] { return source().read_neighbour("../two.bin"); }, ThrowsMessage<InputError>(names_both));
}

TEST_F(ReadNeighbour, RejectsFilesReferencedByStandardInput) {
  const ShapeSource stream{.bytes = "shape", .name = "standard input"};
  EXPECT_THROW(static_cast<void>(stream.read_neighbour("CMakeCache.txt")), InputError);
  EXPECT_THROW(static_cast<void>(stream.neighbour("parts/one.bin")), InputError);
}

TEST_F(ReadNeighbour, RefusesReferencesToFoldersAndEmptyFiles) {
  test::write_text(at("set/empty.bin"), "");
  EXPECT_THROW(static_cast<void>(source().read_neighbour("parts")), InputError);
  EXPECT_THROW(static_cast<void>(source().read_neighbour("empty.bin")), InputError);
}

}  // namespace

}  // namespace shapegauge
