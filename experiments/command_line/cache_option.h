#pragma once

#include <filesystem>

namespace CLI {
class App;
}

namespace shapegauge {

/// The folder of the cache that the user wants.
struct CacheOption {
  std::filesystem::path named;  ///< empty: default_cache_folder()
  bool none = false;
};

/// Adds `--cache` to a command, which leaves what the user says in `option`.
void add_cache_option(CLI::App& command, CacheOption& option);

/// The folder; empty where there is to be no cache.
std::filesystem::path chosen_cache(const CacheOption& option);

}  // namespace shapegauge
