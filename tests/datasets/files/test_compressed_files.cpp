// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <archive.h>
#include <archive_entry.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/datasets/files/compressed_files.h"
#include "shapegauge/datasets/files/matrix_files.h"
#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/datasets/files/ranked_answers.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using test::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

using Entries = std::vector<std::pair<std::string, std::string>>;  // names and contents

// Bytes of an archive of the entries, with a format and a filter of libarchive. Each entry goes on with `zeros` zeros.
std::string packed(const Entries& entries, int (*format)(archive*), int (*filter)(archive*), std::size_t zeros = 0) {
  std::string bytes(1 << 20, '\0');
  std::size_t used = 0;
  archive* const opened = archive_write_new();
  format(opened);
  filter(opened);
  archive_write_set_bytes_in_last_block(opened, 1);
  archive_write_open_memory(opened, bytes.data(), bytes.size(), &used);
  const std::string block(1 << 20, '\0');
  for (const auto& [name, content] : entries) {
    archive_entry* const entry = archive_entry_new();
    archive_entry_set_pathname(entry, name.c_str());
    archive_entry_set_size(entry, static_cast<la_int64_t>(content.size() + zeros));
    archive_entry_set_filetype(entry, AE_IFREG);
    archive_write_header(opened, entry);
    archive_write_data(opened, content.data(), content.size());
    for (std::size_t rest = zeros; rest > 0; rest -= std::min(rest, block.size())) {
      archive_write_data(opened, block.data(), std::min(rest, block.size()));
    }
    archive_entry_free(entry);
  }
  archive_write_free(opened);
  return bytes.substr(0, used);
}

std::string gzipped(const std::string& text) {
  return packed({{"x", text}}, archive_write_set_format_raw, archive_write_add_filter_gzip);
}

std::string zipped(const Entries& entries, std::size_t zeros = 0) {
  return packed(entries, archive_write_set_format_zip, archive_write_add_filter_none, zeros);
}

DistanceMatrix small_matrix() { return DistanceMatrix{{0, 1.5}, {2.5, 0}}; }

std::string npy_of(const DistanceMatrix& matrix) {
  const TemporaryFolder folder;
  write_npy(folder.path() / "m.npy", matrix);
  return test::bytes_of(folder.path() / "m.npy");
}

using CompressedFiles = test::FolderTest;

TEST_F(CompressedFiles, AreReadLikeUncompressedFiles) {
  EXPECT_EQ(read_plain_bytes(folder_.file("a.txt.gz", gzipped("some text"))), "some text");
  EXPECT_EQ(read_plain_bytes(folder_.file("a.txt", "some text")), "some text");
  EXPECT_EQ(format_extension("a.CSV.gz"), ".csv");
  EXPECT_EQ(format_extension("a.Npy"), ".npy");
  EXPECT_EQ(format_extension("a.gz"), "");
}

TEST_F(CompressedFiles, AreRejectedIfDamaged) {
  const std::string whole = gzipped(std::string(5000, 'x') + "end");
  const auto error = [&](const std::string& bytes) {
    return test::input_error_of([&] { read_plain_bytes(folder_.file("a.csv.gz", bytes)); });
  };
  EXPECT_THAT(error("no gzip at all"), AllOf(HasSubstr("a.csv.gz"), HasSubstr("not a gzip file")));
  EXPECT_THAT(error(whole.substr(0, whole.size() / 2)), HasSubstr("a.csv.gz"));
}

TEST_F(CompressedFiles, AreRejectedIfChecksumOrSizeIsWrong) {
  const auto error = [&](const std::string& bytes) {
    return test::input_error_of([&] { read_plain_bytes(folder_.file("a.txt.gz", bytes)); });
  };
  const auto flipped = [](std::string bytes, std::size_t from_end) {
    bytes[bytes.size() - from_end] ^= 1;
    return bytes;
  };
  const std::string whole = gzipped("some text");
  EXPECT_THAT(error(flipped(whole, 8)), HasSubstr("a.txt.gz: not a gzip file, or damaged: incorrect data check"));
  EXPECT_THAT(error(flipped(whole, 4)), HasSubstr("a.txt.gz: not a gzip file, or damaged: incorrect length check"));
  for (std::size_t size = 1; size < whole.size(); ++size) {
    EXPECT_THAT(error(whole.substr(0, size)), HasSubstr("it ends too early")) << size;
    EXPECT_THAT(error(whole + whole.substr(0, size)), HasSubstr("it ends too early")) << size;
  }
  for (const std::string& garbage : {std::string("garbage"), std::string(512, '\0'), std::string("\n"),
                                     std::string(1, '\0'), std::string("\x1f\n")}) {
    EXPECT_THAT(error(whole + garbage), HasSubstr("other bytes follow its end"));
  }
  EXPECT_EQ(read_plain_bytes(folder_.file("a.txt.gz", whole + gzipped(" and more"))), "some text and more");
}

