#include "shapegauge/experiments/command_line/cache_option.h"

#include <CLI/CLI.hpp>

#include "shapegauge/experiments/cache/cache_folder.h"

namespace shapegauge {

void add_cache_option(CLI::App& command, CacheOption& option) {
  command.add_option("--cache", option.named,
                     "Folder of the cache (default: $SHAPEGAUGE_CACHE, or shapegauge in $XDG_CACHE_HOME or ~/.cache)");
}

std::filesystem::path chosen_cache(const CacheOption& option) {
  if (option.none) return {};
  return option.named.empty() ? default_cache_folder() : option.named;
}

}  // namespace shapegauge
