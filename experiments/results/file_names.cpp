#include "shapegauge/experiments/results/file_names.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <set>

#include "shapegauge/experiments/text/lower_case.h"

namespace shapegauge {

namespace {

bool is_safe(char c) {
  return (std::isalnum(static_cast<unsigned char>(c)) != 0 && (c & '\x80') == 0) || c == '-' || c == '.';
}

}  // namespace

std::string file_safe_name(std::string_view name) {
  std::string safe;
  for (const char c : name) {
    if (is_safe(c)) {
      safe += c;
    } else if (!safe.ends_with('_')) {
      safe += '_';
    }
  }
  safe.resize(std::min<std::size_t>(safe.size(), 100));
  safe.erase(0, safe.find_first_not_of("_."));
  safe.erase(safe.find_last_not_of("_.") + 1);
  return safe.empty() ? "unnamed" : safe;
}

std::vector<std::string> file_safe_names(std::span<const std::string> names) {
  std::vector<std::string> safe_names;
  std::set<std::string> taken;
  for (const std::string& name : names) {
    const std::string safe = file_safe_name(name);
    std::string candidate = safe;
    for (int i = 2; !taken.insert(lower_case(candidate)).second; ++i) candidate = fmt::format("{}_{}", safe, i);
    safe_names.push_back(candidate);
  }
  return safe_names;
}

}  // namespace shapegauge
