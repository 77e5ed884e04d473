// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/commands.h"
#include "app/help_format.h"
#include "app/options.h"
#include "app/parameter_options.h"
#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/output_files.h"
#include "shapegauge/core/version.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/search/page_of_answers.h"
#include "shapegauge/experiments/search/search.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

struct SearchArguments {
  std::vector<fs::path> paths;  ///< the queries, then the collection
  std::size_t count = 10;
  bool rerank = false;
  std::string format = "table";
  fs::path page;
  std::string up = "auto";
  fs::path index;
  bool no_update = false;
  bool articulated = false;
  fs::path method;
  std::string signature;
  std::vector<std::string> settings;
  bool replace = false;
  int threads = 0;
  CacheOption cache;
};

SearchMethod chosen_method(const SearchArguments& arguments) {
  if (arguments.articulated) return recommended_search_method(RecommendedMethod::articulated);
  if (!arguments.method.empty()) return read_search_method(arguments.method, arguments.settings, arguments.signature);
  if (!arguments.settings.empty() || !arguments.signature.empty()) {
    throw InputError("--set and --signature require --configuration");
  }
  return recommended_search_method();
}

/// A search, from the arguments to the printed results.
class SearchRun {
 public:
  explicit SearchRun(const SearchArguments& arguments)
      : arguments_(&arguments), collection_(arguments.paths.back()), cache_(requested_cache_folder(arguments.cache)) {
    for (std::size_t i = 0; i + 1 < arguments.paths.size(); ++i) {
      queries_.push_back({.name = arguments.paths[i].string(), .file = arguments.paths[i]});
    }
  }

  int run() {
    check_outputs();
    catch_interruption();
    try {
      open();
      answers_ = search(index_, queries_, options(), control(), cache_, update_.notes);
      write_page();
    } catch (const Interrupted&) {
      progress_.clear();
      throw Interrupted(cache_.folder().empty() ? "interrupted; the index is unchanged"
                                                : "interrupted; the index is unchanged. Described shapes are in the "
                                                  "cache; the same command continues from there");
    }
    progress_.clear();
    print_answers();
    return print_remarks();
  }

 private:
  [[nodiscard]] SearchOptions options() const { return {.count = arguments_->count, .rerank = arguments_->rerank}; }

  RunControl control() {
    return {.threads = arguments_->threads, .interrupted = interrupted, .progress = progress_.receiver()};
  }

  [[nodiscard]] fs::path index_file() const {
    if (!arguments_->index.empty()) return arguments_->index;
    return default_index_path(collection_, arguments_->articulated
                                               ? fs::path(recommended_file(RecommendedMethod::articulated))
                                               : arguments_->method);
  }

  void check_outputs() const {
    if (!arguments_->page.empty() && queries_.empty())
      throw InputError("--output requires queries: name their files before the collection");
    std::vector<fs::path> inputs{arguments_->paths.begin(), arguments_->paths.end()};
    inputs.push_back(arguments_->method);
    const std::vector<OutputFile> outputs{
        {.path = index_file(), .what = "--index", .is_updated = true},
        {.path = arguments_->page, .what = "--output", .extensions = page_extensions}};
    check_output_files(inputs, outputs, arguments_->replace);
  }

  void open() {
    SearchMethod method = chosen_method(*arguments_);
    if (arguments_->no_update) {
      index_ = open_index_without_update(std::move(method), collection_, index_file());
    } else {
      index_ = open_index(std::move(method), collection_, index_file(), control(), cache_, update_);
    }
  }

  void write_page() {
    if (arguments_->page.empty()) return;
    const std::string title = fmt::format(
        "{} in {}",
        queries_.size() == 1 ? queries_.front().file.filename().string() : fmt::format("{} queries", queries_.size()),
        collection_.string());
    write_file_atomically(arguments_->page, page_of_answers(index_, queries_, answers_, title,
                                                            value_of_word<UpAxis>(arguments_->up).value(), control()));
  }

  [[nodiscard]] const IndexedFile& model(const RankedModel& one) const {
    return index_.contents.models[static_cast<std::size_t>(one.model)];
  }

  [[nodiscard]] TextTable table() const {
    TextTable table{.header = {"query", "name", "rank", "distance"}, .rows = {}, .text_columns = 2};
    for (const SearchAnswer& answer : answers_) {
      for (std::size_t i = 0; i < answer.nearest.size(); ++i) {
        table.rows.push_back({answer.query, model(answer.nearest[i]).id, fmt::format("{}", i + 1),
                              distance_text(answer.nearest[i].distance)});
      }
    }
    return table;
  }

  [[nodiscard]] std::string distance_text(double distance) const {
    return arguments_->format == "csv" ? fmt::format("{}", distance) : fmt::format("{:#.4g}", distance);
  }

