#pragma once

namespace CLI {
class App;
}

namespace shapegauge {

/// Adds the command that compares segmentations with people's: `shapegauge evaluate-segmentation`. It runs while the
/// arguments are parsed and leaves its exit status in `status`, which must outlive the app.
void add_segmentation_evaluation_command(CLI::App& app, int& status);

}  // namespace shapegauge
