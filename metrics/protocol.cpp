#include "shapegauge/metrics/protocol.h"

#include <array>

#include "shapegauge/metrics/named_values.h"

namespace shapegauge {
namespace {

constexpr std::array protocols = {
    Named<Protocol>{Protocol::psb, "psb"},
    Named<Protocol>{Protocol::paper, "paper"},
    Named<Protocol>{Protocol::trec, "trec"},
};

}  // namespace

std::string name_of(Protocol protocol) { return name_in<Protocol>(protocols, protocol); }

std::optional<Protocol> protocol_of(std::string_view name) { return value_in<Protocol>(protocols, name); }

std::vector<std::string> protocol_names() { return names_in<Protocol>(protocols); }

}  // namespace shapegauge
