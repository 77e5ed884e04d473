// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/io/output_files.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <sys/stat.h>
#include <system_error>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

/// Returns true for the path of a device or an open file: /dev/stdout, /proc/self/fd/1.
bool is_system_path(const fs::path& path) {
  const std::string name = path.lexically_normal().string();
  return name.starts_with("/dev/") || name.starts_with("/proc/");
}

/// Returns true for the path of an existing or future file or folder on disk.
bool is_on_disk(const fs::path& path) {
  if (path.empty() || is_standard_stream(path) || is_system_path(path)) return false;
  std::error_code unknown;
  const fs::file_status status = fs::status(path, unknown);
  return !fs::exists(status) || fs::is_regular_file(status) || fs::is_directory(status);
}

/// Returns a key that is equal for all paths of the same file, existing or not.
std::string identity_of(fs::path path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) == 0) return fmt::format("{}:{}", status.st_dev, status.st_ino);
  std::error_code unknown;
  constexpr int max_links = 40;
  for (int links = 0; links < max_links && fs::is_symlink(path, unknown); ++links) {
    path = path.parent_path() / fs::read_symlink(path, unknown);
  }
  return fs::weakly_canonical(fs::absolute(path, unknown), unknown).string();
}

void check_streams(std::span<const fs::path> inputs, std::span<const OutputFile> outputs) {
  if (std::ranges::count_if(inputs, is_standard_stream) > 1) {
    throw InputError("standard input (-) can be read once only; name files for the other inputs");
  }
  const OutputFile* first = nullptr;
  for (const OutputFile& output : outputs) {
    if (!is_standard_stream(output.path)) continue;
    if (!output.takes_stream) throw InputError(fmt::format("{} must be a file, not standard output (-)", output.what));
    if (first != nullptr) {
      throw InputError(fmt::format("{} and {} would both be written to standard output; name a file for one",
                                   first->what, output.what));
    }
    first = &output;
  }
}

void check_extension(const OutputFile& output) {
  const std::string extension = lower_case(output.path.extension().string());
  if (extension.empty() || output.extensions.empty()) return;
  if (std::ranges::find(output.extensions, extension) != output.extensions.end()) return;
  throw InputError(fmt::format("{}: cannot write {}: the name must end in {}", output.what, output.path.string(),
                               fmt::join(output.extensions, " or ")));
}

}  // namespace

bool is_standard_stream(const fs::path& path) { return path == "-"; }

bool is_page(const fs::path& output) {
  return std::ranges::find(page_extensions, lower_case(output.extension().string())) != page_extensions.end();
}

void check_output_files(std::span<const fs::path> inputs, std::span<const OutputFile> outputs, bool replace) {
  check_streams(inputs, outputs);
  std::map<std::string, fs::path> read;
  for (const fs::path& input : inputs) {
    if (is_on_disk(input)) read.emplace(identity_of(input), input);
  }
  std::map<std::string, std::string> written;
  for (const OutputFile& output : outputs) {
    if (!is_on_disk(output.path)) continue;
    check_extension(output);
    const std::string identity = identity_of(output.path);
    const auto [other, is_new] = written.emplace(identity, output.what);
    if (!is_new) {
      throw InputError(fmt::format("{} and {} would both be written to {}; name another file for one", other->second,
                                   output.what, output.path.string()));
    }
    std::error_code unknown;
    const bool exists = fs::exists(output.path, unknown);
    expect_new_file(output.path, !exists && !replace && !output.is_updated);
    if (!exists || (replace && output.may_be_input)) continue;
    if (const auto input = read.find(identity); input != read.end()) {
      throw InputError(fmt::format("{} would overwrite the input {}; give it another name{}", output.what,
                                   input->second.string(), output.may_be_input ? ", or use `replace=true`" : ""));
    }
    if (!replace && fs::is_directory(output.path, unknown)) {
      throw InputError(fmt::format("{}: {} is a folder; name a file", output.what, output.path.string()));
    }
    if (!replace && !output.is_updated) {
      throw InputError(fmt::format("{}: {} exists; give another name, or overwrite it with `replace=true`", output.what,
                                   output.path.string()));
    }
  }
}

}  // namespace shapegauge
