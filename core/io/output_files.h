// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

/// Checks of output files before any work: inputs are never overwritten.

namespace shapegauge {

/// Returns true for "-", the name of standard input and standard output.
bool is_standard_stream(const std::filesystem::path& path);

/// File to be written.
struct OutputFile {
  std::filesystem::path path;  ///< empty if not requested; "-" for standard output
  std::string what;            ///< name in messages: "--per-query"
  /// Extensions of the formats, with the dot, in lower case. Not checked if empty. A name without extension is
  /// accepted.
  std::vector<std::string> extensions = {};
  bool takes_stream = false;  ///< "-" is accepted
  bool may_be_input = false;  ///< with `replace`; all inputs must be read before anything is written
  bool is_updated = false;    ///< may exist without `replace`: its contents are checked before it is overwritten
};

/// Extensions of pages, for OutputFile::extensions.
inline const std::vector<std::string> page_extensions{".html", ".htm"};

/// Returns true if the name ends in one of page_extensions, ignoring case.
bool is_page(const std::filesystem::path& output);

/// Throws InputError if an output is an input or another output (including links and other spellings of a path), if it
/// exists and `replace` is not set, if its extension is not supported, and if standard input or standard output is
/// named twice. Devices and pipes are always accepted. A file that does not exist yet is not replaced later either,
/// should another process create it meanwhile (expect_new_file()).
void check_output_files(std::span<const std::filesystem::path> inputs, std::span<const OutputFile> outputs,
                        bool replace);

}  // namespace shapegauge
