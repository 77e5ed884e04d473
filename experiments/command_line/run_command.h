#pragma once

namespace CLI {
class App;
}

namespace shapegauge {

/// Adds the command for an experiment from its configuration: `shapegauge run`. It runs while the arguments are parsed
/// and leaves its exit status in `status`, which must outlive the app.
void add_run_command(CLI::App& app, int& status);

}  // namespace shapegauge
