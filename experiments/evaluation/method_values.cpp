#include "shapegauge/experiments/evaluation/method_values.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <unordered_map>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/experiments/files/csv.h"
#include "shapegauge/experiments/files/model_ids.h"

namespace shapegauge {

namespace {

constexpr std::size_t first_measure = 4;

void check_header(const std::vector<CsvRow>& rows, const std::string& source) {
  const std::vector<std::string> words = {"method", "protocol", "id", "class"};
  const bool known = !rows.empty() && rows[0].cells.size() > first_measure &&
                     std::equal(words.begin(), words.end(), rows[0].cells.begin());
  if (known) return;
  throw InputError(
      fmt::format("{}: expected figures of each query, a table that begins with method,protocol,id,class; it is what "
                  "'run' and 'evaluate --per-query' write",
                  source));
}

Eigen::RowVectorXd figures_of(const CsvRow& row, std::size_t measures, const std::string& source) {
  if (row.cells.size() != first_measure + measures) {
    throw InputError(fmt::format("{}:{}: {} cells where the first row has {}", source, row.line, row.cells.size(),
                                 first_measure + measures));
  }
  Eigen::RowVectorXd figures(static_cast<Eigen::Index>(measures));
  for (std::size_t i = 0; i < measures; ++i) {
    const std::string& cell = row.cells[first_measure + i];
    const auto percent = parse_number(cell);
    if (!percent || !(*percent >= 0 && *percent <= 100)) {
      throw InputError(fmt::format("{}:{}: {} is no number from 0 to 100", source, row.line, quoted_word(cell)));
    }
    figures[static_cast<Eigen::Index>(i)] = *percent / 100;
  }
  return figures;
}

using Places = std::unordered_map<std::string, std::size_t>;

Places places_of(const MethodValues& method) {
  Places places;
  for (const std::string& query : method.queries) {
    if (places.emplace(canonical_model_id(query), places.size()).second) continue;
    throw InputError(fmt::format("{}: the query {} occurs twice for {}", method.source, quoted_word(query),
                                 quoted_word(method.method)));
  }
  return places;
}

void check_protocols(std::span<const MethodValues> methods) {
  for (const MethodValues& method : methods) {
    if (method.protocol == methods[0].protocol) continue;
    throw InputError(fmt::format("{} is judged under {} but {} under {}; figures of two protocols cannot be compared",
                                 quoted_word(methods[0].method), methods[0].protocol, quoted_word(method.method),
                                 method.protocol));
  }
}

std::vector<std::string> unique_names(std::span<const MethodValues> methods) {
  std::map<std::string, int> uses;
  for (const MethodValues& method : methods) ++uses[method.method];
  std::vector<std::string> names;
  for (const MethodValues& method : methods) {
    const std::filesystem::path file(method.source);
    const std::string place =
        file.filename() == "per_query.csv" ? file.parent_path().filename().string() : file.stem().string();
    names.push_back(uses[method.method] == 1 ? method.method : fmt::format("{}: {}", place, method.method));
  }
  return names;
}

std::vector<std::string> measures_to_compare(std::span<const MethodValues> methods,
                                             std::span<const std::string> wanted) {
  if (!wanted.empty()) return {wanted.begin(), wanted.end()};
  std::vector<std::string> common = methods[0].measures;
  std::erase_if(common, [&](const std::string& measure) {
    return !std::ranges::all_of(methods, [&](const MethodValues& method) {
      return std::ranges::find(method.measures, measure) != method.measures.end();
    });
  });
  if (common.empty()) throw InputError("the methods have no measure in common");
  return common;
}

Eigen::Index column_of(const MethodValues& method, const std::string& measure) {
  const auto found = std::ranges::find(method.measures, measure);
  if (found != method.measures.end()) return found - method.measures.begin();
  throw InputError(fmt::format("{}: there is no measure {} for {}; there are {}", method.source, quoted_word(measure),
                               quoted_word(method.method), fmt::join(method.measures, ", ")));
}

// The row of each query of `first` in `method`; both have the same queries, in the same classes.
std::vector<std::size_t> rows_of(const MethodValues& first, const MethodValues& method) {
  const Places places = places_of(method);
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < first.queries.size(); ++i) {
    const auto found = places.find(canonical_model_id(first.queries[i]));
    if (found == places.end()) {
      throw InputError(fmt::format(
          "{}: {} has no query {}, which {} has; only figures of the same queries can be compared", method.source,
          quoted_word(method.method), quoted_word(first.queries[i]), quoted_word(first.method)));
    }
    if (method.classes[found->second] != first.classes[i]) {
      throw InputError(fmt::format("{}: the query {} is of class {} for {} and of {} for {}", method.source,
                                   quoted_word(first.queries[i]), quoted_word(method.classes[found->second]),
                                   quoted_word(method.method), quoted_word(first.classes[i]),
                                   quoted_word(first.method)));
    }
    rows.push_back(found->second);
  }
  if (places.size() == first.queries.size()) return rows;
  const Places known = places_of(first);
  const auto more = std::ranges::find_if(
      method.queries, [&](const std::string& query) { return !known.contains(canonical_model_id(query)); });
  throw InputError(
      fmt::format("{}: {} has the query {}, which {} has not; only figures of the same queries can be compared",
                  method.source, quoted_word(method.method), quoted_word(*more), quoted_word(first.method)));
}

std::vector<int> numbered(const std::vector<std::string>& classes) {
  std::unordered_map<std::string, int> numbers;
  std::vector<int> labels;
  labels.reserve(classes.size());
  for (const std::string& name : classes) {
    labels.push_back(numbers.emplace(name, static_cast<int>(numbers.size())).first->second);
  }
  return labels;
}

}  // namespace

