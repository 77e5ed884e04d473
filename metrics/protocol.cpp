#include "shapegauge/metrics/protocol.h"

namespace shapegauge {

std::string name_of(Protocol protocol) { return std::string(word_of(protocol)); }

std::optional<Protocol> protocol_of(std::string_view name) { return value_of_word<Protocol>(name); }

std::vector<std::string> protocol_names() { return list_of_words<Protocol>(); }

std::string name_of(Ties ties) { return std::string(word_of(ties)); }

std::optional<Ties> ties_of(std::string_view name) { return value_of_word<Ties>(name); }

std::vector<std::string> ties_names() { return list_of_words<Ties>(); }

}  // namespace shapegauge
