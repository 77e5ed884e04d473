#include "shapegauge/experiments/datasets/model_ids.h"

#include <algorithm>
#include <array>

namespace shapegauge {
namespace {

constexpr std::array<std::string_view, 7> shape_extensions = {".off", ".obj", ".ply", ".stl", ".xyz", ".pwn", ".pts"};

char lower_case(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool ends_with_any_case(std::string_view text, std::string_view ending) {
  return text.size() >= ending.size() &&
         std::ranges::equal(text.substr(text.size() - ending.size()), ending, {}, lower_case);
}

bool is_whole_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

std::string canonical_model_id(std::string_view id) {
  for (const std::string_view extension : shape_extensions) {
    if (id.size() > extension.size() && ends_with_any_case(id, extension)) {
      id.remove_suffix(extension.size());
      break;
    }
  }
  if (id.starts_with('T') && is_whole_number(id.substr(1))) id.remove_prefix(1);
  return std::string(id);
}

bool same_model(std::string_view a, std::string_view b) { return canonical_model_id(a) == canonical_model_id(b); }

}  // namespace shapegauge
