#include "shapegauge/metrics/protocol.h"

#include <algorithm>
#include <array>

namespace shapegauge {
namespace {

struct NamedProtocol {
  Protocol protocol;
  std::string_view name;
};

constexpr std::array protocols = {
    NamedProtocol{Protocol::psb, "psb"},
    NamedProtocol{Protocol::paper, "paper"},
};

}  // namespace

std::string name_of(Protocol protocol) {
  return std::string(std::ranges::find(protocols, protocol, &NamedProtocol::protocol)->name);
}

std::optional<Protocol> protocol_of(std::string_view name) {
  const auto* const found = std::ranges::find(protocols, name, &NamedProtocol::name);
  if (found == protocols.end()) return std::nullopt;
  return found->protocol;
}

std::vector<std::string> protocol_names() {
  std::vector<std::string> names;
  names.reserve(protocols.size());
  for (const NamedProtocol& named : protocols) names.emplace_back(named.name);
  return names;
}

}  // namespace shapegauge
