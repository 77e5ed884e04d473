#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/words.h"

namespace shapegauge {

/// Evaluation protocol of ranked lists (docs/reference/definitions.md#protocols).
/// - psb, trec: the query is excluded from its list. They differ in their default measures and precision-recall curves:
///   those of the Princeton Shape Benchmark, and those of text retrieval.
/// - paper: the query stays in its list, at rank 1.
enum class Protocol { psb, paper, trec };
template <>
inline constexpr std::array<std::string_view, 3> words_of<Protocol>{"psb", "paper", "trec"};

/// Returns the name of a protocol in files and options: "psb", "paper" or "trec".
std::string name_of(Protocol protocol);

/// Returns the protocol of that name, if any.
std::optional<Protocol> protocol_of(std::string_view name);

/// Returns all names, for configurations and error messages.
std::vector<std::string> protocol_names();

/// Handling of models at equal distance from the query; implemented by ranked_list().
/// - index: in the order of the models, as psbTable does. This favours early classes if the matrix is sorted by class.
/// - optimistic, pessimistic: relevant models first, or last: the best and worst case of any order.
/// - expected: the exact mean of every measure over all orders of the tied models.
enum class Ties { index, optimistic, pessimistic, expected };
template <>
inline constexpr std::array<std::string_view, 4> words_of<Ties>{"index", "optimistic", "pessimistic", "expected"};

/// Returns the name in files and options: "index", "optimistic", "pessimistic" or "expected".
std::string name_of(Ties ties);

/// Returns the value of that name, if any.
std::optional<Ties> ties_of(std::string_view name);

/// Returns all names, for configurations and error messages.
std::vector<std::string> ties_names();

}  // namespace shapegauge
