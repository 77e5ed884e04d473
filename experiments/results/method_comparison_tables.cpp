// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/results/method_comparison_tables.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>

#include "shapegauge/core/base/text.h"

namespace shapegauge {

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr std::size_t letters = 26;

std::string mark_of(std::size_t method, std::size_t methods) {
  return methods <= letters ? std::string(1, static_cast<char>('a' + method)) : fmt::format("{}", method + 1);
}

std::string signed_score(double fraction, const ScoreStyle& style) {
  const std::string text = score_text(fraction, style);
  return text.starts_with('-') ? text : "+" + text;
}

std::string p_value(double p, bool exact) {
  constexpr double smallest = 0.0001;  // with the four digits of a table
  if (exact) return fmt::format("{}", p);
  return p < smallest ? "<0.0001" : fmt::format("{:.4f}", p);
}

// Returns the marks of the methods that the method is significantly better than, with a star if that is significant for
// classes like these.
std::string marks_behind(std::size_t method, const MethodComparison& comparison, double alpha) {
  const auto methods = static_cast<std::size_t>(comparison.averages.size());
  std::map<std::size_t, bool> worse;
  for (const PairDifference& pair : comparison.pairs) {
    if (std::min(pair.p_holm, pair.p_classes) > alpha) continue;
    const bool of_classes = pair.p_classes <= alpha;
    if (pair.first == method && pair.difference > 0) worse.emplace(pair.second, of_classes);
    if (pair.second == method && pair.difference < 0) worse.emplace(pair.first, of_classes);
  }
  std::string marks;
  for (const auto& [other, of_classes] : worse) {
    if (methods > letters && !marks.empty()) marks += ',';
    marks += mark_of(other, methods) + (of_classes ? "*" : "");
  }
  return marks;
}

OrderedJson json_number(double number) { return std::isfinite(number) ? OrderedJson(number) : OrderedJson(nullptr); }

OrderedJson pair_json(const PairDifference& pair, const AlignedMethods& methods) {
  return {{"first", methods.methods[pair.first]},
          {"second", methods.methods[pair.second]},
          {"difference", pair.difference},
          {"interval", {pair.interval.low, pair.interval.high}},
          {"p", pair.p},
          {"p_holm", pair.p_holm},
          {"p_tukey", pair.p_tukey},
          {"p_classes", pair.p_classes},
          {"effect_size", json_number(pair.effect_size)},
          {"wins", pair.queries.wins},
          {"ties", pair.queries.ties},
          {"losses", pair.queries.losses}};
}

// Warns if the number of classes makes a significant `p_classes` impossible, or possible for huge effects only.
std::optional<std::string> few_classes_warning(const MethodComparison& comparison, double alpha) {
  constexpr double huge_effect = 2;
  const double effect = min_class_effect(static_cast<std::size_t>(comparison.classes), comparison.pairs.size(), alpha);
  if (effect <= huge_effect) return std::nullopt;
  if (comparison.classes < 2)
    return "with one class no difference can be significant for classes like these (p_classes)";
  return fmt::format(
      "with {} and {} a difference is significant for classes like these (p_classes <= {:.4g}) only if its mean over "
      "classes is {:.3g} times its standard deviation; use more classes, or fewer pairs (`reference`)",
      count_text(comparison.classes, "class", "classes"), count_text(std::ssize(comparison.pairs), "pair", "pairs"),
      alpha, effect);
}

}  // namespace

TextTable comparison_summary(const AlignedMethods& methods, std::span<const MethodComparison> comparisons,
                             const ComparisonOptions& options, const ScoreStyle& style) {
  TextTable table{.header = {"", "method"}, .rows = {}, .text_columns = 2};
  table.header.insert(table.header.end(), methods.measures.begin(), methods.measures.end());
  const double alpha = significance_level(options.confidence);
  for (std::size_t method = 0; method < methods.methods.size(); ++method) {
    table.rows.push_back({mark_of(method, methods.methods.size()), methods.methods[method]});
    for (std::size_t k = 0; k < comparisons.size(); ++k) {
      const ConfidenceInterval& interval = comparisons[k].intervals[method];
      table.rows.back().push_back(
          fmt::format("{} [{}, {}]", score_text(comparisons[k].averages[static_cast<Eigen::Index>(method)], style),
                      score_text(interval.low, style), score_text(interval.high, style)));
      const std::string marks = marks_behind(method, comparisons[k], alpha);
      if (!marks.empty()) table.emphases.push_back({.row = method, .column = 2 + k, .bold = false, .mark = marks});
    }
  }
  embolden_best(table, table.text_columns);
  return table;
}

