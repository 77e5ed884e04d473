// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <cstdint>
#include <fmt/format.h>
#include <memory>
#include <string>

#include "app/commands.h"
#include "app/options.h"
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/cache/cache_folder.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

/// Formats a number of bytes for people: "3.2 kB", "12.0 GB".
std::string size_text(std::uintmax_t bytes) {
  const auto size = static_cast<double>(bytes);
  if (size >= 1e9) return fmt::format("{:.1f} GB", size / 1e9);
  return size >= 1e6 ? fmt::format("{:.1f} MB", size / 1e6) : fmt::format("{:.1f} kB", size / 1e3);
}

fs::path folder_of(const CacheOption& option) {
  fs::path folder = requested_cache_folder(option);
  if (folder.empty()) throw InputError("no cache folder: SHAPEGAUGE_CACHE is empty or HOME is not set; see --cache");
  return folder;
}

int show_cache(const CacheOption& option) {
  const fs::path folder = folder_of(option);
  const CacheContents contents = cache_contents(folder);
  TextTable table{.header = {"kind", "entries", "size"}, .rows = {}};
  const auto add = [&](std::string_view name, const CacheContents::Amount& amount) {
    table.rows.push_back({std::string(name), std::to_string(amount.entries), size_text(amount.bytes)});
  };
  for (std::size_t kind = 0; kind < number_of_entry_kinds; ++kind)
    add(entry_kind_names.at(kind), contents.by_kind.at(kind));
  if (contents.unfinished.entries > 0) add("unfinished", contents.unfinished);
  add("all", contents.total());
  print_output("Cache in {}\n\n{}\nMaximum size after a run: {} (SHAPEGAUGE_CACHE_LIMIT).\n",
               printable(folder.string()), to_plain_text(table), size_text(cache_limit()));
  return exit_success;
}

int clear(const CacheOption& option) {
  const fs::path folder = folder_of(option);
  const CacheContents::Amount removed = clear_cache(folder).total();
  print_output("{}, {}, removed from {}\n", count_text(static_cast<std::int64_t>(removed.entries), "entry", "entries"),
               size_text(removed.bytes), printable(folder.string()));
  return exit_success;
}

void add_action(CLI::App& cache, const char* name, const char* what, int (*action)(const CacheOption&), int& status) {
  CLI::App* command = cache.add_subcommand(name, what);
  command->footer("");  // else that of the parent
  const auto option = std::make_shared<CacheOption>();
  add_cache_option(*command, *option);
  command->callback([option, action, &status] { status = action(*option); });
}

}  // namespace

void add_cache_command(CLI::App& app, int& status) {
  CLI::App* cache = app.add_subcommand("cache", "Inspect or clear the cache of runs");
  cache->require_subcommand(1);
  cache->footer("Example: shapegauge cache info");
  add_action(*cache, "info", "Print the folder and contents of the cache", show_cache, status);
  add_action(*cache, "clear", "Remove all cached results; later runs compute them again", clear, status);
}

}  // namespace shapegauge