  [[nodiscard]] nlohmann::ordered_json json() const {
    using Json = nlohmann::ordered_json;
    Json queries = Json::array();
    for (const SearchAnswer& answer : answers_) {
      Json query{{"query", answer.query}};
      if (answer.member) query["name"] = index_.contents.models[*answer.member].id;
      if (!answer.failure.empty()) query["error"] = answer.failure;
      query["results"] = Json::array();
      for (const RankedModel& one : answer.nearest) {
        query["results"].push_back({{"name", model(one).id},
                                    {"file", index_.collection.file(model(one).path).string()},
                                    {"distance", one.distance}});
      }
      queries.push_back(std::move(query));
    }
    Json left_out = Json::array();
    for (const IndexedFile& file : index_.contents.failures) {
      left_out.push_back({{"name", file.id}, {"error", file.failure}});
    }
    return {{"version", version()},
            {"collection", collection_.string()},
            {"index", index_.file.string()},
            {"signature", index_.method.name},
            {"reranked", arguments_->rerank},
            {"models", index_.contents.models.size()},
            {"left_out", std::move(left_out)},
            {"queries", std::move(queries)}};
  }

  void print_answers() const {
    if (arguments_->format == "json") return print_output("{}\n", json_text(json(), 2));
    if (queries_.empty()) return;
    print_output("{}", table_text(table(), value_of_word<TableFormat>(arguments_->format).value()));
  }

  /// Returns the exit status.
  int print_remarks() const {
    for (const std::string& text : update_.notes) note(text);
    for (const LeftOutShape& one : update_.left_out) warn(fmt::format("omitted {}: {}", one.id, one.message));
    const ShapeIndex& contents = index_.contents;
    const std::size_t all = contents.models.size() + contents.failures.size();
    if (update_.rebuilt) {
      note(fmt::format("{} of {} shapes indexed in {}", contents.models.size(), all, index_.file.string()));
      if (const std::string skipped = skipped_text(index_.collection.skipped); !skipped.empty()) note(skipped);
    } else if (!contents.failures.empty()) {
      note(
          fmt::format("{} of {} shapes of the collection cannot be described and are omitted; --format json lists them",
                      contents.failures.size(), all));
    }
    int status = update_.left_out.empty() ? exit_success : exit_with_failures;
    for (const SearchAnswer& answer : answers_) {
      if (answer.failure.empty()) continue;
      print_error(answer.failure.find(answer.query) == std::string::npos
                      ? fmt::format("{}: {}", answer.query, answer.failure)
                      : answer.failure);
      status = exit_with_failures;
    }
    const bool none = !answers_.empty() &&
                      std::ranges::none_of(answers_, [](const SearchAnswer& answer) { return answer.failure.empty(); });
    return none ? exit_unusable_input : status;
  }

  const SearchArguments* arguments_;
  fs::path collection_;
  std::vector<SearchQuery> queries_;
  Cache cache_;
  ProgressLine progress_;
  OpenIndex index_;
  IndexUpdate update_;
  std::vector<SearchAnswer> answers_;
};

void add_method_options(CLI::App& command, SearchArguments& arguments) {
  CLI::Option* articulated = command.add_flag("--articulated", arguments.articulated,
                                              "Use the pose-invariant method, recommended for articulated shapes");
  for (CLI::Option* option :
       {command.add_option("--method", arguments.method)->group(hidden_options),  // the older name
        command.add_option("--configuration", arguments.method,
                           "Configuration file of a retrieval experiment that defines the search method (default: the "
                           "recommended method)"),
        command.add_option("--signature", arguments.signature,
                           "Name of the signature (features and distance) in --configuration to search by; must not be "
                           "re-ranked or fused (default: the last suitable signature)"),
        command.add_option(
            "--set", arguments.settings,
            "Override a value of --configuration: dotted.key=value, such as signatures[Sum].scale=ranks for "
            "signature Sum; paths are relative to the working directory; repeatable")}) {
    articulated->excludes(option);
  }
}

}  // namespace

void add_search_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("search", "Search a collection for similar shapes");
  command->footer(
      "Example: shapegauge search chair.obj models/\n"
      "         shapegauge search models/                (only builds the index)\n"
      "Distances are comparable only within one collection and method.");
  const auto arguments = std::make_shared<SearchArguments>();
  command
      ->add_option("paths", arguments->paths,
                   "Query files, if any, then the collection: a folder, list of files (.txt) or data set (.cla, .csv, "
                   ".json)")
      ->required();
  begin_option_group(*command, output_options);
  command->add_option("-k,--count", arguments->count, "Number of results per query")
      ->check(within<std::size_t>(parameter_named("count", search_table).bounds))
      ->capture_default_str();
  command->add_flag("--rerank", arguments->rerank,
                    "Re-rank results by diffusion on the collection's neighbourhood graph");
  add_format_option(*command, arguments->format, "Format of the printed result");
  command->add_option("-o,--output", arguments->page, "HTML file with pictures and 3D views of the results");
  add_up_option(*command, arguments->up);
  add_replace_option(*command, arguments->replace);
  begin_option_group(*command, "Index and method");
  command->add_option("--index", arguments->index,
                      "Index file, created or updated as needed (default: next to the collection, such as "
                      "models.search-index)");
  command->add_flag("--no-update", arguments->no_update, "Use the index without checking the collection for changes");
  add_method_options(*command, *arguments);
  add_cache_option(*command, arguments->cache);
  add_threads_option(*command, arguments->threads);
  command->callback([arguments, &status] { status = SearchRun(*arguments).run(); });
}

}  // namespace shapegauge
