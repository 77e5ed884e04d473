#include "shapegauge/core/base/setting_names.h"

#include <algorithm>

namespace shapegauge {

namespace {

bool is_name(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; });
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
    if (is_name(name)) {
      spelled.append(message.substr(0, begin))
          .append(spelling(name, setting.substr(std::min(equals + 1, setting.size()))));
      message.remove_prefix(end + 1);
    } else {
      spelled.append(message.substr(0, end));
      message.remove_prefix(end);
    }
  }
}

}  // namespace shapegauge
