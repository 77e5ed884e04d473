// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/registry.h"
#include "shapegauge/metrics/protocol.h"
#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {

/// Measure of the ranked answer to one query: a number from 0 to 1, larger being better, for every list with at least
/// one rank and one relevant model. Exactly one of the two functions is set.
struct MeasureDefinition {
  std::string name;     ///< in tables and options; ends in "@k" if it has a cutoff, in "@N" if the list's end is one
  std::string title{};  ///< full name
  std::string definition{};  ///< h(i) is 1 where rank i is a hit, R the number of relevant models
  std::string source{};
  std::string caveat{};
  double (*value)(const RankedList&) = nullptr;
  double (*value_at)(const RankedList&, std::size_t k) = nullptr;
  int version = 1;  ///< cache version; increment when values change
};

/// Returns the registry of measures: those of the library (measures.cpp), followed by those added. An entry must have
/// the function that its name implies, and no blank, comma or @ in its name other than that of "@k" or "@N".
Registry<MeasureDefinition>& measure_definitions();

/// Measure as shown in tables, with its cutoff if any: "FT", "P@10".
struct Measure {
  std::string name;
  const MeasureDefinition* definition = nullptr;
  std::size_t k = 0;

  /// Returns the score of a list; 0 for an empty one or without relevant models, whatever the measure.
  [[nodiscard]] double value(const RankedList& list) const {
    if (list.length == 0 || list.relevant == 0) return 0;
    return definition->value != nullptr ? definition->value(list) : definition->value_at(list, k);
  }
};

/// Returns the measure of that name, "FT" or "P@10"; AP is an alias of mAP. Throws ArgumentError for an unknown name,
/// with the known names, and for a cutoff that is not from 1 to 1000000000.
Measure measure_of(std::string_view name);

/// Returns the measures of those names. Throws ArgumentError as measure_of() does, and for a repeated name.
std::vector<Measure> measures_of(std::span<const std::string> names);

/// Returns the default measures of a protocol, in the order of the tables' columns. psb, paper: NN, FT, ST, E, DCG,
/// mAP. trec: mAP, P@10, R@10, MRR, nDCG, R-prec.
std::vector<Measure> default_measures(Protocol protocol);

/// Returns the union of the default measures of several protocols, for shared tables.
std::vector<Measure> default_measures(std::span<const Protocol> protocols);

}  // namespace shapegauge
