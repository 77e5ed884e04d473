#include "app/output_files.h"

#include <CLI/CLI.hpp>

#include "app/help_format.h"

namespace shapegauge {

void add_replace_option(CLI::App& command, bool& replace) {
  command.add_flag("--replace", replace, "Overwrite existing files")->group(output_options);
}

}  // namespace shapegauge
