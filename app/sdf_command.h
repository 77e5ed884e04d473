#pragma once

namespace CLI {
class App;
}

namespace shapegauge {

/// Adds the command for the values of one shape: `shapegauge sdf`. It runs while the arguments are parsed and
/// leaves its exit status in `status`, which must outlive the app.
void add_sdf_command(CLI::App& app, int& status);

}  // namespace shapegauge
