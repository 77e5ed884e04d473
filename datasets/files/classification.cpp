// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/files/classification.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fmt/format.h>
#include <limits>
#include <unordered_map>
#include <unordered_set>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/model_ids.h"

namespace shapegauge {

std::size_t model_count(const Classification& classification) {
  std::size_t count = 0;
  for (const ModelClass& model_class : classification.classes) count += model_class.models.size();
  return count;
}

std::vector<std::string> models_in_file_order(const Classification& classification) {
  std::vector<std::string> models;
  for (const ModelClass& model_class : classification.classes) {
    models.insert(models.end(), model_class.models.begin(), model_class.models.end());
  }
  return models;
}

std::vector<std::string> models_in_natural_order(const Classification& classification) {
  std::vector<std::string> models = models_in_file_order(classification);
  std::ranges::sort(models, natural_less);
  return models;
}

std::vector<int> class_labels(const Classification& classification, std::span<const std::string> ids,
                              const std::string& source) {
  std::unordered_map<std::string, int> class_of_model;
  for (std::size_t i = 0; i < classification.classes.size(); ++i) {
    for (const std::string& model : classification.classes[i].models) {
      class_of_model.emplace(canonical_model_id(model), static_cast<int>(i));
    }
  }
  std::vector<int> labels;
  std::unordered_set<std::string> seen;
  for (const std::string& id : ids) {
    const std::string canonical = canonical_model_id(id);
    const auto found = class_of_model.find(canonical);
    if (found == class_of_model.end()) {
      throw InputError(
          fmt::format("{}: model {} is in no class; add it to the file or remove the model", source, quoted_word(id)));
    }
    if (!seen.insert(canonical).second) {
      throw InputError(
          fmt::format("{}: model {} is repeated among the {} models found, not in this file; remove one of them",
                      source, quoted_word(id), ids.size()));
    }
    labels.push_back(found->second);
  }
  for (const std::string& model : models_in_file_order(classification)) {
    if (seen.contains(canonical_model_id(model))) continue;
    throw InputError(
        fmt::format("{}: model {} has a class but is not among the {} models found; add its file, or remove it here",
                    source, quoted_word(model), ids.size()));
  }
  return labels;
}

namespace {

constexpr std::string_view no_parent = "0";

// Iterates over the words of a text with their lines.
class WordReader {
 public:
  WordReader(std::string_view text, const std::string& source)
      : rest_(without_byte_order_mark(text)), source_(source) {}

  bool at_end() {
    skip_white_space();
    return rest_.empty();
  }

  // Returns the next word; `what` names it in the error at the end of the text.
  std::string_view word(std::string_view what) {
    if (at_end()) fail(fmt::format("the file ends where {} should be", what));
    const std::string_view word = rest_.substr(0, rest_.find_first_of(white_space));
    rest_.remove_prefix(word.size());
    return word;
  }

  std::size_t count(std::string_view what) {
    const std::string_view digits = word(what);
    std::uint32_t value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (error != std::errc() || stop != end) {
      fail(fmt::format("{} must be a whole number from 0 to {}, not {}", what,
                       std::numeric_limits<std::uint32_t>::max(), quoted_word(digits)));
    }
    return value;
  }

  [[nodiscard]] std::size_t line() const { return line_; }

  [[noreturn]] void fail(std::string_view message) const {
    throw InputError(fmt::format("{}:{}: {}", source_, line_, message));
  }

 private:
  static constexpr std::string_view white_space = " \t\n\v\f\r";

  void skip_white_space() {
    const std::size_t length = std::min(rest_.find_first_not_of(white_space), rest_.size());
    line_ += static_cast<std::size_t>(std::ranges::count(rest_.substr(0, length), '\n'));
    rest_.remove_prefix(length);
  }

  std::string_view rest_;
  const std::string& source_;
  std::size_t line_ = 1;
};

class ClassificationParser {
 public:
  ClassificationParser(std::string_view text, const std::string& source) : words_(text, source) {}

  Classification parse() {
    parse_format();
    const std::size_t classes = words_.count("the number of classes");
    models_promised_ = words_.count("the number of models");
    if (classes == 0) words_.fail("the file has no classes");
    if (models_promised_ == 0) words_.fail("the file has no models");
    for (std::size_t i = 0; i < classes; ++i) {
      parse_class(fmt::format("class {} of {}", i + 1, classes));
    }
    if (models_read_ != models_promised_) {
      words_.fail(fmt::format("the classes have {} models in total, but the header announces {}", models_read_,
                              models_promised_));
    }
    if (!words_.at_end()) {
      words_.fail(fmt::format("expected the end of the file after {}, found {}",
                              count_text(static_cast<std::int64_t>(classes), "class", "classes"),
                              quoted_word(words_.word("the end"))));
    }
    return std::move(result_);
  }

