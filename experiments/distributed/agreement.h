#pragma once

#include <exception>
#include <string>
#include <type_traits>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/distributed/communicator.h"

namespace shapegauge {

/// An error that all ranks know of: each throws it, and it is enough that one says it.
class SharedError : public InputError {
 public:
  using InputError::InputError;
};

/// Collective. Throws a SharedError on all ranks where one of them has an error; that of the lowest rank. An empty
/// message is none.
void agree_on(const std::string& error, Communicator& ranks);

/// Collective. Does the work here; where it fails on a rank (std::exception), all ranks throw. Alone, it is just done.
template <typename Work>
auto on_all_ranks(Communicator& ranks, const Work& work) -> std::invoke_result_t<Work> {
  if (ranks.size() == 1) return work();
  const auto attempt = [&](const auto& tried) {
    std::string error;
    try {
      tried();
    } catch (const std::exception& failure) {
      error = failure.what();
    }
    agree_on(error, ranks);
  };
  if constexpr (std::is_void_v<std::invoke_result_t<Work>>) {
    attempt(work);
  } else {
    std::invoke_result_t<Work> result{};
    attempt([&] { result = work(); });
    return result;
  }
}

/// Collective. Does the work on rank 0 and tells its bytes to all; where it fails, all ranks throw.
template <typename Work>
std::string on_first_rank(Communicator& ranks, const Work& work) {
  return ranks.broadcast(on_all_ranks(ranks, [&] { return ranks.rank() == 0 ? work() : std::string(); }));
}

}  // namespace shapegauge
