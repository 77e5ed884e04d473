// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <gmock/gmock.h>
#include <map>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

#include "shapegauge/core/base/error.h"

/// Files and folders for tests, and errors of reading them.
namespace shapegauge::test {

/// Temporary folder, removed with its contents at the end of the scope.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  TemporaryFolder(TemporaryFolder&&) = delete;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Creates a file with the bytes; returns its path.
  [[nodiscard]] std::filesystem::path file(const std::string& name, std::string_view bytes) const;
  /// Number of files and folders in the folder.
  [[nodiscard]] std::size_t size() const;

 private:
  std::filesystem::path path_;
};

/// A test with a folder of its own.
class FolderTest : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path at(const std::string& name) const { return folder_.path() / name; }

  TemporaryFolder folder_;
};

/// Returns the bytes of a file; fails the test if it cannot be read.
std::string bytes_of(const std::filesystem::path& path);

/// Returns the bytes of a file; empty if it cannot be read.
std::string text_of(const std::filesystem::path& path);

/// Returns the bytes of a folder's result files by name, without run times.
std::map<std::string, std::string> results_in(const std::filesystem::path& folder);

/// Writes a file; creates its folder if absent.
void write_text(const std::filesystem::path& path, const std::string& text);

/// Drops root's rights during its lifetime, because root ignores file permissions.
class OrdinaryUser {
 public:
  OrdinaryUser();
  OrdinaryUser(const OrdinaryUser&) = delete;
  OrdinaryUser& operator=(const OrdinaryUser&) = delete;
  OrdinaryUser(OrdinaryUser&&) = delete;
  OrdinaryUser& operator=(OrdinaryUser&&) = delete;
  ~OrdinaryUser();

 private:
  uid_t before_;
};

/// Message of the InputError thrown by the call, or "no error". Other exceptions propagate.
template <typename Call>
std::string input_error_of(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// An input that a function refuses, and the part of its message that matters: a file, a line, a name.
struct Refusal {
  std::string input;
  std::string word;
};

/// Checks that the call throws an InputError with the word for each input.
template <typename Call>
void expect_refused(const std::vector<Refusal>& refusals, const Call& call) {
  for (const Refusal& refusal : refusals) {
    EXPECT_THAT(input_error_of([&] { call(refusal.input); }), testing::HasSubstr(refusal.word)) << refusal.input;
  }
}

}  // namespace shapegauge::test
