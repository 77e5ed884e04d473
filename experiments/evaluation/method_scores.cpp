// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/evaluation/method_scores.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/datasets/files/compressed_files.h"
#include "shapegauge/datasets/files/csv.h"
#include "shapegauge/datasets/files/model_ids.h"

namespace shapegauge {

namespace {

constexpr std::size_t first_measure = 4;

void check_header(const std::vector<CsvRow>& rows, const std::string& source) {
  const std::vector<std::string> words = {"method", "protocol", "id", "class"};
  const bool known = !rows.empty() && rows[0].cells.size() > first_measure &&
                     std::equal(words.begin(), words.end(), rows[0].cells.begin());
  if (known) return;
  throw InputError(
      fmt::format("{}: expected a table of scores by query, beginning with method,protocol,id,class, as written by "
                  "'run' and 'evaluate --per-query'",
                  source));
}

// Divides the number in the cell by 100 exactly, through its exponent.
std::optional<double> fraction_of_percent(const std::string& cell) {
  if (const auto fraction = parse_number(cell + "e-2")) return fraction;
  const auto percent = parse_number(cell);
  return percent ? std::optional(*percent / 100) : std::nullopt;
}

// Returns the maximum of a measure: the first tier of SHREC'21 is 1 + 1 / R for a perfect list.
double max_score(const std::string& measure) { return measure == "shrec21.FT" ? 2 : 1; }

Eigen::RowVectorXd scores_of(const CsvRow& row, std::span<const std::string> measures, const std::string& source) {
  if (row.cells.size() != first_measure + measures.size()) {
    throw InputError(fmt::format("{0}:{1}: expected {3} cells as in the first row, found {2}", source, row.line,
                                 row.cells.size(), first_measure + measures.size()));
  }
  Eigen::RowVectorXd scores(std::ssize(measures));
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const std::string& cell = row.cells[first_measure + i];
    const auto fraction = fraction_of_percent(cell);
    const double max = max_score(measures[i]);
    if (!fraction || !(*fraction >= 0 && *fraction <= max)) {
      throw InputError(
          fmt::format("{}:{}: {} is not a number from 0 to {}", source, row.line, quoted_word(cell), 100 * max));
    }
    scores[static_cast<Eigen::Index>(i)] = *fraction;
  }
  return scores;
}

// Rows of a method's queries, by key.
struct QueryRows {
  ModelKeys keys;
  std::unordered_map<std::string, std::size_t> by_key;

