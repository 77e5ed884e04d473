// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/parameter_options.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>

#include "app/terminal.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/nearest_word.h"

namespace shapegauge {

std::string without_full_stop(std::string_view sentence) {
  if (sentence.ends_with('.')) sentence.remove_suffix(1);
  return std::string(sentence);
}

namespace {

std::string type_name_of(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::number:
      return "NUMBER";
    case ParameterKind::integer:
      return "INT";
    case ParameterKind::integers:
      return "INTS";
    case ParameterKind::boolean:
    case ParameterKind::choice:
      break;
  }
  return "WORD";
}

}  // namespace

CLI::Validator one_of(std::vector<std::string> words) {
  std::string description = fmt::format("{{{}}}", fmt::join(words, ","));
  return {[words = std::move(words)](const std::string& word) {
            return std::ranges::count(words, word) > 0 ? "" : unknown_word_message("choice", word, words);
          },
          std::move(description)};
}

std::string parameter_help_text(const Parameter& parameter, bool with_default) {
  if (parameter.kind == ParameterKind::boolean) return without_full_stop(parameter.description);
  with_default &= !parameter.required();
  const std::string remark = with_default ? "; default: " + to_string(parameter.default_value) : "";
  // The option's type says that the value is a number.
  const std::string legal = legal_values(parameter);
  std::string_view values = legal;
  for (const std::string_view words : {"a ", "whole ", "number ", "from "}) {
    if (values.starts_with(words)) values.remove_prefix(words.size());
  }
  return fmt::format("{} ({}{})", without_full_stop(parameter.description), values, remark);
}

CLI::Option* add_parameter_option(CLI::App& command, const Parameter& parameter, ParameterText& target,
                                  std::string names, std::string meaning) {
  if (names.empty()) names = option_name(parameter.name);
  if (meaning.empty()) meaning = parameter_help_text(parameter);
  const auto fill_in = [&target] { target.text = "true"; };
  CLI::Option* const option = parameter.kind == ParameterKind::boolean
                                  ? command.add_flag_callback(names, fill_in, meaning)
                                  : command.add_option(names, target.text, meaning);
  if (parameter.kind != ParameterKind::boolean) {
    option->type_name(type_name_of(parameter.kind));
    option->each([name = option->get_name(), parameter](const std::string& text) {
      if (text.empty()) throw InputError(fmt::format("{} is empty; it must be {}", name, legal_values(parameter)));
    });
  }
  target.option = option->get_name();
  return option;
}

ParameterValues parameter_values(std::span<const Parameter> parameters, const ParameterTexts& texts,
                                 std::string_view subject) {
  ParameterValues values(parameters);
  for (const auto& [name, value] : texts) {
    if (value.text.empty()) continue;
    const auto parameter = std::ranges::find(parameters, name, &Parameter::name);
    if (parameter == parameters.end())
      throw InputError(fmt::format("{} does not apply to {}; omit it", value.option, subject));
    Parameter of_option = *parameter;
    of_option.name = value.option;
    values.set(name, parse_value(of_option, value.text));
  }
  return values;
}

}  // namespace shapegauge
