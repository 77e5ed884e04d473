#pragma once

#include "shapegauge/core/io/output_files.h"

namespace CLI {
class App;
}

namespace shapegauge {

/// Adds --replace, for check_output_files().
void add_replace_option(CLI::App& command, bool& replace);

}  // namespace shapegauge
