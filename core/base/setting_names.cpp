// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/base/setting_names.h"

#include <algorithm>

namespace shapegauge {

namespace {

bool is_name(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; });
}

/// Returns true if the text around a setting separates it: the name of a file may have backquotes in it.
bool is_separate(std::string_view before, std::string_view after) {
  const bool begins = before.empty() || std::string_view(" (").find(before.back()) != std::string_view::npos;
  if (after.starts_with('.')) after.remove_prefix(1);
  return begins && (after.empty() || std::string_view(" ,;:)").find(after.front()) != std::string_view::npos);
}

}  // namespace

std::string spell_settings(std::string_view message, SettingSpelling spelling) {
  std::string spelled;
  while (true) {
    const std::size_t begin = message.find('`');
    const std::size_t end = begin == std::string_view::npos ? begin : message.find('`', begin + 1);
    if (end == std::string_view::npos) return spelled.append(message);
    const std::string_view setting = message.substr(begin + 1, end - begin - 1);
    const std::size_t equals = std::min(setting.find('='), setting.size());
    const std::string_view name = setting.substr(0, equals);
    spelled.append(message.substr(0, begin));
    if (is_name(name) && is_separate(spelled, message.substr(end + 1))) {
      spelled.append(spelling(name, setting.substr(std::min(equals + 1, setting.size()))));
      message.remove_prefix(end + 1);
    } else {
      spelled.append(message.substr(begin, end - begin));
      message.remove_prefix(end);
    }
  }
}

}  // namespace shapegauge
