#pragma once

namespace CLI {
class App;
}

namespace shapegauge {

/// Adds the command for the evaluation of a distance matrix: `shapegauge evaluate`. It runs while the arguments are
/// parsed and leaves its exit status in `status`, which must outlive the app.
void add_evaluate_command(CLI::App& app, int& status);

}  // namespace shapegauge
