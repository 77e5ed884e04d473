#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace shapegauge::test {

/// Writes a file, its folder too where that is absent.
inline void write_text(const std::filesystem::path& path, const std::string& text) {
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

/// What a file holds; empty where it cannot be read.
inline std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace shapegauge::test
