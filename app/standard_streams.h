#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// "-" in place of a file: standard input and output.

namespace shapegauge {

/// Opens an unusable file for each standard stream that is closed. Otherwise the next file to be opened would
/// get its descriptor, and messages would be written into results. Call at start-up.
void hold_standard_streams();

bool is_standard_stream(const std::filesystem::path& path);

/// All of standard input. Throws InputError where there is nothing.
std::string read_standard_input();

/// Throws InputError where not all of it can be written.
void write_standard_output(std::string_view bytes);

/// A folder of its own for the time of its scope, for readers and writers that need a file's name.
class ScratchFolder {
 public:
  /// Throws InputError where there is no room for one.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ScratchFolder(ScratchFolder&&) = delete;
  ScratchFolder& operator=(ScratchFolder&&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace shapegauge
