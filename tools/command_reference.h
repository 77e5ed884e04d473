// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace shapegauge {

/// Returns the text of docs/reference/commands.md: the commands of a program with their arguments, options and notes,
/// in Markdown.
std::string command_reference(const CLI::App& program);

}  // namespace shapegauge
