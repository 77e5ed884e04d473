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

/// Definition of a retrieval measure: a score from 0 to 1 of the ranked answer to one query, larger being better, for
/// lists with at least one rank and one relevant model. Exactly one of `value` and `value_at` is set.
struct MeasureDefinition {
  std::string name;  ///< name such as "FT"; ends in "@k" with a cutoff rank k, in "@N" if the cutoff is the list's end
  std::string title{};       ///< full name, such as "first tier"
  std::string definition{};  ///< formula in words; h(i) is 1 where rank i is a hit, R the number of relevant models
  std::string source{};      ///< publication or program that defines the measure
  std::string caveat{};      ///< pitfalls in the interpretation of scores
  double (*value)(const RankedList&) = nullptr;                    ///< score of a list, for measures without a cutoff
  double (*value_at)(const RankedList&, std::size_t k) = nullptr;  ///< score of a list at the cutoff rank k
  int version = 1;                                                 ///< cache version; increment when scores change
};

/// Returns the registry of measures: those of the library (measures.cpp), followed by those added. An entry sets
/// `value_at` if its name ends in "@k", otherwise `value`. Its name has no blank, comma or @ except in "@k" or "@N".
Registry<MeasureDefinition>& measure_definitions();

/// Measure with a cutoff, if it has one, as shown in tables: "FT", "P@10".
struct Measure {
  std::string name;                               ///< name in tables, with the cutoff
  const MeasureDefinition* definition = nullptr;  ///< definition of the measure; required
  std::size_t k = 0;                              ///< cutoff rank; 0 for a measure without one

  /// Returns the score of a ranked list; 0 for an empty list or without relevant models, whatever the measure.
  [[nodiscard]] double value(const RankedList& list) const {
    if (list.length == 0 || list.relevant == 0) return 0;
    return definition->value != nullptr ? definition->value(list) : definition->value_at(list, k);
  }
};

/// Returns the measure with this name, such as "FT" or "P@10"; "AP" is an alias of "mAP". Throws ArgumentError for an
/// unknown name (the message lists the known names), and for a cutoff that is not from 1 to 1000000000.
Measure measure_of(std::string_view name);

/// Returns the measures with these names. Throws ArgumentError as measure_of() does, and for a repeated name.
std::vector<Measure> measures_of(std::span<const std::string> names);

/// Returns the default measures of a protocol, in the order of the tables' columns. psb, paper: NN, FT, ST, E, DCG,
/// mAP. trec: mAP, P@10, R@10, MRR, nDCG, R-prec.
std::vector<Measure> default_measures(Protocol protocol);

/// Returns the union of the default measures of several protocols, for tables that these share.
std::vector<Measure> default_measures(std::span<const Protocol> protocols);

}  // namespace shapegauge
