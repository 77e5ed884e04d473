// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <cstdlib>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sys/mount.h>
#include <sys/wait.h>
#include <utility>

#include "shapegauge/experiments/cache/cache_folder.h"
#include "tests/app/program.h"
#include "tests/support/small_dataset.h"
#include "tests/support/test_files.h"

namespace shapegauge::test_command_line {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::results_in;
using test::text_of;
using test::write_text;
using testing::HasSubstr;
using testing::MatchesRegex;

/// Runs over the small data set, on one thread.
class RunWithCache : public SmallRun {
 protected:
  /// More rays take longer.
  void write_configuration(int rays) const {
    json configuration = test::small_configuration("data");
    for (json& signature : configuration["signatures"]) {
      if (signature.contains("field")) signature["field"]["rays"] = rays;
    }
    write_text(at("small.json"), configuration.dump());
  }
  [[nodiscard]] std::vector<std::string> arguments(const std::string& output) const {
    return {"run",     at("small.json").string(), "--output", at(output).string(), "--threads", "1",
            "--cache", at("cache").string()};
  }
  [[nodiscard]] Outcome run(const std::string& output, const std::string& more = "") const {
    return run_executable("run " + quoted("small.json") + " --output " + quoted(output) + " --threads 1 " + more);
  }
  [[nodiscard]] Outcome run_with_cache(const std::string& output) const {
    return run(output, "--cache " + quoted("cache"));
  }
  [[nodiscard]] std::size_t cached_fields() const {
    return cache_contents(at("cache")).by_kind.at(static_cast<std::size_t>(EntryKind::field)).entries;
  }
  [[nodiscard]] json cache_use(const std::string& output) const {
    return json::parse(text_of(at(output) / "manifest.json"))["execution"]["cache"];
  }
};

TEST_F(RunWithCache, ReportsHowManyResultsCameFromTheCache) {
  const Outcome cold = run_with_cache("out");
  EXPECT_EQ(cold.errors, "");
  EXPECT_THAT(cold.output, testing::Not(HasSubstr("From the cache")));
  const auto fresh = results_in(at("out"));
  const Outcome warm = run_with_cache("out");
  EXPECT_EQ(warm.errors, "");
  EXPECT_THAT(warm.output, HasSubstr("From the cache: 9 of 9 shapes, 9 of 9 fields, 4 of 4 distance "
                                     "matrices\nResults in "));
  EXPECT_EQ(results_in(at("out")), fresh);
  EXPECT_EQ(cache_use("out")["field"], (json{{"from_cache", 9}, {"computed", 0}}));
  ASSERT_EQ(run("fresh", "--no-cache").status, 0);
  EXPECT_EQ(cache_use("fresh"), nullptr);
  EXPECT_EQ(results_in(at("fresh")), fresh);
  EXPECT_THAT(run("out", "--force --cache " + quoted("cache")).output, testing::Not(HasSubstr("From the cache")));
  EXPECT_EQ(cache_use("out")["field"], (json{{"from_cache", 0}, {"computed", 9}}));
}

TEST_F(RunWithCache, ReusesAllCachedShapesAfterBeingKilled) {
  write_configuration(2000);
  std::size_t cached = 0;
  {
    BackgroundRun killed(arguments("out"), at("errors"));
    ASSERT_TRUE(killed.wait_until([&] { return cached_fields() >= 3; })) << text_of(at("errors"));
    killed.send(SIGKILL);
    ASSERT_EQ(killed.wait(), -SIGKILL);
    cached = cached_fields();
    ASSERT_LT(cached, 9U) << "killed too late to say anything";
  }
  EXPECT_FALSE(fs::exists(at("out/manifest.json")));
  const Outcome outcome = run_with_cache("out");
  EXPECT_EQ(outcome.status, 0) << "the killed run's lock is gone with it";
  EXPECT_EQ(outcome.errors, "");
  EXPECT_EQ(cache_use("out")["field"], (json{{"from_cache", cached}, {"computed", 9 - cached}}));
  ASSERT_EQ(run("fresh", "--no-cache").status, 0);
  EXPECT_EQ(results_in(at("out")), results_in(at("fresh")));
}

TEST_F(RunWithCache, LeavesNoInvalidFilesWhenKilled) {
  write_configuration(2000);
  for (std::size_t fields = 1; fields < 9; fields += 2) {
    BackgroundRun killed(arguments("out"), at("errors"));
    killed.wait_until([&] { return cached_fields() >= fields; });
    killed.send(SIGKILL);
    killed.wait();
  }
  EXPECT_EQ(run_with_cache("out").errors, "");
  ASSERT_EQ(run("fresh", "--no-cache").status, 0);
  EXPECT_EQ(results_in(at("out")), results_in(at("fresh")));
}

TEST_F(RunWithCache, ContinuesFromTheCacheAfterAnInterruption) {
  write_configuration(2000);
  std::size_t cached = 0;
  for (const auto& [signal, status] : {std::pair{SIGINT, 130}, {SIGTERM, 143}, {SIGHUP, 129}}) {
    BackgroundRun terminated(arguments("out"), at("errors"));
    ASSERT_TRUE(terminated.wait_until([&] { return cached_fields() >= cached + 1; })) << text_of(at("errors"));
    terminated.send(signal);
    EXPECT_EQ(terminated.wait(), status);
    EXPECT_THAT(text_of(at("errors")),
                MatchesRegex("shapegauge: error: interrupted; no results were written[^\n]* in the cache[^\n]*\n"));
    EXPECT_TRUE(fs::is_empty(at("out"))) << "the lock is gone too";
    cached = cached_fields();
  }
  ASSERT_EQ(run_with_cache("out").status, 0);
  EXPECT_EQ(cache_use("out")["field"]["from_cache"], cached);
}

TEST_F(RunWithCache, RejectsASecondRunIntoTheSameFolder) {
  write_configuration(1000);
  BackgroundRun first(arguments("out"), at("errors"));
  ASSERT_TRUE(first.wait_until([&] { return cached_fields() >= 1; })) << text_of(at("errors"));
  first.send(SIGSTOP);
  const Outcome second = run("out", "--force --no-cache");
  first.send(SIGCONT);
  EXPECT_EQ(second.status, 2);
  EXPECT_THAT(second.errors, MatchesRegex("shapegauge: error: another run is writing to [^\n]*--output\n"));
  EXPECT_EQ(first.wait(), 0) << "and does the first no harm";
  EXPECT_EQ(text_of(at("errors")), "");
}

TEST_F(RunWithCache, TwoRunsCanShareOneCache) {
  BackgroundRun first(arguments("out"), at("errors"));
  const Outcome second = run_with_cache("out2");
  EXPECT_EQ(first.wait(), 0);
  EXPECT_EQ(second.status, 0);
  EXPECT_EQ(second.errors + text_of(at("errors")), "");
  EXPECT_EQ(results_in(at("out")), results_in(at("out2")));
  EXPECT_EQ(cached_fields(), 9U);
}

TEST_F(RunWithCache, RecomputesDamagedEntriesWithOneWarning) {
  ASSERT_EQ(run_with_cache("out").status, 0);
  const auto fresh = results_in(at("out"));
  for (const CacheFile& file : cache_files(at("cache"))) {
    if (file.kind == EntryKind::field) write_text(file.path, text_of(file.path).substr(0, 100));
  }
  const Outcome outcome = succeeded(run_with_cache("out"));
  EXPECT_THAT(outcome.errors, MatchesRegex("shapegauge: warning: damaged cache entry, recomputed: [^\n]* and 8 "
                                           "others\n"));
  EXPECT_EQ(results_in(at("out")), fresh);
}

/// File system of limited size; mounted() is false without root's rights.
class SmallDisk {
 public:
  SmallDisk(fs::path folder, const std::string& size) : folder_(std::move(folder)) {
    fs::create_directories(folder_);
    mounted_ = ::mount("tmpfs", folder_.c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0;
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  SmallDisk(SmallDisk&&) = delete;
  SmallDisk& operator=(SmallDisk&&) = delete;
  ~SmallDisk() {
    if (mounted_) ::umount2(folder_.c_str(), MNT_DETACH);
  }
  [[nodiscard]] bool mounted() const { return mounted_; }

 private:
  fs::path folder_;
  bool mounted_ = false;
};

TEST_F(RunWithCache, ContinuesWithAWarningIfTheCacheDiskIsFull) {
  const SmallDisk disk(at("cache"), "64k");
  if (!disk.mounted()) GTEST_SKIP() << "only root may mount a small disk";
  const Outcome outcome = succeeded(run_with_cache("out"));
  EXPECT_THAT(outcome.errors, MatchesRegex("shapegauge: warning: cache disabled for writing: [^\n]*No space "
                                           "left on device[^\n]*\n"));
  ASSERT_EQ(run("fresh", "--no-cache").status, 0);
  EXPECT_EQ(results_in(at("out")), results_in(at("fresh")));
}

TEST_F(RunWithCache, KeepsEarlierResultsIfTheDiskIsFull) {
  const SmallDisk disk(at("out"), "2m");
  if (!disk.mounted()) GTEST_SKIP() << "only root may mount a small disk";
  ASSERT_EQ(run_with_cache("out").status, 0) << "one set of results fits";
  const auto earlier = results_in(at("out"));
  const Outcome outcome = run_with_cache("out");
  EXPECT_EQ(outcome.status, 2) << "two sets do not";
  EXPECT_THAT(outcome.errors, MatchesRegex("shapegauge: error: cannot write [^\n]*No space left on device\n"));
  EXPECT_EQ(results_in(at("out")), earlier);
}

TEST_F(RunWithCache, KeepsEarlierResultsAtAFileSizeLimit) {
  ASSERT_EQ(run_with_cache("out").status, 0);
  const auto earlier = results_in(at("out"));
  // The shell's unit is 512 bytes; the manifest has more than four of them.
  const std::string command = "ulimit -f 4; " + executable_for_shell() + " run " + quoted("small.json") + " --output " +
                              quoted("out") + " --cache " + quoted("cache") + " >/dev/null 2>" + quoted("errors");
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 2);
  EXPECT_THAT(text_of(at("errors")), MatchesRegex("shapegauge: error: cannot write [^\n]*File too large\n"));
  EXPECT_EQ(results_in(at("out")), earlier);
}

}  // namespace
}  // namespace shapegauge::test_command_line
