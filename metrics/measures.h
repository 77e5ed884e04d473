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

/// A measure: what it is called, what it means, and how it judges the answer to one query: by a number from 0 to 1,
/// larger is better, for every list with at least one relevant model. Exactly one of the two functions is there.
struct MeasureDefinition {
  std::string name;          ///< in tables and options; it ends in "@k" where there is a number of ranks to choose
  std::string title{};       ///< spelled out
  std::string definition{};  ///< h(i) is 1 where rank i is a hit, R the number of relevant models
  std::string source{};
  std::string caveat{};
  double (*value)(const RankedList&) = nullptr;
  double (*value_at)(const RankedList&, std::size_t k) = nullptr;
};

/// All measures: those of the library (measures.cpp), then those that were added. An entry has the one function that
/// its name asks for, and no blank, comma or @ in its name other than that of "@k".
Registry<MeasureDefinition>& measure_definitions();

/// A measure as tables show it, with its number of ranks where it has one: "FT", "P@10".
struct Measure {
  std::string name;
  const MeasureDefinition* definition = nullptr;
  std::size_t k = 0;

  [[nodiscard]] double value(const RankedList& list) const {
    return definition->value != nullptr ? definition->value(list) : definition->value_at(list, k);
  }
};

/// The measure of that name, "FT" or "P@10"; AP is another name of mAP. Throws ArgumentError with the known
/// names where there is none, and for a number of ranks that is not from 1 to 1000000000.
Measure measure_of(std::string_view name);

/// The measures of those names. Throws ArgumentError as measure_of, and where one is named twice.
std::vector<Measure> measures_of(std::span<const std::string> names);

/// The measures that a protocol is usually reported with, in the order of the tables' columns. psb, paper: NN, FT, ST,
/// E, DCG, mAP. trec: mAP, P@10, R@10, MRR, nDCG, R-prec.
std::vector<Measure> default_measures(Protocol protocol);

/// The measures of several protocols, each once, for tables that all of them share.
std::vector<Measure> default_measures(std::span<const Protocol> protocols);

}  // namespace shapegauge
