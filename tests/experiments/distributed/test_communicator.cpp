#include <Eigen/Core>
#include <atomic>
#include <gmock/gmock.h>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "shapegauge/experiments/distributed/communicator.h"
#include "shapegauge/experiments/distributed/packing.h"
#include "tests/support/test_files.h"
#include "tests/support/thread_ranks.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(PartOfRank, PartsFollowEachOtherAndAreAboutAsLarge) {
  for (const std::size_t count : {0, 1, 7, 100}) {
    for (const int size : {1, 2, 3, 8}) {
      std::size_t before = 0;
      for (int rank = 0; rank < size; ++rank) {
        const RankRange part = part_of_rank(count, rank, size);
        EXPECT_EQ(part.first, before);
        EXPECT_LE(part.size(), count / static_cast<std::size_t>(size) + 1);
        EXPECT_GE(part.size(), count / static_cast<std::size_t>(size));
        before = part.last;
      }
      EXPECT_EQ(before, count);
    }
  }
}

TEST(Packing, WhatIsPackedComesOutAgain) {
  const Eigen::MatrixXf matrix{{1, 2, 3}, {4, 5, 6}};
  const std::vector<int> numbers = {7, 8};
  const std::string bytes =
      std::move(Packer().add(3.5).add("text").add(numbers).add(std::string()).add(matrix).add('x')).bytes();
  Unpacker unpacker(bytes);
  EXPECT_EQ(unpacker.take_value<double>(), 3.5);
  EXPECT_EQ(unpacker.take_value<std::string>(), "text");
  EXPECT_EQ(unpacker.take_value<std::vector<int>>(), numbers);
  EXPECT_EQ(unpacker.take_value<std::string>(), "");
  EXPECT_EQ(unpacker.take_value<Eigen::MatrixXf>(), matrix);
  EXPECT_FALSE(unpacker.is_at_end());
  EXPECT_EQ(unpacker.take_value<char>(), 'x');
  EXPECT_TRUE(unpacker.is_at_end());
}

TEST(SingleProcess, HasAllForItself) {
  const auto alone = single_process();
  EXPECT_EQ(alone->rank(), 0);
  EXPECT_EQ(alone->size(), 1);
  EXPECT_THAT(alone->gather("a"), ElementsAre("a"));
  EXPECT_EQ(alone->broadcast("b"), "b");
  EXPECT_THAT(alone->exchange({"c"}), ElementsAre("c"));
  std::vector<std::size_t> jobs;
  alone->share_jobs(3, [&](Jobs& shared) {
    while (const auto job = shared.next()) {
      jobs.push_back(*job);
      if (*job == 1) shared.stop();
    }
  });
  EXPECT_THAT(jobs, ElementsAre(0, 1)) << "in order, and none once they are stopped";
}

TEST(SingleProcess, AFileIsWrittenInAnyOrder) {
  const test::TemporaryFolder folder;
  const auto file = single_process()->create_file(folder.path() / "file", 6);
  file->write(3, "def");
  file->write(0, "abc");
  file->close();
  EXPECT_EQ(test::text_of(folder.path() / "file"), "abcdef");
  EXPECT_THAT(test::input_error_of([&] { single_process()->create_file(folder.path() / "none" / "file", 6); }),
              HasSubstr("cannot write"));
}

}  // namespace

}  // namespace shapegauge
