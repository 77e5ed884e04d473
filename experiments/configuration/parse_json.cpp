#include "shapegauge/experiments/configuration/parse_json.h"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "shapegauge/core/error.h"
#include "shapegauge/core/printable.h"

namespace shapegauge {

namespace {

/// "line:column" of a byte of the text, both from 1.
std::string position_of(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t line_start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  return fmt::format("{}:{}", line, before.size() - line_start + 1);
}

/// The library's message without its identifier and position, which we give in our own form.
std::string plain_message(std::string message) {
  for (const std::string_view marker : {"] ", ": "}) {
    const std::size_t at = message.find(marker);
    if (at != std::string::npos) message.erase(0, at + marker.size());
  }
  return message;
}

/// Parser callback that refuses what the library alone would take: a second key of the same name, of which it would
/// keep the last silently, and values so deep that what walks through them recursively would run out of stack.
class Strictness {
 public:
  explicit Strictness(std::string source) : source_(std::move(source)) {}

  bool operator()(int depth, nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
    using Event = nlohmann::json::parse_event_t;
    if (depth > deepest) throw InputError(fmt::format("{}: values are nested more than {} deep", source_, deepest));
    if (event == Event::object_start) keys_.emplace_back();
    if (event == Event::object_end) keys_.pop_back();
    if (event == Event::key && !keys_.back().insert(parsed.get<std::string>()).second) {
      throw InputError(fmt::format("{}: the key {} stands twice in the same object; remove one", source_,
                                   printable(parsed.dump(), 60)));
    }
    return true;
  }

 private:
  static constexpr int deepest = 100;

  std::string source_;
  std::vector<std::set<std::string>> keys_;
};

}  // namespace

nlohmann::json parse_json(std::string_view text, const std::string& source) {
  try {
    return nlohmann::json::parse(text, Strictness(source));
  } catch (const nlohmann::json::parse_error& error) {
    throw InputError(fmt::format("{}:{}: not valid JSON: {}", source,
                                 position_of(text, error.byte > 0 ? error.byte - 1 : 0),
                                 printable(plain_message(error.what()), 200)));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: not valid JSON: {}", source, printable(plain_message(error.what()), 200)));
  }
}

std::optional<nlohmann::json> parse_if_json(std::string_view text, const std::string& source) {
  nlohmann::json parsed = nlohmann::json::parse(text, Strictness(source), /*allow_exceptions=*/false);
  if (parsed.is_discarded()) return std::nullopt;
  return std::optional<nlohmann::json>(std::move(parsed));
}

nlohmann::json read_json(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!std::filesystem::is_regular_file(path) || !file) {
    throw InputError(fmt::format("{}: no such file, or it cannot be read", path.string()));
  }
  std::ostringstream text;
  text << file.rdbuf();
  return parse_json(text.str(), path.string());
}

}  // namespace shapegauge
