#pragma once

namespace CLI {
class App;
}

namespace shapegauge {

/// Adds the command that cuts shapes into parts: `shapegauge segment`. It runs while the arguments are parsed and
/// leaves its exit status in `status`, which must outlive the app.
void add_segment_command(CLI::App& app, int& status);

}  // namespace shapegauge
