#include "shapegauge/experiments/configuration/json_document.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"

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

std::string value_of_variable(const std::string& name) {
  const char* value = std::getenv(name.c_str());
  if (value == nullptr || *value == '\0') {
    throw InputError(fmt::format(
        "the environment variable {0} is not set; set it, for example with 'export {0}=/path/to/folder'", name));
  }
  return value;
}

[[noreturn]] void fail(std::string_view assignment, std::string_view message) {
  throw InputError(fmt::format("--set {}: {}", printable(assignment, 100), message));
}

nlohmann::json& element(nlohmann::json& array, std::string_view index, std::string_view assignment) {
  std::size_t position = 0;
  const auto [end, failure] = std::from_chars(index.data(), index.data() + index.size(), position);
  if (failure != std::errc() || end != index.data() + index.size() || position >= array.size()) {
    fail(assignment, fmt::format("\"{}\" is not an index of an array of {} values (the first is 0)",
                                 printable(index, 60), array.size()));
  }
  return array[position];
}

nlohmann::json& child(nlohmann::json& parent, std::string_view key, std::string_view assignment) {
  if (parent.is_array()) return element(parent, key, assignment);
  if (parent.is_null()) parent = nlohmann::json::object();
  if (!parent.is_object()) {
    fail(assignment, fmt::format("there is no \"{}\" in {}, which is a {}", printable(key, 60),
                                 printable(parent.dump(), 60), parent.type_name()));
  }
  return parent[std::string(key)];
}

/// The library takes any bytes for a string, but writes and compares UTF-8 only.
bool is_utf8(std::string_view text) {
  try {
    static_cast<void>(nlohmann::json(text).dump());
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

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

std::string expand_variables(std::string_view text) {
  std::string expanded;
  for (std::size_t begin = text.find("${"); begin != std::string_view::npos; begin = text.find("${")) {
    const std::size_t end = text.find('}', begin);
    if (end == std::string_view::npos) throw InputError(fmt::format("\"{}\" has a ${{ without its }}", text));
    expanded += text.substr(0, begin);
    expanded += value_of_variable(std::string(text.substr(begin + 2, end - begin - 2)));
    text.remove_prefix(end + 1);
  }
  return expanded.append(text);
}

std::filesystem::path path_value(const nlohmann::json& object, const std::string& key,
                                 const std::filesystem::path& folder) {
  const std::string expanded = at(key, [&] { return expand_variables(object.at(key).get<std::string>()); });
  return (folder / expanded).lexically_normal();
}

void apply_override(nlohmann::json& document, std::string_view assignment) {
  if (!is_utf8(assignment)) fail(assignment, "the bytes are not UTF-8");
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos || equals == 0) {
    fail(assignment, "expected dotted.key=value, for example signatures.0.histogram.bins=40");
  }
  constexpr auto most_keys = 100;
  if (std::ranges::count(assignment.substr(0, equals), '.') >= most_keys) {
    fail(assignment, fmt::format("more than {} keys", most_keys));
  }
  nlohmann::json* target = &document;
  std::string_view keys = assignment.substr(0, equals);
  while (true) {
    const std::size_t dot = keys.find('.');
    const std::string_view key = keys.substr(0, dot);
    if (key.empty()) fail(assignment, "a key between the dots is empty");
    target = &child(*target, key, assignment);
    if (dot == std::string_view::npos) break;
    keys.remove_prefix(dot + 1);
  }
  const std::string_view value = assignment.substr(equals + 1);
  *target = parse_if_json(value, "--set " + printable(assignment, 100)).value_or(nlohmann::json(value));
}

}  // namespace shapegauge
