#include <atomic>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/distributed/agreement.h"
#include "shapegauge/experiments/distributed/communicator.h"
#include "tests/support/thread_ranks.h"

namespace shapegauge {

namespace {

TEST(OnAllRanks, TheErrorOfOneIsThatOfAll) {
  std::atomic<int> errors = 0;
  test::on_thread_ranks(3, [&](Communicator& ranks) {
    try {
      on_all_ranks(ranks, [&] {
        if (ranks.rank() > 0) throw ArgumentError("of rank " + std::to_string(ranks.rank()));
      });
    } catch (const SharedError& error) {
      EXPECT_STREQ(error.what(), "of rank 1") << "the lowest";
      ++errors;
    }
    EXPECT_EQ(on_first_rank(ranks, [&] { return std::to_string(ranks.rank()); }), "0");
  });
  EXPECT_EQ(errors, 3);
  EXPECT_THROW(on_all_ranks(*single_process(), [] { throw ArgumentError("as it is"); }), ArgumentError);
}

TEST(OnAllRanks, ReturnsTheOwnResultOfEachRank) {
  test::on_thread_ranks(3, [](Communicator& ranks) {
    EXPECT_EQ(on_all_ranks(ranks, [&] { return 10 * ranks.rank(); }), 10 * ranks.rank());
  });
  EXPECT_EQ(on_all_ranks(*single_process(), [] { return 7; }), 7);
}

TEST(OnFirstRank, IsRunOnceAndItsErrorIsThatOfAll) {
  std::atomic<int> runs = 0;
  std::atomic<int> errors = 0;
  test::on_thread_ranks(4, [&](Communicator& ranks) {
    const std::string bytes("a\0b", 3);
    EXPECT_EQ(on_first_rank(ranks,
                            [&] {
                              ++runs;
                              return bytes;
                            }),
              bytes);
    try {
      on_first_rank(ranks, []() -> std::string { throw std::runtime_error("on the first"); });
    } catch (const SharedError& error) {
      EXPECT_STREQ(error.what(), "on the first");
      ++errors;
    }
  });
  EXPECT_EQ(runs, 1);
  EXPECT_EQ(errors, 4);
}

TEST(AgreeOn, ThrowsOnAllRanksOrOnNone) {
  std::atomic<int> errors = 0;
  test::on_thread_ranks(3, [&](Communicator& ranks) {
    EXPECT_NO_THROW(agree_on("", ranks));
    try {
      agree_on(ranks.rank() == 2 ? "of the last" : "", ranks);
    } catch (const SharedError& error) {
      EXPECT_STREQ(error.what(), "of the last");
      ++errors;
    }
  });
  EXPECT_EQ(errors, 3);
}

}  // namespace

}  // namespace shapegauge
