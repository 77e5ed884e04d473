#pragma once

namespace CLI {
class App;
}

namespace shapegauge {

/// Adds the command that compares methods on the same queries: `shapegauge compare`. It runs while the arguments are
/// parsed and leaves its exit status in `status`, which must outlive the app.
void add_compare_command(CLI::App& app, int& status);

}  // namespace shapegauge