TextTable pairs_table(const AlignedMethods& methods, std::span<const MethodComparison> comparisons,
                      const ScoreStyle& style, bool exact) {
  TextTable table{.header = {"measure", "first", "second", "difference", "low", "high", "p", "p_holm", "p_tukey",
                             "p_classes", "effect_size", "wins", "ties", "losses"},
                  .text_columns = 3};
  for (std::size_t k = 0; k < comparisons.size(); ++k) {
    for (const PairDifference& pair : comparisons[k].pairs) {
      table.rows.push_back({methods.measures[k], methods.methods[pair.first], methods.methods[pair.second],
                            signed_score(pair.difference, style), signed_score(pair.interval.low, style),
                            signed_score(pair.interval.high, style), p_value(pair.p, exact),
                            p_value(pair.p_holm, exact), p_value(pair.p_tukey, exact), p_value(pair.p_classes, exact),
                            decimal_text(pair.effect_size, 2), fmt::format("{}", pair.queries.wins),
                            fmt::format("{}", pair.queries.ties), fmt::format("{}", pair.queries.losses)});
    }
  }
  return table;
}

OrderedJson comparison_json(const AlignedMethods& methods, std::span<const MethodComparison> comparisons,
                            const ComparisonOptions& options) {
  OrderedJson measures = OrderedJson::object();
  for (std::size_t k = 0; k < comparisons.size(); ++k) {
    OrderedJson averages = OrderedJson::array();
    for (std::size_t method = 0; method < methods.methods.size(); ++method) {
      const ConfidenceInterval& interval = comparisons[k].intervals[method];
      averages.push_back({{"method", methods.methods[method]},
                          {"average", comparisons[k].averages[static_cast<Eigen::Index>(method)]},
                          {"interval", {interval.low, interval.high}}});
    }
    OrderedJson pairs = OrderedJson::array();
    for (const PairDifference& pair : comparisons[k].pairs) pairs.push_back(pair_json(pair, methods));
    measures[methods.measures[k]] = {{"methods", std::move(averages)}, {"pairs", std::move(pairs)}};
  }
  return {{"protocol", methods.protocol},
          {"average", name_of(options.average)},
          {"test", name_of(options.test)},
          {"blocks", name_of(options.blocks)},
          {"units", comparisons.empty() ? 0 : comparisons[0].units},
          {"smallest_p", comparisons.empty() ? 0 : min_attainable_p_value(options, comparisons[0].units)},
          {"queries", methods.classes.size()},
          {"confidence", options.confidence},
          {"resamples", options.resampling.resamples},
          {"seed", options.resampling.seed},
          {"measures", std::move(measures)}};
}

std::optional<std::string> few_units_warning(const MethodComparison& comparison, const ComparisonOptions& options) {
  const double smallest = min_attainable_p_value(options, comparison.units);
  const auto pairs = static_cast<double>(comparison.pairs.size());
  const double alpha = significance_level(options.confidence);
  if (pairs * smallest <= alpha) return few_classes_warning(comparison, alpha);
  const bool few_resamples = smallest * (1.0 + options.resampling.resamples) <= 1;
  const std::string more_blocks =
      options.blocks == ResamplingUnit::classes ? " or `blocks=queries` (a claim about these classes only)" : "";
  const std::string advice =
      few_resamples ? fmt::format("use more `resamples` than {}", options.resampling.resamples)
                    : fmt::format("use more {}, `test=t` (which assumes normally distributed differences){}",
                                  name_of(options.blocks), more_blocks);
  return fmt::format(
      "with {} {} no p-value of the {} test can be below {:.4g} ({:.4g} after Holm's correction for {}){}; no "
      "difference can be significant at {:.4g}; {}",
      comparison.units, name_of(options.blocks), name_of(options.test), smallest, std::min(1.0, pairs * smallest),
      count_text(std::ssize(comparison.pairs), "pair", "pairs"),
      few_resamples ? "" : fmt::format(", except by the error of {} resamples", options.resampling.resamples), alpha,
      advice);
}

}  // namespace shapegauge
