#include "shapegauge/metrics/protocol.h"

#include <array>

#include "shapegauge/core/base/names.h"

namespace shapegauge {

namespace {

constexpr std::array protocols = {
    Named<Protocol>{Protocol::psb, "psb"},
    Named<Protocol>{Protocol::paper, "paper"},
    Named<Protocol>{Protocol::trec, "trec"},
};

constexpr std::array all_ties = {
    Named<Ties>{Ties::index, "index"},
    Named<Ties>{Ties::optimistic, "optimistic"},
    Named<Ties>{Ties::pessimistic, "pessimistic"},
    Named<Ties>{Ties::expected, "expected"},
};

}  // namespace

std::string name_of(Protocol protocol) { return name_in<Protocol>(protocols, protocol); }

std::optional<Protocol> protocol_of(std::string_view name) { return value_in<Protocol>(protocols, name); }

std::vector<std::string> protocol_names() { return names_in<Protocol>(protocols); }

std::string name_of(Ties ties) { return name_in<Ties>(all_ties, ties); }

std::optional<Ties> ties_of(std::string_view name) { return value_in<Ties>(all_ties, name); }

std::vector<std::string> ties_names() { return names_in<Ties>(all_ties); }

}  // namespace shapegauge
