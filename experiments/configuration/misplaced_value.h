#pragma once

#include <fmt/format.h>
#include <string>

#include "shapegauge/core/error.h"

namespace shapegauge {

/// An error at a place within the part of a configuration that is being looked at.
struct MisplacedValue {
  std::string path;
  std::string message;
};

/// Runs a step on the part of the document at a key (or index, or dotted path), and completes the place where it fails.
template <typename Step>
auto at(const std::string& key, Step step) {
  try {
    return step();
  } catch (const MisplacedValue& error) {
    throw MisplacedValue{fmt::format("{}.{}", key, error.path), error.message};
  } catch (const InputError& error) {
    throw MisplacedValue{key, error.what()};
  }
}

}  // namespace shapegauge
