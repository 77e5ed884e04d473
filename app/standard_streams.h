// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "shapegauge/core/io/output_files.h"

/// Standard input and output, given as "-" instead of a file.

namespace shapegauge {

/// Opens /dev/null for each closed standard stream, in the opposite direction, so that using it fails. Otherwise the
/// next opened file would get the stream's descriptor, and messages would be written into results. Call at start-up.
void protect_standard_streams();

/// Reads all of standard input. Throws InputError if it is empty.
std::string read_standard_input();

/// Writes all bytes to standard output. Throws InputError if not all of them can be written.
void write_standard_output(std::string_view bytes);

/// Temporary folder that exists for the lifetime of the object, for readers and writers that need a file name.
class ScratchFolder {
 public:
  /// Creates the folder. Throws InputError if it cannot be created.
  ScratchFolder();
  ~ScratchFolder();  ///< removes the folder with its contents
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ScratchFolder(ScratchFolder&&) = delete;
  ScratchFolder& operator=(ScratchFolder&&) = delete;

  /// Returns the path of the temporary folder.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;  ///< path of the temporary folder
};

}  // namespace shapegauge