TEST_F(CompressedFiles, HaveAnUnpackingLimitThatGrowsWithTheirSize) {
  constexpr std::size_t mebibyte = std::size_t{1} << 20;
  EXPECT_EQ(max_unpacked_bytes(1), 256 * mebibyte);
  EXPECT_EQ(max_unpacked_bytes(100 * mebibyte), 5000 * mebibyte);
  EXPECT_EQ(max_unpacked_bytes(mebibyte * mebibyte), 16384 * mebibyte);
}

TEST_F(CompressedFiles, AreRejectedIfTheirUnpackedSizeIsExcessive) {
  const std::string zeros(std::size_t{4} << 20, '\0');
  std::string bomb;  // a gzip file may consist of several members
  for (const std::string member = gzipped(zeros); bomb.size() < 65 * member.size();) bomb += member;
  EXPECT_THAT(test::input_error_of([&] { read_matrix(folder_.file("a.npy.gz", bomb), TableShape::any); }),
              AllOf(HasSubstr("a.npy.gz"), HasSubstr("256 MiB")));
  const std::string archive = zipped({{"D.npy", npy_of(small_matrix())}}, std::size_t{256} << 20);
  EXPECT_THAT(test::input_error_of([&] { extract_npz_array(archive, "a.npz"); }),
              AllOf(HasSubstr("a.npz"), HasSubstr("256 MiB")));
}

TEST_F(CompressedFiles, AreReadAsDistanceMatricesAndTrecRuns) {
  EXPECT_EQ(read_matrix(folder_.file("m.txt.gz", gzipped("0 1.5\n2.5 0\n")), TableShape::square).numbers,
            small_matrix());
  EXPECT_EQ(read_matrix(folder_.file("m.npy.gz", gzipped(npy_of(small_matrix()))), TableShape::square).numbers,
            small_matrix());
  const LabelledTable table =
      read_matrix(folder_.file("m.csv.gz", gzipped("id,a,b\na,0,1.5\nb,2.5,0\n")), TableShape::square);
  EXPECT_EQ(table.numbers, small_matrix());
  EXPECT_THAT(table.row_ids, ElementsAre("a", "b"));
  const auto run = folder_.file("r.txt.gz", gzipped("q Q0 a 1 2 mine\n"));
  EXPECT_TRUE(is_ranked_answers_file(run));
  EXPECT_EQ(read_ranked_answers(run).name, "mine");
}

TEST(NpzFile, WithASingleArrayIsReadAsAMatrix) {
  const TemporaryFolder folder;
  const auto path = folder.file("m.npz", zipped({{"readme.txt", "hello"}, {"distances.npy", npy_of(small_matrix())}}));
  EXPECT_EQ(read_matrix(path, TableShape::square).numbers, small_matrix());
  EXPECT_EQ(read_matrix(path, TableShape::any).numbers, small_matrix());
}

TEST(NpzFile, WithSeveralArraysNeedsTheNameOfAnArray) {
  const std::string array = npy_of(small_matrix());
  const auto error = [](const std::string& bytes) {
    return test::input_error_of([&] { extract_npz_array(bytes, "m.npz"); });
  };
  EXPECT_THAT(error(zipped({{"a.npy", array}, {"b.npy", array}})), HasSubstr("m.npz: the archive has 2 arrays (a, b)"));
  EXPECT_EQ(extract_npz_array(zipped({{"a.npy", array}, {"b.npy", "other"}}), "m.npz", "b"), "other");
  EXPECT_THAT(test::input_error_of([&] {
                extract_npz_array(zipped({{"a.npy", array}}), "m.npz", "c");
              }),
              HasSubstr("no array \"c\""));
  EXPECT_THAT(error(zipped({{"readme.txt", "hello"}})), HasSubstr("m.npz: the archive has no array"));
  EXPECT_THAT(error("PK nothing"), HasSubstr("m.npz"));
  EXPECT_THAT(error(zipped({{"a.npy", array}}).substr(0, 60)), HasSubstr("m.npz"));
}

}  // namespace

}  // namespace shapegauge
