// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/standard_streams.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

void protect_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1) continue;
    // The lowest free descriptor is that of the stream. Opened for the wrong direction, its use stays an error.
    [[maybe_unused]] const int opened = open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

std::string read_standard_input() {
  std::string bytes;
  std::array<char, 1 << 16> piece = {};
  while (const std::size_t size = std::fread(piece.data(), 1, piece.size(), stdin)) bytes.append(piece.data(), size);
  if (bytes.empty()) throw InputError("standard input is empty; check the command that writes to it");
  return bytes;
}

void write_standard_output(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size()) {
    throw InputError("cannot write to standard output: " + std::generic_category().message(errno));
  }
}

ScratchFolder::ScratchFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "shapegauge-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) {
    throw InputError("cannot create the folder " + pattern + ": " + std::generic_category().message(errno));
  }
  path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace shapegauge
