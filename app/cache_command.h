#pragma once

namespace CLI {
class App;
}

namespace shapegauge {

/// Adds the commands for the cache of results: `shapegauge cache info` and `shapegauge cache clear`. They run while the
/// arguments are parsed and leave their exit status in `status`, which must outlive the app.
void add_cache_command(CLI::App& app, int& status);

}  // namespace shapegauge
