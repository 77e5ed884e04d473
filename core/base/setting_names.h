// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

/// Settings in messages. Libraries name them in backquotes: `index`, `offset=0.03`, `replace=true`. The command line
/// and Python spell them their own way when they show a message.

namespace shapegauge {

/// Function that formats a setting for an interface, such as "--offset 0.03". `value` is empty if the message gives
/// none.
using SettingSpelling = std::string (*)(std::string_view name, std::string_view value);

/// Replaces each setting that a message names in backquotes, such as `offset=0.03`, by `spelling` of its name and
/// value. Other text in backquotes stays, such as that within file names.
std::string spell_settings(std::string_view message, SettingSpelling spelling);

}  // namespace shapegauge
