#pragma once

namespace CLI {
class App;
}

namespace shapegauge {

/// Adds the command for the normals of one shape: `shapegauge normals`. It runs while the arguments are parsed and
/// leaves its exit status in `status`, which must outlive the app.
void add_normals_command(CLI::App& app, int& status);

}  // namespace shapegauge
