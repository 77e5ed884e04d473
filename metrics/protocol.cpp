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

}  // namespace

std::string name_of(Protocol protocol) { return name_in<Protocol>(protocols, protocol); }

std::optional<Protocol> protocol_of(std::string_view name) { return value_in<Protocol>(protocols, name); }

std::vector<std::string> protocol_names() { return names_in<Protocol>(protocols); }

std::string name_of(Ties ties) { return std::string(word_of(ties)); }

std::optional<Ties> ties_of(std::string_view name) { return value_of_word<Ties>(name); }

std::vector<std::string> ties_names() { return list_of_words<Ties>(); }

}  // namespace shapegauge
