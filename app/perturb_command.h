#pragma once

namespace CLI {
class App;
}

namespace shapegauge {

/// Adds the command that changes one shape at random: `shapegauge perturb`. It runs while the arguments are parsed and
/// leaves its exit status in `status`, which must outlive the app.
void add_perturb_command(CLI::App& app, int& status);

}  // namespace shapegauge
