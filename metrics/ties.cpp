#include "shapegauge/metrics/ties.h"

#include <array>

#include "shapegauge/metrics/named_values.h"

namespace shapegauge {
namespace {

constexpr std::array all_ties = {
    Named<Ties>{Ties::index, "index"},
    Named<Ties>{Ties::optimistic, "optimistic"},
    Named<Ties>{Ties::pessimistic, "pessimistic"},
    Named<Ties>{Ties::expected, "expected"},
};

}  // namespace

std::string name_of(Ties ties) { return name_in<Ties>(all_ties, ties); }

std::optional<Ties> ties_of(std::string_view name) { return value_in<Ties>(all_ties, name); }

std::vector<std::string> ties_names() { return names_in<Ties>(all_ties); }

}  // namespace shapegauge
