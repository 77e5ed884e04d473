// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_files.h"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <unistd.h>
#include <utility>

namespace shapegauge::test {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "shapegauge-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path TemporaryFolder::file(const std::string& name, std::string_view bytes) const {
  fs::path path = path_ / name;
  fs::remove(path);  // some file systems flush overwritten files, which takes milliseconds
  std::ofstream stream(path, std::ios::binary);
  stream << bytes;
  stream.close();
  if (!stream) throw std::runtime_error("cannot write " + path.string());
  return path;
}

std::size_t TemporaryFolder::size() const {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
}

std::string bytes_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  EXPECT_TRUE(stream) << path;
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return std::move(bytes).str();
}

std::string text_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return std::move(text).str();
}

void write_text(const fs::path& path, const std::string& text) {
  if (path.has_parent_path()) fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

std::map<std::string, std::string> results_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).string();
    const std::string file = entry.path().filename().string();
    if (!entry.is_regular_file() || file == "shape_seconds.csv" || file == "timings.csv") continue;
    files[name] = text_of(entry.path());
    if (file != "manifest.json") continue;
    nlohmann::json manifest = nlohmann::json::parse(files.at(name));
    manifest.erase("execution");
    files[name] = manifest.dump();
  }
  return files;
}

OrdinaryUser::OrdinaryUser() : before_(::geteuid()) {
  if (before_ == 0 && ::seteuid(65534) != 0) throw std::runtime_error("cannot give up root's rights");
}

OrdinaryUser::~OrdinaryUser() {
  if (::seteuid(before_) != 0) ::_exit(1);
}

}  // namespace shapegauge::test
