#pragma once

namespace CLI {
class App;
}

namespace shapegauge {

/// Adds the command for looking at, checking and generating data sets: `shapegauge dataset info|validate|generate`. It
/// runs while the arguments are parsed and leaves its exit status in `status`, which must outlive the app.
void add_dataset_command(CLI::App& app, int& status);

}  // namespace shapegauge
