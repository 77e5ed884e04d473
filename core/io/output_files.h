// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

/// Checks of output files before any work: inputs are never overwritten.

namespace shapegauge {

/// Returns true if the path is "-", which stands for standard input or standard output.
bool is_standard_stream(const std::filesystem::path& path);

/// Output file of a command: its path and the checks that check_output_files() makes of it.
struct OutputFile {
  std::filesystem::path path;  ///< path of the file; empty if not requested; "-" for standard output
  std::string what;            ///< name of the option or argument in error messages, such as "--per-query"
  /// Accepted extensions, with the dot, in lower case; empty accepts all. A path without an extension is always
  /// accepted.
  std::vector<std::string> extensions = {};
  bool takes_stream = false;  ///< true if the path may be "-", which means standard output
  /// True if the file may also be an input, provided that `replace` is set; all inputs are read first.
  bool may_be_input = false;
  bool is_updated = false;  ///< true if the file may exist even without `replace`: the caller checks and updates it
};

/// Extensions of HTML pages, for OutputFile::extensions.
inline const std::vector<std::string> page_extensions{".html", ".htm"};

/// Returns true if the name ends in one of page_extensions, ignoring case.
bool is_page(const std::filesystem::path& output);

/// Throws InputError if an output is an input or another output (including links and other spellings of a path), if it
/// exists and `replace` is not set, if its extension is not supported, and if standard input or standard output is
/// named twice. Devices and pipes are always accepted. If another process creates an output after this check, writing
/// it fails, unless it may be replaced (expect_new_file()).
void check_output_files(std::span<const std::filesystem::path> inputs, std::span<const OutputFile> outputs,
                        bool replace);

}  // namespace shapegauge
