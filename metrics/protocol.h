// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "shapegauge/core/base/words.h"

namespace shapegauge {

/// Evaluation protocol of ranked lists (docs/reference/definitions.md#protocols).
/// - psb, trec: the query is excluded from its list. They differ in their default measures and precision-recall curves:
///   those of the Princeton Shape Benchmark, and those of text retrieval.
/// - paper: the query stays in its list, at rank 1.
enum class Protocol { psb, paper, trec };
template <>
inline constexpr std::array<std::string_view, 3> words_of<Protocol>{"psb", "paper", "trec"};

/// Handling of models at equal distance from the query; implemented by ranked_list().
/// - index: in the order of the models, as psbTable does. This favours early classes if the matrix is sorted by class.
/// - optimistic, pessimistic: relevant models first, or last: the best and worst case of any order.
/// - expected: the exact mean of every measure over all orders of the tied models.
enum class Ties { index, optimistic, pessimistic, expected };
template <>
inline constexpr std::array<std::string_view, 4> words_of<Ties>{"index", "optimistic", "pessimistic", "expected"};

}  // namespace shapegauge
