// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/configuration/json_document.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "shapegauge/core/base/environment.h"

namespace shapegauge {

namespace {

/// Returns "line:column" of a byte of the text, both from 1.
std::string position_of(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t line_start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  return fmt::format("{}:{}", line, before.size() - line_start + 1);
}

/// Returns the library's message without its identifier and position.
std::string plain_message(std::string message) {
  for (const std::string_view marker : {"] ", ": "}) {
    const std::size_t at = message.find(marker);
    if (at != std::string::npos) message.erase(0, at + marker.size());
  }
  return message;
}

/// Parser callback that rejects repeated keys, of which the library would silently keep the last, and deep nesting,
/// which would exhaust the stack of recursive functions.
class Strictness {
 public:
  explicit Strictness(std::string source) : source_(std::move(source)) {}

  bool operator()(int depth, nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
    using Event = nlohmann::json::parse_event_t;
    if (depth > deepest) throw InputError(fmt::format("{}: values are nested deeper than {} levels", source_, deepest));
    if (event == Event::object_start) keys_.emplace_back();
    if (event == Event::object_end) keys_.pop_back();
    if (event == Event::key && !keys_.back().insert(parsed.get<std::string>()).second) {
      throw InputError(
          fmt::format("{}: the key {} is repeated in an object; remove one", source_, printable(parsed.dump(), 60)));
    }
    return true;
  }

 private:
  static constexpr int deepest = 100;

