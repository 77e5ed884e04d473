#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <sys/wait.h>
#include <vector>

#include "shapegauge/experiments/cache/cache_folder.h"
#include "tests/app/program.h"
#include "tests/support/small_dataset.h"
#include "tests/support/test_files.h"

namespace shapegauge {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::text_of;
using test::write_text;
using test_command_line::BackgroundRun;
using test_command_line::Outcome;
using test_command_line::results_in;
using test_command_line::run_executable;
using test_command_line::SmallRun;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* mpirun = "/usr/bin/mpirun";

/// Reason for skipping runs of several processes; empty if they are possible.
std::string missing() {
  if (!fs::exists(mpirun)) return std::string("there is no ") + mpirun;
  const fs::path module = fs::path(SHAPEGAUGE_EXECUTABLE).parent_path() / "shapegauge_mpi.so";
  return fs::exists(module) ? "" : "built without SHAPEGAUGE_MPI";
}

/// Runs of several processes.
class RunProcesses : public SmallRun {
 protected:
  void SetUp() override {
    SmallRun::SetUp();
    // Required to start MPI programs as root, as in containers.
    ::setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    ::setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    // Open MPI leaks some memory, which the address sanitizer would report.
    ::setenv("ASAN_OPTIONS", "detect_leaks=0", 1);
    json configuration = test::small_configuration("data");
    configuration["signatures"].push_back(
        {{"name", "bag"},
         {"descriptor",
          {{"type", "bag_of_features"}, {"words", 5}, {"fields", {configuration["signatures"][0]["field"]}}}}});
    configuration["signatures"].push_back({{"name", "sum"}, {"sum", {{{"of", "fixed"}}, {{"of", "bag"}}}}});
    write_text(at("small.json"), configuration.dump());
  }

