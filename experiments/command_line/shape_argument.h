#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>

namespace shapegauge {

/// Adds the file of the shape that a command is about: whatever read_shape() reads.
void add_shape_argument(CLI::App& command, std::filesystem::path& input);

}  // namespace shapegauge
