#pragma once

#include <string>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

/// The message of the InputError that the call throws; "no error" where it throws none. Other exceptions pass through.
template <typename Call>
std::string input_error_of(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace shapegauge