 private:
  void parse_format() {
    if (words_.at_end()) words_.fail("the file is empty; a classification begins with \"PSB 1\"");
    const std::string_view format = words_.word("PSB");
    if (format != "PSB") {
      words_.fail(fmt::format("a classification begins with \"PSB 1\", not with {}", quoted_word(format)));
    }
    const std::string_view version = words_.word("the version of the format");
    if (version != "1") {
      words_.fail(fmt::format("version {} of the PSB format is not supported, only 1", quoted_word(version)));
    }
  }

  void parse_class(const std::string& which) {
    ModelClass read;
    read.name = words_.word("the name of " + which);
    if (read.name == no_parent) words_.fail("a class cannot be named 0, which stands for \"no parent\"");
    const auto [earlier, is_new] = line_of_class_.emplace(read.name, words_.line());
    if (!is_new) {
      words_.fail(
          fmt::format("class {} is repeated; it was first in line {}", quoted_word(read.name), earlier->second));
    }
    read.parent = parse_parent(read.name);
    const std::size_t count = words_.count(fmt::format("the number of models of class {}", quoted_word(read.name)));
    models_read_ += count;
    if (models_read_ > models_promised_) {
      words_.fail(fmt::format("there are {1} models up to class {0}, but the header announces {2} in total",
                              quoted_word(read.name), models_read_, models_promised_));
    }
    // No memory is reserved for `count` models: the number is unverified until they have been read.
    for (std::size_t i = 0; i < count; ++i) {
      read.models.emplace_back(
          words_.word(fmt::format("model {} of {} of class {}", i + 1, count, quoted_word(read.name))));
      check_model_is_new(read.models.back(), read.name);
    }
    index_of_class_.emplace(read.name, result_.classes.size());
    result_.classes.push_back(std::move(read));
  }

  std::optional<std::size_t> parse_parent(const std::string& child) {
    const std::string parent(words_.word(fmt::format("the parent of class {}", quoted_word(child))));
    if (parent == no_parent) return std::nullopt;
    const auto found = index_of_class_.find(parent);
    if (found == index_of_class_.end()) {
      words_.fail(fmt::format("the parent {} of class {} is not a class that comes before it; use 0 for no parent",
                              quoted_word(parent), quoted_word(child)));
    }
    return found->second;
  }

  void check_model_is_new(const std::string& id, const std::string& class_name) {
    const auto [earlier, is_new] = class_of_model_.emplace(canonical_model_id(id), class_name);
    if (is_new) return;
    if (earlier->second == class_name) {
      words_.fail(fmt::format("model {} occurs twice in class {}", quoted_word(id), quoted_word(class_name)));
    }
    words_.fail(fmt::format("model {} is in two classes, {} and {}", quoted_word(id), quoted_word(earlier->second),
                            quoted_word(class_name)));
  }

  WordReader words_;
  Classification result_;
  std::size_t models_promised_ = 0;
  std::size_t models_read_ = 0;
  std::unordered_map<std::string, std::size_t> line_of_class_;
  std::unordered_map<std::string, std::size_t> index_of_class_;
  std::unordered_map<std::string, std::string> class_of_model_;
};

}  // namespace

Classification parse_classification(std::string_view text, const std::string& source) {
  return ClassificationParser(text, source).parse();
}

std::string format_classification(const Classification& classification) {
  std::string text = fmt::format("PSB 1\n{} {}\n", classification.classes.size(), model_count(classification));
  for (const ModelClass& written : classification.classes) {
    const bool has_parent = written.parent && *written.parent < classification.classes.size();
    const std::string_view parent = has_parent ? classification.classes[*written.parent].name : no_parent;
    text += fmt::format("\n{} {} {}\n", written.name, parent, written.models.size());
    for (const std::string& model : written.models) text += model + '\n';
  }
  return text;
}

Classification read_classification(const std::filesystem::path& path) {
  return parse_classification(read_file_bytes(path), path.string());
}

void write_classification(const std::filesystem::path& path, const Classification& classification) {
  const std::string text = format_classification(classification);
  // A classification that is not representable does not survive a round trip: one check covers all cases.
  if (parse_classification(text, "cannot write " + path.string()) != classification) {
    throw InputError(fmt::format(
        "cannot write {}: a class name or model id is empty or has white space in it, or a parent does not exist",
        path.string()));
  }
  write_file_atomically(path, text);
}

}  // namespace shapegauge
