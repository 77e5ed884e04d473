#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
}

/// Checks of the files that a command writes, before any work: no input is overwritten.

namespace shapegauge {

/// A file that a command is asked to write.
struct OutputFile {
  std::filesystem::path path;  ///< empty: not asked for; "-": standard output
  std::string what;            ///< name in messages: "--per-query"
  /// Extensions of the formats, with the dot, in lower case. Empty: not checked. A name without extension is accepted.
  std::vector<std::string> extensions = {};
  bool takes_stream = false;  ///< "-" is possible
  bool may_be_input = false;  ///< with `replace`; requires that inputs are read completely before anything is written
};

/// Adds --replace, for check_output_files().
void add_replace_option(CLI::App& command, bool& replace);

/// Throws InputError where an output is an input or another output (also by a link or another spelling of the path),
/// where it exists and `replace` is not set, where its extension is not that of a format, and where standard input or
/// standard output is named twice. Devices and pipes are always accepted.
void check_output_files(std::span<const std::filesystem::path> inputs, std::span<const OutputFile> outputs,
                        bool replace);

}  // namespace shapegauge
