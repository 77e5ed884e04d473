#pragma once

#include <filesystem>
#include <string>
#include <string_view>

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

}  // namespace shapegauge::test
