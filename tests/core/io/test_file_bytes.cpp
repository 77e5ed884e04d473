// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <thread>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using test::bytes_of;
using test::input_error_of;
using test::TemporaryFolder;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

auto throws_cannot_write(const std::filesystem::path& path, const std::string& reason) {
  return ThrowsMessage<InputError>(AllOf(StartsWith("cannot write " + path.string()), EndsWith(reason)));
}

TEST(MappedFile, KeepsTheBytesOfAReplacedOrRemovedFile) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\r\n", 5);
  const auto path = folder.file("in", bytes);
  const MappedBytes mapped = map_file(path);
  EXPECT_EQ(mapped.bytes, bytes);
  write_file_atomically(path, "others");
  EXPECT_EQ(mapped.bytes, bytes);
  std::filesystem::remove(path);
  EXPECT_EQ(mapped.bytes, bytes);
}

TEST(MappedFile, ReportsFoldersAndAbsentOrEmptyFilesAsUnreadable) {
  const TemporaryFolder folder;
  for (const auto& path : {folder.path(), folder.path() / "absent", folder.file("empty", "")}) {
    EXPECT_THAT([&] { map_file(path); }, ThrowsMessage<InputError>(StartsWith("cannot read " + path.string())));
  }
}

using AtomicFileTest = test::FolderTest;

TEST_F(AtomicFileTest, WritesNulAndLineEndsUnchanged) {
  const std::string bytes("a\0b\r\n", 5);
  write_file_atomically(at("out"), bytes);
  EXPECT_EQ(bytes_of(at("out")), bytes);
  EXPECT_EQ(folder_.size(), 1U);
}

TEST_F(AtomicFileTest, ReplacesAnEarlierFile) {
  const auto path = folder_.file("out", "a longer text that was there before");
  write_file_atomically(path, "new");
  EXPECT_EQ(bytes_of(path), "new");
  EXPECT_EQ(folder_.size(), 1U);
}

TEST_F(AtomicFileTest, NewFileHasThePermissionsOfTheUmask) {
  const mode_t before = ::umask(027);
  write_file_atomically(at("out"), "x");
  ::umask(before);
  struct stat status = {};
  ASSERT_EQ(::stat(at("out").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST_F(AtomicFileTest, ReplacementKeepsThePermissionsOfTheEarlierFile) {
  for (const auto mode : {0600, 0640, 0666, 0444}) {
    const fs::path path = folder_.file(fmt::format("{:o}", mode), "old");
    fs::permissions(path, fs::perms(mode));
    write_file_atomically(path, "new");
    EXPECT_EQ(bytes_of(path), "new");
    EXPECT_EQ(fs::status(path).permissions(), fs::perms(mode));
  }
}

TEST_F(AtomicFileTest, RefusesToReplaceAFileCreatedAfterTheCheck) {
  const fs::path path = at("result");
  expect_new_file(path, true);
  const fs::path other = folder_.file("result", "of another program");
  EXPECT_THAT(input_error_of([&] { write_file_atomically(path, "ours"); }), HasSubstr("exists"));
  EXPECT_EQ(bytes_of(other), "of another program");
  EXPECT_EQ(folder_.size(), 1U);
}

TEST_F(AtomicFileTest, ReplacesAFileCreatedByTheSameProcess) {
  const fs::path path = at("result");
  expect_new_file(path, true);
  write_file_atomically(path, "first");
  write_file_atomically(path, "second");
  EXPECT_EQ(bytes_of(path), "second");
}

TEST_F(AtomicFileTest, WritesToTheTargetOfASymbolicLink) {
  const auto path = folder_.file("target", "old");
  std::filesystem::create_symlink(path, at("link"));
  write_file_atomically(at("link"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(at("link")));
  EXPECT_EQ(bytes_of(path), "new");
}

TEST_F(AtomicFileTest, WritesToDevicesWithoutReplacingThem) {
  write_file_atomically("/dev/null", "x");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(AtomicFileTest, RefusesPathsThatCannotBeWritten) {
  for (const auto& [path, reason] :
       {std::pair(folder_.path() / "absent" / "out", "No such file or directory"),
        std::pair(folder_.path(), "Is a directory"), std::pair(fs::path("/dev/full"), "No space left on device")}) {
    EXPECT_THAT([&path = path] { write_file_atomically(path, "x"); }, throws_cannot_write(path, reason));
  }
}

TEST_F(AtomicFileTest, RejectsAFolderWithoutWritePermission) {
  std::filesystem::permissions(folder_.path(), std::filesystem::perms(0555));
  const auto path = at("out");
  {
    const test::OrdinaryUser ordinary_user;
    EXPECT_THAT([&] { write_file_atomically(path, "x"); }, throws_cannot_write(path, "Permission denied"));
  }
  EXPECT_EQ(folder_.size(), 0U);
}

/// Limits the size of files during its lifetime, to simulate a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit = {bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  FileSizeLimit(FileSizeLimit&&) = delete;
  FileSizeLimit& operator=(FileSizeLimit&&) = delete;
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_ = {};
  void (*handler_)(int);
};

TEST_F(AtomicFileTest, FailedWriteKeepsTheEarlierFileAndLeavesNoTemporaryFile) {
  const auto path = folder_.file("out", "old");
  {
    const FileSizeLimit limit(1000);
    EXPECT_THAT([&] { write_file_atomically(path, std::string(5000, 'x')); },
                throws_cannot_write(path, "File too large"));
  }
  EXPECT_EQ(bytes_of(path), "old");
  EXPECT_EQ(folder_.size(), 1U);
}

TEST_F(AtomicFileTest, ConcurrentWritersDoNotMixTheirBytes) {
  const auto path = at("out");
  std::vector<std::jthread> threads;
  for (const char letter : {'a', 'b', 'c', 'd'}) {
    threads.emplace_back([&path, letter] {
      for (int i = 0; i < 50; ++i) write_file_atomically(path, std::string(100'000, letter));
    });
  }
  threads.clear();
  const std::string bytes = bytes_of(path);
  EXPECT_EQ(bytes, std::string(100'000, bytes.front()));
  EXPECT_EQ(folder_.size(), 1U);
}

}  // namespace

}  // namespace shapegauge