  [[nodiscard]] std::vector<std::string> arguments(int ranks, const std::string& output) const {
    return {"--oversubscribe",
            "-n",
            std::to_string(ranks),
            SHAPEGAUGE_EXECUTABLE,
            "run",
            at("small.json").string(),
            "--output",
            at(output).string(),
            "--cache",
            at("cache").string()};
  }
  /// Errors include those of mpirun.
  [[nodiscard]] Outcome run_ranks(int ranks, const std::string& output, const std::string& more = "") const {
    std::string command = mpirun;
    for (const std::string& argument : arguments(ranks, output)) command += " '" + argument + "'";
    command += " " + more + " </dev/null >" + quoted("output") + " 2>" + quoted("errors");
    const int status = std::system(command.c_str());
    return {.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
            .output = text_of(at("output")),
            .errors = text_of(at("errors"))};
  }
  [[nodiscard]] std::map<std::string, std::string> results_of_one() const {
    EXPECT_EQ(run_executable("run " + quoted("small.json") + " --no-cache --output " + quoted("alone")).status, 0);
    return results_in(at("alone"));
  }
  /// Makes the run long enough to be interrupted.
  void take_long() const {
    json configuration = json::parse(text_of(at("small.json")));
    for (json& signature : configuration["signatures"]) {
      if (signature.contains("field")) signature["field"]["rays"] = 3000;
    }
    write_text(at("small.json"), configuration.dump());
  }
  [[nodiscard]] std::size_t fields_kept() const {
    return cache_contents(at("cache")).by_kind.at(static_cast<std::size_t>(EntryKind::field)).entries;
  }
};

TEST_F(RunProcesses, AnyNumberOfProcessesGivesTheSameBytes) {
  if (!missing().empty()) GTEST_SKIP() << missing();
  const auto expected = results_of_one();
  ASSERT_TRUE(expected.contains("distances/sum.npy") && expected.contains("features/bag.npy"));
  for (const int ranks : {1, 2, 3, 4}) {
    SCOPED_TRACE(ranks);
    const std::string output = "out" + std::to_string(ranks);
    const Outcome outcome = run_ranks(ranks, output, ranks < 4 ? "--force" : "");
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(outcome.errors, "");
    EXPECT_EQ(std::ranges::count(outcome.output, '\n'), ranks < 4 ? 28 : 29) << "said once\n" << outcome.output;
    EXPECT_EQ(results_in(at(output)), expected);
    const json manifest = json::parse(text_of(at(output) / "manifest.json"));
    EXPECT_EQ(manifest["execution"].value("processes", 1), ranks);
    const json fields = manifest["execution"]["cache"]["field"];
    EXPECT_EQ(fields["computed"].get<int>() + fields["from_cache"].get<int>(), 9) << "each shape once";
  }
}

TEST_F(RunProcesses, SeveralDataSetsGiveTheSameBytes) {
  if (!missing().empty()) GTEST_SKIP() << missing();
  test::write_small_dataset(at("second"));
  write_text(at("second/test.cla"), "PSB 1\n2 5\n\nsphere 0 3\n0\n3\n6\n\nbox 0 2\n1\n4\n");
  json configuration = json::parse(text_of(at("small.json")));
  json second = configuration["dataset"];
  second["root"] = "second";
  configuration["datasets"] = {configuration["dataset"], second};
  configuration["datasets"][0]["name"] = "first";
  configuration["datasets"][1]["name"] = "second";
  configuration.erase("dataset");
  write_text(at("small.json"), configuration.dump());
  const auto expected = results_of_one();
  ASSERT_TRUE(expected.contains("first/distances/sum.npy") && expected.contains("second/features/bag.npy"));
  for (const int ranks : {2, 3}) {
    SCOPED_TRACE(ranks);
    const std::string output = "out" + std::to_string(ranks);
    const Outcome outcome = run_ranks(ranks, output);
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(outcome.errors, "");
    EXPECT_EQ(results_in(at(output)), expected);
    const json manifest = json::parse(text_of(at(output) / "second/manifest.json"));
    EXPECT_EQ(manifest["execution"].value("processes", 1), ranks);
  }
}

TEST_F(RunProcesses, MatricesThatNobodyWantsAreNotWritten) {
  if (!missing().empty()) GTEST_SKIP() << missing();
  ASSERT_EQ(run_ranks(2, "out", "--set keep_distances=false").status, 0);
  EXPECT_FALSE(fs::exists(at("out/distances")));
  auto expected = results_of_one();
  EXPECT_EQ(text_of(at("out/per_query.csv")), expected["per_query.csv"]);
  EXPECT_EQ(text_of(at("out/report.html")), expected["report.html"]);
}

TEST_F(RunProcesses, AModelThatFailsIsSaidOnce) {
  if (!missing().empty()) GTEST_SKIP() << missing();
  write_text(at("data/T4.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
  const Outcome stopped = run_ranks(3, "out");
  EXPECT_EQ(stopped.status, 2);
  EXPECT_THAT(stopped.errors, HasSubstr("shapegauge: error: model 4: "));
  EXPECT_EQ(stopped.errors.find("model 4", stopped.errors.find("model 4") + 1), std::string::npos);
  EXPECT_TRUE(fs::is_empty(at("out")));

  const Outcome skipped = run_ranks(3, "out", "--set on_error=skip");
  EXPECT_EQ(skipped.status, 1);
  EXPECT_EQ(run_executable("run " + quoted("small.json") + " --set on_error=skip --output " + quoted("alone")).status,
            1);
  EXPECT_EQ(results_in(at("out")), results_in(at("alone")));
}

TEST_F(RunProcesses, AFolderInUseIsRefusedOnce) {
  if (!missing().empty()) GTEST_SKIP() << missing();
  fs::create_directories(at("out"));
  write_text(at("out/summary.csv"), "of something else");
  const Outcome outcome = run_ranks(2, "out");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("results of another configuration"));
  EXPECT_THAT(outcome.errors, Not(HasSubstr("rank")));
}

TEST_F(RunProcesses, WhicheverProcessDiesWheneverTheSameCommandGoesOn) {
  if (!missing().empty()) GTEST_SKIP() << missing();
  std::mt19937 random(16);
  take_long();
  for (int attempt = 0; attempt < 4; ++attempt) {
    SCOPED_TRACE(attempt);
    const std::size_t before = fields_kept();
    BackgroundRun run(arguments(3, "out"), at("errors"), mpirun);
    const std::size_t more = random() % 3;
    run.wait_until([&] { return run.children().size() == 3 && fields_kept() >= before + more; });
    const std::vector<pid_t> ranks = run.children();
    if (ranks.size() != 3) break;  // it has ended
    ::kill(ranks[random() % ranks.size()], SIGKILL);
    EXPECT_NE(run.wait(), 0);
    EXPECT_FALSE(fs::exists(at("out/manifest.json")));
    EXPECT_THAT(text_of(at("errors")), HasSubstr("signal 9 (Killed)"));
  }
  const std::size_t kept = fields_kept();
  EXPECT_GT(kept, 0U);
  const Outcome outcome = run_ranks(3, "out");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "") << "nothing is damaged";
  EXPECT_EQ(json::parse(text_of(at("out/manifest.json")))["execution"]["cache"]["field"]["from_cache"], kept);
  EXPECT_EQ(results_in(at("out")), results_of_one());
}

TEST_F(RunProcesses, AProcessThatIsTerminatedSaysHowToGoOn) {
  if (!missing().empty()) GTEST_SKIP() << missing();
  take_long();
  BackgroundRun run(arguments(2, "out"), at("errors"), mpirun);
  ASSERT_TRUE(run.wait_until([&] { return run.children().size() == 2 && fields_kept() >= 1; }));
  ::kill(run.children().front(), SIGTERM);  // mpirun itself would not forward the signal
  EXPECT_NE(run.wait(), 0);
  EXPECT_THAT(text_of(at("errors")),
              HasSubstr("interrupted; no results were written. Completed shapes are in the cache"));
}

TEST_F(RunProcesses, WithoutTheModuleItSaysWhatIsMissing) {
  const std::string command = "OMPI_COMM_WORLD_SIZE=2 SHAPEGAUGE_MPI_MODULE=" + quoted("none.so") + " " +
                              std::string(SHAPEGAUGE_EXECUTABLE) + " run " + quoted("small.json") + " --output " +
                              quoted("out") + " 2>" + quoted("errors");
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 2);
  EXPECT_THAT(text_of(at("errors")),
              testing::MatchesRegex("shapegauge: error: started as one of 2 processes, which requires MPI, but "
                                    "[^\n]*none.so[^\n]*; without mpirun or srun it runs alone\n"));
  EXPECT_FALSE(fs::exists(at("out")));
}

