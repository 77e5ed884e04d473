#pragma once

#include <filesystem>
#include <gtest/gtest.h>
#include <string>

#include "tests/core/io/temporary_folder.h"

namespace shapegauge::test_command_line {

/// A folder with the small data set in data/, and with a configuration over it: small.json.
class SmallRun : public testing::Test {
 protected:
  void SetUp() override;
  [[nodiscard]] std::filesystem::path at(const std::string& name) const { return folder_.path() / name; }
  /// As a shell takes it.
  [[nodiscard]] std::string quoted(const std::string& name) const { return "'" + at(name).string() + "'"; }

 private:
  test_io::TemporaryFolder folder_;
};

}  // namespace shapegauge::test_command_line
