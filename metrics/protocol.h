#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// Conventions under which a ranked list is judged (the design, section 4).
enum class Protocol { psb, paper };

/// The name of a protocol in files and options: "psb" or "paper".
std::string name_of(Protocol protocol);

/// The protocol of that name, or nothing.
std::optional<Protocol> protocol_of(std::string_view name);

/// All names, for configurations and error messages.
std::vector<std::string> protocol_names();

}  // namespace shapegauge
