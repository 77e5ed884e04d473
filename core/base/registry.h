// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>
#include <mutex>
#include <shared_mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/nearest_word.h"

namespace shapegauge {

/// Returns true if all mandatory functions of a registry entry are set: neither null nor empty. `functions` are
/// pointers to these members.
template <auto... functions, typename Entry>
bool has_functions([[maybe_unused]] const Entry& entry) {
  return (static_cast<bool>(entry.*functions) && ...);
}

/// Registry of entries by name, such as fields, descriptors, distances and measures. `Entry` is a struct with a member
/// `name`. Entries stay in the order of registration, at fixed addresses, unchanged for the life of the program.
/// Thread-safe.
template <typename Entry>
class Registry {
 public:
  /// Creates a registry.
  /// - `kind`: noun for an entry in messages, for example "descriptor".
  /// - `builtin`: the built-in entries, with distinct names.
  /// - `is_complete`: true for an entry with the functions that it must have: has_functions<&Entry::function>.
  /// - `check`: throws InputError for an entry that is invalid for another reason; null: no further check.
  Registry(std::string_view kind, std::vector<Entry> builtin, bool (*is_complete)(const Entry&),
           void (*check)(const Entry&) = nullptr)
      : kind_(kind), is_complete_(is_complete), check_(check) {
    for (Entry& entry : builtin) entries_.push_back(std::move(entry));
  }

  /// Adds an entry, making it available to configurations, listings and the schema. Data that its views and spans refer
  /// to must live as long as the program. Throws ArgumentError for a name that is empty or already registered, and for
  /// an entry without a mandatory function; throws as the constructor's `check` does.
  void add(Entry entry) {
    if (entry.name.empty()) throw ArgumentError("a " + kind_ + " needs a name");
    if (!is_complete_(entry)) {
      throw ArgumentError("the " + kind_ + " \"" + std::string(entry.name) + "\" lacks a mandatory function");
    }
    if (check_ != nullptr) check_(entry);
    const std::unique_lock lock(mutex_);
    for (const Entry& known : entries_) {
      if (known.name == entry.name) {
        throw ArgumentError("there is a " + kind_ + " \"" + std::string(entry.name) + "\" already");
      }
    }
    entries_.push_back(std::move(entry));
  }

  /// Returns the entry called `name`; null if there is none.
  [[nodiscard]] const Entry* find(std::string_view name) const {
    return find_if([&](const Entry& entry) { return entry.name == name; });
  }

  /// Returns the first entry for which predicate(entry) is true; null if there is none.
  template <typename Predicate>
  [[nodiscard]] const Entry* find_if(const Predicate& predicate) const {
    const std::shared_lock lock(mutex_);
    for (const Entry& entry : entries_) {
      if (predicate(entry)) return &entry;
    }
    return nullptr;
  }

  /// Returns the entry called `name`. Throws ArgumentError for an unknown name; the message suggests the nearest
  /// name or lists all names.
  [[nodiscard]] const Entry& at(std::string_view name) const {
    if (const Entry* const found = find(name)) return *found;
    throw ArgumentError(unknown_word_message(kind_, name, names()));
  }

  /// Returns all entries, in the order of registration.
  [[nodiscard]] std::vector<std::reference_wrapper<const Entry>> entries() const {
    const std::shared_lock lock(mutex_);
    return {entries_.begin(), entries_.end()};
  }

  /// Returns the names of all entries, in the order of registration.
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const Entry& entry : entries()) all.emplace_back(entry.name);
    return all;
  }

 private:
  std::string kind_;
  bool (*is_complete_)(const Entry&);
  void (*check_)(const Entry&);
  mutable std::shared_mutex mutex_;
  std::deque<Entry> entries_;
};

}  // namespace shapegauge
