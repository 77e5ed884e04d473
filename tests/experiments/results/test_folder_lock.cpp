#include <gmock/gmock.h>

#include "shapegauge/experiments/results/folder_lock.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/experiments/input_error.h"
#include "tests/experiments/text_files.h"

namespace shapegauge {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string error_for(const fs::path& folder) {
  return input_error_of([&] { const FolderLock lock(folder); });
}

TEST(FolderLock, KeepsASecondOneOutWhileItLives) {
  const test_io::TemporaryFolder folder;
  {
    const FolderLock lock(folder.path() / "a/b");
    EXPECT_THAT(error_for(folder.path() / "a/b"), HasSubstr("another run is under way in"));
    EXPECT_THAT(error_for(folder.path() / "a/b"), HasSubstr("--output"));
    EXPECT_EQ(error_for(folder.path() / "a"), "no error");
    EXPECT_THAT(error_for(folder.path() / "a/b"), HasSubstr("another run")) << "the refused one has not unlocked it";
  }
  EXPECT_TRUE(fs::is_empty(folder.path() / "a/b"));
  EXPECT_EQ(error_for(folder.path() / "a/b"), "no error");
}

TEST(FolderLock, AFileThatAKilledRunHasLeftIsNoLock) {
  const test_io::TemporaryFolder folder;
  test_experiments::write_text(folder.path() / ".shapegauge-lock", "");
  EXPECT_EQ(error_for(folder.path()), "no error");
}

TEST(FolderLock, AFolderThatCannotBeWrittenToIsAnError) {
  EXPECT_THAT(error_for("/proc/x"), HasSubstr("/proc/x"));
  EXPECT_THAT(error_for("/proc"), HasSubstr("cannot write to the folder /proc"));
}

}  // namespace
}  // namespace shapegauge
