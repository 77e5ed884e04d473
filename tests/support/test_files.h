#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <sys/types.h>

#include "shapegauge/core/base/error.h"

/// Files and folders for tests, and the errors that reading them gives.
namespace shapegauge::test {

/// A new folder that is removed, with what is in it, at the end of the scope.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  TemporaryFolder(TemporaryFolder&&) = delete;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Path of a new file with these bytes.
  [[nodiscard]] std::filesystem::path file(const std::string& name, std::string_view bytes) const;
  /// Number of files and folders in it.
  [[nodiscard]] std::size_t size() const;

 private:
  std::filesystem::path path_;
};

/// The bytes of a file; a test failure where it cannot be read.
std::string bytes_of(const std::filesystem::path& path);

/// The bytes of a file; empty where it cannot be read.
std::string text_of(const std::filesystem::path& path);

/// Writes a file, its folder too where that is absent.
void write_text(const std::filesystem::path& path, const std::string& text);

/// While it lives, the process has the rights of an ordinary user: permissions do not bind root.
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

/// The message of the InputError that the call throws; "no error" where it throws none. Other exceptions pass through.
template <typename Call>
std::string input_error_of(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace shapegauge::test
