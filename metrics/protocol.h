#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// Conventions under which a ranked list is judged (docs/reference/definitions.md#protocols).
///
/// psb, trec: the query is left out of its list. They differ in the measures and the precision-recall curve that are
/// theirs: those of the Princeton Shape Benchmark, and those of text retrieval.
/// paper (query included): the query stays in its list, at rank 1.
enum class Protocol { psb, paper, trec };

/// The name of a protocol in files and options: "psb", "paper" or "trec".
std::string name_of(Protocol protocol);

/// The protocol of that name, or nothing.
std::optional<Protocol> protocol_of(std::string_view name);

/// All names, for configurations and error messages.
std::vector<std::string> protocol_names();

/// What becomes of models at equal distance from the query. ranked_list() is the one place where it is decided.
///
/// index: in the order of the models, as psbTable has it. Where the classes lie one after the other in a matrix, that
/// is not neutral: early classes are preferred.
/// optimistic, pessimistic: relevant models first, or last: the best and the worst that any order can give.
/// expected: the mean of every measure over all orders of the tied, exactly.
enum class Ties { index, optimistic, pessimistic, expected };

/// The name in files and options: "index", "optimistic", "pessimistic" or "expected".
std::string name_of(Ties ties);

/// The value of that name, or nothing.
std::optional<Ties> ties_of(std::string_view name);

/// All names, for configurations and error messages.
std::vector<std::string> ties_names();

}  // namespace shapegauge