  [[nodiscard]] std::optional<std::size_t> find(const std::string& query) const {
    const auto found = by_key.find(keys.of(query));
    return found == by_key.end() ? std::nullopt : std::optional(found->second);
  }
};

QueryRows query_rows_of(const MethodScores& method) {
  QueryRows query_rows{.keys = ModelKeys(method.queries), .by_key = {}};
  for (const std::string& query : method.queries) {
    if (query_rows.by_key.emplace(query_rows.keys.of(query), query_rows.by_key.size()).second) continue;
    throw InputError(
        fmt::format("{}: repeated query {} for {}", method.source, quoted_word(query), quoted_word(method.method)));
  }
  return query_rows;
}

// Names a method with its file.
std::string name_with_file(const MethodScores& method) {
  return fmt::format("{} ({})", quoted_word(method.method), method.source);
}

void check_protocols(std::span<const MethodScores> methods) {
  for (const MethodScores& method : methods) {
    if (method.protocol == methods[0].protocol) continue;
    throw InputError(
        fmt::format("{} has the protocol {} but {} has {}; scores of different protocols cannot be compared",
                    name_with_file(methods[0]), methods[0].protocol, name_with_file(method), method.protocol));
  }
}

// Returns the file of the scores; for a run's per_query.csv, its folder.
std::filesystem::path location_of(const MethodScores& method) {
  const std::filesystem::path file = std::filesystem::path(method.source).lexically_normal();
  return file.filename() == per_query_name && file.has_parent_path() ? file.parent_path() : file;
}

std::vector<std::string> unique_names(std::span<const MethodScores> methods) {
  std::map<std::string, std::vector<std::size_t>> uses;
  for (std::size_t i = 0; i < methods.size(); ++i) uses[methods[i].method].push_back(i);
  std::vector<std::string> names(methods.size());
  for (const auto& [name, users] : uses) {
    std::vector<std::filesystem::path> locations;
    for (const std::size_t i : users) locations.push_back(location_of(methods[i]));
    const std::vector<std::string> ends = distinguishing_suffixes(locations);
    std::map<std::string, int> repeated;
    for (std::size_t k = 0; k < users.size(); ++k) {
      const bool named_by_file = locations[k].stem().string() == name;
      std::string unique = named_by_file ? ends[k] : fmt::format("{}: {}", ends[k], name);
      if (users.size() == 1) unique = name;
      const int use = ++repeated[unique];  // the same file twice
      names[users[k]] = use == 1 ? unique : fmt::format("{} ({})", unique, use);
    }
  }
  return names;
}

std::vector<std::string> checked_names(std::span<const MethodScores> methods, std::span<const std::string> requested) {
  if (requested.empty()) return unique_names(methods);
  if (requested.size() != methods.size()) {
    throw InputError(fmt::format("`names` has {} names for {} methods ({})", requested.size(), methods.size(),
                                 fmt::join(unique_names(methods), ", ")));
  }
  for (std::size_t i = 0; i < requested.size(); ++i) {
    if (requested[i].empty()) throw InputError("a name in `names` is empty");
    if (std::ranges::count(requested, requested[i]) > 1) {
      throw InputError(fmt::format("two methods have the name {}; change `names`", quoted_word(requested[i])));
    }
  }
  return {requested.begin(), requested.end()};
}

std::vector<std::string> measures_to_compare(std::span<const MethodScores> methods,
                                             std::span<const std::string> requested) {
  if (!requested.empty()) return {requested.begin(), requested.end()};
  std::vector<std::string> common = methods[0].measures;
  std::erase_if(common, [&](const std::string& measure) {
    return !std::ranges::all_of(methods, [&](const MethodScores& method) {
      return std::ranges::find(method.measures, measure) != method.measures.end();
    });
  });
  if (common.empty()) throw InputError("the methods have no measure in common; evaluate them with the same `measures`");
  return common;
}

Eigen::Index column_of(const MethodScores& method, const std::string& measure) {
  const auto found = std::ranges::find(method.measures, measure);
  if (found != method.measures.end()) return found - method.measures.begin();
  throw InputError(fmt::format("{}: no measure {} for {}; available are {}", method.source, quoted_word(measure),
                               quoted_word(method.method), fmt::join(method.measures, ", ")));
}

// Returns the row of each query of `first` in `method`; both have the same queries and classes.
std::vector<std::size_t> rows_of(const MethodScores& first, const MethodScores& method) {
  const QueryRows query_rows = query_rows_of(method);
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < first.queries.size(); ++i) {
    const auto found = query_rows.find(first.queries[i]);
    if (!found) {
      throw InputError(
          fmt::format("{}: {} lacks the query {}, which {} has; only scores of the same queries can be compared",
                      method.source, quoted_word(method.method), quoted_word(first.queries[i]), name_with_file(first)));
    }
    if (method.classes[*found] != first.classes[i]) {
      throw InputError(fmt::format("{}: the query {} is of class {} in {}, but of {} in {}", method.source,
                                   quoted_word(first.queries[i]), quoted_word(method.classes[*found]),
                                   quoted_word(method.method), quoted_word(first.classes[i]), name_with_file(first)));
    }
    rows.push_back(*found);
  }
  if (query_rows.by_key.size() == first.queries.size()) return rows;
  const QueryRows known = query_rows_of(first);
  const auto more = std::ranges::find_if(method.queries, [&](const std::string& query) { return !known.find(query); });
  throw InputError(
      fmt::format("{}: {} has the query {}, which {} lacks; only scores of the same queries can be compared",
                  method.source, quoted_word(method.method), quoted_word(*more), name_with_file(first)));
}

}  // namespace

