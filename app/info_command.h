#pragma once

namespace CLI {
class App;
}

namespace shapegauge {

/// Adds the command for what there is to know of one shape: `shapegauge info`. It runs while the arguments are parsed
/// and leaves its exit status in `status`, which must outlive the app.
void add_info_command(CLI::App& app, int& status);

}  // namespace shapegauge
