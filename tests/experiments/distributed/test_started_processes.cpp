#include <cstdlib>
#include <gtest/gtest.h>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/distributed/communicator.h"
#include "tests/support/test_files.h"

namespace shapegauge {
namespace {

/// Environment of a process, without the variables of launchers.
class StartedProcesses : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* const name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"}) clear(name);
  }
  void TearDown() override {
    SetUp();
    clear("SHAPEGAUGE_MPI_MODULE");
  }
  static void set(const char* name, const std::string& value) {
    ASSERT_EQ(::setenv(name, value.c_str(), 1), 0);  // NOLINT(concurrency-mt-unsafe): one thread
  }
  static void clear(const char* name) { ::unsetenv(name); }  // NOLINT(concurrency-mt-unsafe)
};

TEST_F(StartedProcesses, WithoutALauncherThisOneIsAlone) {
  const auto ranks = started_processes();
  EXPECT_EQ(ranks->rank(), 0);
  EXPECT_EQ(ranks->size(), 1);
}

TEST_F(StartedProcesses, AWordOrOneProcessIsNoLauncher) {
  for (const char* const value : {"1", "", "many"}) {
    set("PMI_SIZE", value);
    EXPECT_EQ(started_processes()->size(), 1) << value;
  }
}

TEST_F(StartedProcesses, OthersNeedAModuleThatLoads) {
  const test::TemporaryFolder folder;
  const std::string module = folder.file("module.so", "no library").string();
  for (const char* const launcher : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"}) {
    set(launcher, "3");
    set("SHAPEGAUGE_MPI_MODULE", module);
    const std::string error = test::input_error_of([] { started_processes(); });
    EXPECT_NE(error.find("3"), std::string::npos) << error;
    EXPECT_NE(error.find(module), std::string::npos) << error;
    clear(launcher);
  }
}

}  // namespace
}  // namespace shapegauge