std::vector<int> class_numbers(const std::vector<std::string>& classes) {
  std::unordered_map<std::string, int> numbers;
  std::vector<int> labels;
  labels.reserve(classes.size());
  for (const std::string& name : classes) {
    labels.push_back(numbers.emplace(name, static_cast<int>(numbers.size())).first->second);
  }
  return labels;
}

std::vector<MethodScores> read_method_scores(const std::filesystem::path& path) {
  const std::string source = path.string();
  const std::vector<CsvRow> rows = parse_csv(read_plain_bytes(path), source);
  check_header(rows, source);
  const std::vector<std::string> measures(rows[0].cells.begin() + first_measure, rows[0].cells.end());
  std::vector<MethodScores> methods;
  std::vector<std::vector<Eigen::RowVectorXd>> scores;
  std::map<std::pair<std::string, std::string>, std::size_t> indices;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const Eigen::RowVectorXd of_query = scores_of(rows[i], measures, source);
    const std::vector<std::string>& cells = rows[i].cells;
    const auto [entry, is_new] = indices.emplace(std::pair(cells[0], cells[1]), methods.size());
    if (is_new) {
      methods.push_back({.method = cells[0], .source = source, .protocol = cells[1], .measures = measures});
      scores.emplace_back();
    }
    methods[entry->second].queries.push_back(cells[2]);
    methods[entry->second].classes.push_back(cells[3]);
    scores[entry->second].push_back(of_query);
  }
  for (std::size_t m = 0; m < methods.size(); ++m) {
    methods[m].values.resize(static_cast<Eigen::Index>(scores[m].size()), static_cast<Eigen::Index>(measures.size()));
    for (std::size_t i = 0; i < scores[m].size(); ++i)
      methods[m].values.row(static_cast<Eigen::Index>(i)) = scores[m][i];
    query_rows_of(methods[m]);
  }
  return methods;
}

std::string method_name(const std::filesystem::path& path, const EvaluationData& data) {
  if (!data.name.empty()) return data.name;
  const bool compressed = lower_case(path.extension().string()) == ".gz";
  return (compressed ? path.stem() : path).stem().string();
}

MethodScores method_scores(const std::string& method, const std::string& source, const EvaluationTask& task,
                           const Evaluation& evaluation) {
  MethodScores values{.method = method,
                      .source = source,
                      .protocol = name_of(evaluation.protocol),
                      .measures = evaluation.measures,
                      .values = evaluation.per_query};
  for (std::size_t i = 0; i < evaluation.queries.size(); ++i) {
    values.queries.push_back(task.query_ids[static_cast<std::size_t>(evaluation.queries[i])]);
    values.classes.push_back(task.class_names[static_cast<std::size_t>(evaluation.query_classes[i])]);
  }
  return values;
}

AlignedMethods align_methods(std::span<const MethodScores> methods, std::span<const std::string> requested_measures,
                             std::span<const std::string> names) {
  check_protocols(methods);
  AlignedMethods aligned{.methods = checked_names(methods, names),
                         .protocol = methods[0].protocol,
                         .measures = measures_to_compare(methods, requested_measures),
                         .classes = class_numbers(methods[0].classes)};
  const auto queries = static_cast<Eigen::Index>(methods[0].queries.size());
  aligned.values.assign(aligned.measures.size(), Eigen::MatrixXd(queries, static_cast<Eigen::Index>(methods.size())));
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const std::vector<std::size_t> rows = rows_of(methods[0], methods[m]);
    for (std::size_t k = 0; k < aligned.measures.size(); ++k) {
      aligned.values[k].col(static_cast<Eigen::Index>(m)) =
          methods[m].values.col(column_of(methods[m], aligned.measures[k]))(rows);
    }
  }
  return aligned;
}

}  // namespace shapegauge
