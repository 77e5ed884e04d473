#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <set>
#include <stdexcept>
#include <string>

#include "shapegauge/experiments/matrices/csv_matrix.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/experiments/input_error.h"
#include "tests/experiments/matrices/random_matrices.h"

namespace shapegauge {
namespace {

using test_io::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

LabelledDistances read(const std::string& text) {
  const TemporaryFolder folder;
  return read_csv_matrix(folder.file("m.csv", text));
}

std::string error_of(const std::string& text) {
  return input_error_of([&] { read(text); });
}

DistanceMatrix example() {
  DistanceMatrix matrix(2, 2);
  matrix << 0, 1.5, -2.25, std::numeric_limits<double>::infinity();
  return matrix;
}

TEST(CsvMatrix, TakesIdsFromTheHeaderRowAndTheFirstColumn) {
  for (const char* const text :
       {"id,T1,T2\nT1,0,1.5\nT2,-2.25,inf\n", ",T1,T2\r\n\"T1\", 0 ,1.50\r\n\r\nT2,-2.25,inf"}) {
    const LabelledDistances result = read(text);
    EXPECT_EQ(result.distances, example());
    EXPECT_THAT(result.ids, ElementsAre("T1", "T2"));
  }
}

TEST(CsvMatrix, IdsMayBeNumbers) { EXPECT_THAT(read("id,7,5\n7,0,1\n5,1,0\n").ids, ElementsAre("7", "5")); }

TEST(CsvMatrix, WithoutHeaderThereAreNoIds) {
  const LabelledDistances result = read("0,1.5\n-2.25,inf\n");
  EXPECT_EQ(result.distances, example());
  EXPECT_THAT(result.ids, IsEmpty());
}

TEST(CsvMatrix, AFaultIsOneErrorWithItsLine) {
  EXPECT_THAT(error_of("id,a,b\na,0,x\nb,1,0\n"), HasSubstr("m.csv:2: \"x\" is not a number (number 2 of the row)"));
  EXPECT_THAT(error_of("id,a,b\na,0,\nb,1,0\n"), HasSubstr("m.csv:2: \"\" is not a number"));
  EXPECT_THAT(error_of("id,a,b\nb,0,1\na,1,0\n"), HasSubstr("m.csv:2: the row is of \"b\", but the column"));
  EXPECT_THAT(error_of("id,a,a\na,0,1\na,1,0\n"), HasSubstr("m.csv:1: the id \"a\" occurs twice"));
  EXPECT_THAT(error_of("id,a,\na,0,1\n,1,0\n"), HasSubstr("m.csv:1: an id is empty"));
  EXPECT_THAT(error_of("id,a,b\na,0,1\nb,1\n"), HasSubstr("m.csv:3: the row has 1 numbers, but the one in line 2"));
  EXPECT_THAT(error_of("id,a,b\na,0,1\nb,1,0\nc,1,1\n"), HasSubstr("m.csv:4: there are more rows than the 2 ids"));
  EXPECT_THAT(error_of("id,a,b\na,0,1\n"),
              HasSubstr("m.csv: a distance matrix is square, but the file has 1 rows of 2"));
  EXPECT_THAT(error_of("id,a,b\na,0\n"), HasSubstr("m.csv: the header row has 2 ids, but there are 1 rows of 1"));
  EXPECT_THAT(error_of("id,a\na\n"), HasSubstr("m.csv:2: the row has no numbers"));
  EXPECT_THAT(error_of("id\n"), HasSubstr("m.csv: the file has no numbers"));
  EXPECT_THAT(error_of("\n"), HasSubstr("m.csv: the file has no numbers"));
  EXPECT_THAT(error_of("0,1\n1,\"0\n"), HasSubstr("m.csv:2: "));
  EXPECT_THAT(error_of(""), HasSubstr("empty"));
}

TEST(CsvMatrix, EveryPrefixReadsOrIsAnInputError) {
  const std::string valid = "id,a,\"b,c\"\na,0,1.5\n\"b,c\",1.5,0\n";
  for (std::size_t length = 0; length + 1 < valid.size(); ++length) {
    EXPECT_THAT(error_of(valid.substr(0, length)), HasSubstr("m.csv")) << length;
  }
  EXPECT_EQ(error_of(valid.substr(0, valid.size() - 1)), "no error");
}

TEST(CsvMatrix, WritesIdsWhereThereAreSome) {
  const TemporaryFolder folder;
  write_csv_matrix(folder.path() / "m.csv", {example(), {"T1", "a,\"b\""}});
  EXPECT_EQ(test_io::bytes_of(folder.path() / "m.csv"), "id,T1,\"a,\"\"b\"\"\"\nT1,0,1.5\n\"a,\"\"b\"\"\",-2.25,inf\n");
  write_csv_matrix(folder.path() / "n.csv", {example(), {}});
  EXPECT_EQ(test_io::bytes_of(folder.path() / "n.csv"), "0,1.5\n-2.25,inf\n");
}

TEST(CsvMatrix, RefusesToWriteWhatDoesNotReadBack) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "m.csv";
  EXPECT_THROW(write_csv_matrix(path, {example(), {"a"}}), std::invalid_argument);
  EXPECT_THAT(input_error_of([&] { write_csv_matrix(path, {example(), {"a", "b\nc"}}); }), HasSubstr("line break"));
  EXPECT_THAT(input_error_of([&] { write_csv_matrix(path, {example(), {"a", ""}}); }), HasSubstr("empty"));
  EXPECT_THAT(input_error_of([&] { write_csv_matrix(path, {example(), {"a", "a"}}); }), HasSubstr("twice"));
  EXPECT_EQ(folder.size(), 0U);
}

RC_GTEST_PROP(CsvMatrix, ReadsBackWhatIsWritten, ()) {
  const TemporaryFolder folder;
  LabelledDistances written;
  written.distances = *square_matrices() / 3;
  const auto id = rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::element('1', 'T', ',', '"', ' ', '\t')));
  std::set<std::string> ids;
  while (static_cast<Eigen::Index>(ids.size()) < written.distances.rows()) ids.insert(*id + std::to_string(ids.size()));
  written.ids.assign(ids.begin(), ids.end());
  write_csv_matrix(folder.path() / "m.csv", written);
  const LabelledDistances result = read_csv_matrix(folder.path() / "m.csv");
  RC_ASSERT(result.distances == written.distances);
  RC_ASSERT(result.ids == written.ids);
}

}  // namespace
}  // namespace shapegauge
