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
  /// Writes a file called `name` in the folder; returns its path.
  [[nodiscard]] std::filesystem::path file(const std::string& name, std::string_view bytes) const;
  /// Returns the number of files and folders in the folder, without those in subfolders.
  [[nodiscard]] std::size_t size() const;

 private:
  std::filesystem::path path_;
};

/// Test fixture with a temporary folder.
class FolderTest : public testing::Test {
 protected:
  /// Returns the path of a file in the temporary folder.
  [[nodiscard]] std::filesystem::path at(const std::string& name) const { return folder_.path() / name; }

  TemporaryFolder folder_;
};

/// Returns the bytes of a file; fails the test if it cannot be read.
std::string bytes_of(const std::filesystem::path& path);

/// Returns the bytes of a file; empty if it cannot be read.
std::string text_of(const std::filesystem::path& path);

/// Returns the contents of the result files in a folder and its subfolders by relative path, without files of run times
/// and the manifest's information on the execution: equal for two runs with the same results.
std::map<std::string, std::string> results_in(const std::filesystem::path& folder);

/// Writes a file; creates its folder if absent.
void write_text(const std::filesystem::path& path, const std::string& text);

/// Drops the rights of the user root during the object's lifetime, because root ignores file permissions.
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

/// Returns the message of the InputError that call() throws, or "no error". Other exceptions propagate.
template <typename Call>
std::string input_error_of(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// Invalid input of a function and the expected error.
struct Refusal {
  std::string input;  ///< invalid input, such as the contents of a file
  std::string word;   ///< text that the error message must contain, such as a line or a name
};

/// Checks that call(input) throws an InputError whose message contains the expected word, for each invalid input.
template <typename Call>
void expect_refused(const std::vector<Refusal>& refusals, const Call& call) {
  for (const Refusal& refusal : refusals) {
    EXPECT_THAT(input_error_of([&] { call(refusal.input); }), testing::HasSubstr(refusal.word)) << refusal.input;
  }
}

}  // namespace shapegauge::test
