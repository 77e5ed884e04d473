#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
}

/// Checks the files that a command writes, before any work: nothing that is read is overwritten.

namespace shapegauge {

/// A file that a command is asked to write.
struct OutputFile {
  std::filesystem::path path;  ///< empty: not asked for; "-": standard output
  std::string what;            ///< name in messages: "--per-query"
  /// Extensions of the formats, with the dot, in lower case. Empty: checked elsewhere. A name without extension gets
  /// the first format.
  std::vector<std::string> extensions = {};
  bool takes_stream = false;  ///< "-" is possible
  bool may_be_input = false;  ///< with `replace`, where inputs are read as a whole before anything is written
};

/// Adds --replace, for check_output_files().
void add_replace_option(CLI::App& command, bool& replace);

/// Throws InputError where an output is an input or another output (also by a link or another spelling of the path),
/// where it exists and `replace` is not set, where its extension is none of its formats', and where standard input or
/// standard output is named twice. Devices and pipes are always possible.
void check_output_files(std::span<const std::filesystem::path> inputs, std::span<const OutputFile> outputs,
                        bool replace);

}  // namespace shapegauge