TEST_F(RunProcesses, RunComparisonsToo) {
  if (!missing().empty()) GTEST_SKIP() << missing();
  json comparison{
      {"name", "x"},
      {"shapes", json::array()},
      {"reference", "1"},
      {"signatures", {{{"name", "s"}, {"field", {{"type", "cone_sdf"}}}, {"histogram", {{"range", "dataset"}}}}}}};
  for (int i = 0; i < 5; ++i) {
    comparison["shapes"].push_back(
        {{"name", std::to_string(i)}, {"file", at("data/T" + std::to_string(i) + ".off").string()}});
  }
  write_text(at("small.json"), comparison.dump());
  const auto expected = results_of_one();
  const std::string from_cache = "From the cache: 5 of 5 compared shapes\n";
  for (const int ranks : {2, 3}) {
    SCOPED_TRACE(ranks);
    const std::string output = "out" + std::to_string(ranks);
    const Outcome outcome = run_ranks(ranks, output);
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(outcome.errors, "");
    EXPECT_EQ(outcome.output.find(from_cache) != std::string::npos, ranks == 3) << outcome.output;
    EXPECT_EQ(results_in(at(output)), expected);
    EXPECT_EQ(json::parse(text_of(at(output) / "manifest.json"))["execution"]["processes"], ranks);
  }
}

}  // namespace
}  // namespace shapegauge
