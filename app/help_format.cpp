#include "app/help_format.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vector>

namespace shapegauge {

namespace {

std::vector<std::string> sorted_names(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) names.push_back(option->get_name());
  std::ranges::sort(names);
  return names;
}

}  // namespace

std::string HelpFormat::make_option_opts(const CLI::Option* option) const {
  if (option->get_type_size() == 0) return {};
  // CLI11 joins the type and the description of checks: "INT:INT in [1 - 1024]", "TEXT:{faces,vertices}".
  const std::string joined = option->get_type_name();
  const std::size_t colon = joined.find(':');
  std::string type = colon == std::string::npos ? joined : joined.substr(colon + 1);
  if (type == "NONNEGATIVE") type = joined.substr(0, colon) + " >= 0";
  return fmt::format(" {}{}", type, option->get_expected_max() == CLI::detail::expected_max_vector_size ? " ..." : "");
}

std::string HelpFormat::make_option_desc(const CLI::Option* option) const {
  std::vector<std::string> notes;
  if (!option->get_default_str().empty() && !option->get_required()) {
    notes.push_back("default: " + option->get_default_str());
  }
  if (option->get_required()) notes.emplace_back("required");
  if (!option->get_needs().empty()) {
    notes.push_back(fmt::format("needs {}", fmt::join(sorted_names(option->get_needs()), ", ")));
  }
  if (!option->get_excludes().empty()) {
    notes.push_back(fmt::format("not with {}", fmt::join(sorted_names(option->get_excludes()), ", ")));
  }
  std::string text = option->get_description();
  if (notes.empty()) return text;
  const bool continues = text.ends_with(')') && text.find("default: ") != std::string::npos;
  if (continues) text.pop_back();
  return fmt::format("{}{}{})", text, continues ? "; " : " (", fmt::join(notes, "; "));
}

void begin_option_group(CLI::App& command, const std::string& heading) { command.option_defaults()->group(heading); }

}  // namespace shapegauge