std::vector<MethodValues> read_method_values(const std::filesystem::path& path) {
  const std::string source = path.string();
  const std::vector<CsvRow> rows = parse_csv(read_file_bytes(path), source);
  check_header(rows, source);
  const std::vector<std::string> measures(rows[0].cells.begin() + first_measure, rows[0].cells.end());
  std::vector<MethodValues> methods;
  std::vector<std::vector<Eigen::RowVectorXd>> figures;
  std::map<std::pair<std::string, std::string>, std::size_t> places;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const Eigen::RowVectorXd of_query = figures_of(rows[i], measures.size(), source);
    const std::vector<std::string>& cells = rows[i].cells;
    const auto [place, is_new] = places.emplace(std::pair(cells[0], cells[1]), methods.size());
    if (is_new) {
      methods.push_back({.method = cells[0],
                         .source = source,
                         .protocol = cells[1],
                         .measures = measures,
                         .queries = {},
                         .classes = {},
                         .values = {}});
      figures.emplace_back();
    }
    methods[place->second].queries.push_back(cells[2]);
    methods[place->second].classes.push_back(cells[3]);
    figures[place->second].push_back(of_query);
  }
  for (std::size_t m = 0; m < methods.size(); ++m) {
    methods[m].values.resize(static_cast<Eigen::Index>(figures[m].size()), static_cast<Eigen::Index>(measures.size()));
    for (std::size_t i = 0; i < figures[m].size(); ++i)
      methods[m].values.row(static_cast<Eigen::Index>(i)) = figures[m][i];
    places_of(methods[m]);
  }
  return methods;
}

MethodValues method_values(const std::string& method, const std::string& source, const EvaluationInput& input,
                           const Evaluation& evaluation) {
  MethodValues values{.method = method,
                      .source = source,
                      .protocol = name_of(evaluation.protocol),
                      .measures = evaluation.measures,
                      .queries = {},
                      .classes = {},
                      .values = evaluation.per_query};
  for (std::size_t i = 0; i < evaluation.queries.size(); ++i) {
    values.queries.push_back(input.query_ids[static_cast<std::size_t>(evaluation.queries[i])]);
    values.classes.push_back(input.class_names[static_cast<std::size_t>(evaluation.query_classes[i])]);
  }
  return values;
}

AlignedMethods align_methods(std::span<const MethodValues> methods, std::span<const std::string> wanted_measures) {
  if (methods.size() < 2) throw InputError("there is one method only; a comparison needs two or more");
  check_protocols(methods);
  AlignedMethods aligned{.methods = unique_names(methods),
                         .protocol = methods[0].protocol,
                         .measures = measures_to_compare(methods, wanted_measures),
                         .classes = numbered(methods[0].classes),
                         .values = {}};
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