  std::string source_;
  std::vector<std::set<std::string>> keys_;
};

std::string value_of_variable(const std::string& name) {
  std::string value = environment_variable(name).value_or("");
  if (value.empty()) {
    throw InputError(fmt::format(
        "the environment variable {0} is not set; set it, for example with 'export {0}=/path/to/folder'", name));
  }
  return value;
}

[[noreturn]] void fail(const std::string& source, std::string_view message) {
  throw InputError(fmt::format("{}: {}", source, message));
}

/// Returns the key of a member, or the index of an array element.
std::string key_in(const nlohmann::json& parent, const nlohmann::json& element, std::string_view key) {
  return parent.is_array() ? std::to_string(&element - &parent.front()) : std::string(key);
}

nlohmann::json& element(nlohmann::json& array, std::string_view index, const std::string& source) {
  std::size_t position = 0;
  const auto [end, failure] = std::from_chars(index.data(), index.data() + index.size(), position);
  if (failure != std::errc() || end != index.data() + index.size() || position >= array.size()) {
    fail(source, fmt::format("\"{}\" is not an index of an array of {} values (counted from 0)", printable(index, 60),
                             array.size()));
  }
  return array[position];
}

/// Returns the element with that name of an array of objects.
nlohmann::json& named_element(nlohmann::json& parent, std::string_view name, const std::string& source) {
  std::vector<std::string> names;
  if (parent.is_array()) {
    for (nlohmann::json& one : parent) {
      if (!one.is_object() || !one.contains("name") || !one["name"].is_string()) continue;
      if (one["name"] == name) return one;
      names.push_back(one["name"]);
    }
  }
  fail(source, fmt::format("no element has the name \"{}\"{}", printable(name, 60),
                           names.empty() ? "" : fmt::format("; there are: {}", fmt::join(names, ", "))));
}

/// Step of a path: a key or an index or, in brackets, a name or an index.
struct OverrideStep {
  std::string_view text;
  bool bracketed = false;
};

/// Removes and returns the first step of the keys, with the dot after it.
OverrideStep take_step(std::string_view& keys, const std::string& source) {
  OverrideStep step;
  if (keys.starts_with('[')) {
    const bool quoted = keys.starts_with("[\"");
    const std::size_t begin = quoted ? 2 : 1;
    const std::size_t end = keys.find(quoted ? "\"]" : "]", begin);
    if (end == std::string_view::npos) fail(source, "a bracket is not closed");
    step = {keys.substr(begin, end - begin), true};
    keys.remove_prefix(end + begin);
    if (!keys.empty() && keys.front() != '.' && keys.front() != '[') fail(source, "expected a dot after the bracket");
  } else {
    step = {keys.substr(0, keys.find_first_of(".["))};
    keys.remove_prefix(step.text.size());
  }
  if (step.text.empty()) fail(source, "a key between the dots is empty");
  if (keys.starts_with('.')) {
    keys.remove_prefix(1);
    if (keys.empty()) fail(source, "a key between the dots is empty");
  }
  return step;
}

/// Returns the position of the first `=` outside brackets.
std::size_t position_of_equals(std::string_view assignment) {
  bool in_brackets = false;
  for (std::size_t i = 0; i < assignment.size(); ++i) {
    if (assignment[i] == '[') in_brackets = true;
    if (assignment[i] == ']') in_brackets = false;
    if (assignment[i] == '=' && !in_brackets) return i;
  }
  return std::string_view::npos;
}

bool is_index(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

nlohmann::json& child(nlohmann::json& parent, std::string_view key, const std::string& source) {
  if (parent.is_array()) return element(parent, key, source);
  if (parent.is_null()) parent = nlohmann::json::object();
  if (!parent.is_object()) {
    fail(source, fmt::format("no key \"{}\" in {}, which is a {}", printable(key, 60), printable(parent.dump(), 60),
                             parent.type_name()));
  }
  return parent[std::string(key)];
}

/// The library accepts any bytes in a string, but writes and compares UTF-8 only.
bool is_utf8(std::string_view text) {
  try {
    static_cast<void>(nlohmann::json(text).dump());
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

}  // namespace

std::string dotted(const nlohmann::json::json_pointer& pointer) {
  std::string text = pointer.to_string();
  if (!text.empty()) text.erase(0, 1);
  std::ranges::replace(text, '/', '.');
  return text;
}

nlohmann::json parse_json(std::string_view text, const std::string& source) {
  try {
    return nlohmann::json::parse(text, Strictness(source), /*allow_exceptions=*/true, /*ignore_comments=*/true);
  } catch (const nlohmann::json::parse_error& error) {
    throw InputError(fmt::format("{}:{}: not valid JSON: {}", source,
                                 position_of(text, error.byte > 0 ? error.byte - 1 : 0),
                                 printable(plain_message(error.what()), 200)));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: not valid JSON: {}", source, printable(plain_message(error.what()), 200)));
  }
}

std::optional<nlohmann::json> parse_if_json(std::string_view text, const std::string& source) {
  nlohmann::json parsed =
      nlohmann::json::parse(text, Strictness(source), /*allow_exceptions=*/false, /*ignore_comments=*/true);
  if (parsed.is_discarded()) return std::nullopt;
  return std::optional<nlohmann::json>(std::move(parsed));
}

nlohmann::json read_json(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::error_code failure;
  if (!std::filesystem::is_regular_file(path, failure) || !file) {
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
  const std::string expanded = at_key(key, [&] { return expand_variables(object.at(key).get<std::string>()); });
  return (folder / expanded).lexically_normal();
}

nlohmann::json::json_pointer apply_override(nlohmann::json& document, std::string_view assignment) {
  const std::string source = fmt::format("setting {}", printable(assignment, 100));
  if (!is_utf8(assignment)) fail(source, "the bytes are not UTF-8");
  const std::size_t equals = position_of_equals(assignment);
  if (equals == std::string_view::npos || equals == 0) {
    fail(source, "expected dotted.key=value, for example signatures.0.histogram.bins=40");
  }
  constexpr auto max_keys = 100;
  nlohmann::json* target = &document;
  nlohmann::json::json_pointer pointer;
  std::string_view keys = assignment.substr(0, equals);
  for (int depth = 0; !keys.empty(); ++depth) {
    if (depth >= max_keys) fail(source, fmt::format("more than {} keys", max_keys));
    const OverrideStep step = take_step(keys, source);
    const bool by_name = step.bracketed && !is_index(step.text);
    nlohmann::json& next = by_name ? named_element(*target, step.text, source) : child(*target, step.text, source);
    pointer /= key_in(*target, next, step.text);
    target = &next;
  }
  const std::string_view value = assignment.substr(equals + 1);
  *target = parse_if_json(value, source).value_or(nlohmann::json(value));
  return pointer;
}

}  // namespace shapegauge
