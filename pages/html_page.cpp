// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/pages/html_page.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <openssl/evp.h>

#include "shapegauge/core/base/utf8.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/pages/palette.h"

namespace shapegauge {

namespace {

/// Replaces all occurrences of a word.
std::string replaced(std::string_view text, std::string_view word, std::string_view replacement) {
  std::string result;
  std::size_t begin = 0;
  for (std::size_t found = text.find(word); found != std::string_view::npos; found = text.find(word, begin)) {
    result.append(text, begin, found - begin).append(replacement);
    begin = found + word.size();
  }
  return result.append(text, begin);
}

}  // namespace

std::string base64(std::string_view bytes) {
  std::string text;
  // In pieces, as OpenSSL counts in int; a multiple of three bytes makes the pieces concatenable.
  constexpr std::size_t piece = 3 << 20;
  for (std::size_t begin = 0; begin < bytes.size(); begin += piece) {
    const std::string_view part = bytes.substr(begin, piece);
    std::vector<unsigned char> encoded(4 * (part.size() + 2) / 3 + 4);
    const std::vector<unsigned char> plain(part.begin(), part.end());
    const int length = EVP_EncodeBlock(encoded.data(), plain.data(), static_cast<int>(plain.size()));
    text.append(encoded.begin(), encoded.begin() + length);
  }
  return text;
}

double rounded_to_digits(double value, int digits) {
  return std::isfinite(value) ? std::stod(fmt::format("{:.{}g}", value, digits)) : value;
}

std::string html_text(std::string_view text) {
  return replaced(replaced(replaced(replaced(with_escaped_bytes(text), "&", "&amp;"), "<", "&lt;"), ">", "&gt;"), "\"",
                  "&quot;");
}

std::string script_data(const nlohmann::ordered_json& json) {
  const std::string text = json_text(json);
  return replaced(text, "<", "\\u003c");
}

std::string fill_placeholders(std::string_view page,
                              std::span<const std::pair<std::string_view, std::string_view>> marks_and_contents) {
  std::string result;
  for (const auto& [mark, content] : marks_and_contents) {
    const std::size_t found = page.find(mark);
    result.append(page, 0, found).append(content);
    page.remove_prefix(found + mark.size());
  }
  return result.append(page);
}

std::string scripted_page(const ScriptedPage& contents) {
  const std::string title = html_text(contents.title);
  const std::string style =
      fmt::format("{}{}{}", palette_style(), page_files::common_style(), fmt::join(contents.styles, ""));
  const std::string libraries = fmt::format("{}", fmt::join(contents.libraries, "\n"));
  const std::string data = script_data(contents.data);
  const std::array<std::pair<std::string_view, std::string_view>, 9> marks{{{"{{title}}", title},
                                                                            {"{{kind}}", contents.kind},
                                                                            {"{{style}}", style},
                                                                            {"{{kind}}", contents.kind},
                                                                            {"{{title}}", title},
                                                                            {"{{main}}", contents.main},
                                                                            {"{{libraries}}", libraries},
                                                                            {"{{data}}", data},
                                                                            {"{{script}}", contents.script}}};
  return fill_placeholders(page_files::frame(), marks);
}

}  // namespace shapegauge
