#pragma once

#include <CLI/CLI.hpp>

namespace shapegauge {

/// Adds --threads; with_threads() takes what it gives.
void add_threads_option(CLI::App& command, int& threads);

}  // namespace shapegauge
