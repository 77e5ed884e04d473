#pragma once

#include <exception>
#include <string>
#include <type_traits>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/distributed/communicator.h"

namespace shapegauge {

/// Error known to all ranks: each throws it, and only one needs to report it.
class SharedError : public InputError {
 public:
  using InputError::InputError;
};

/// Throws a SharedError on all ranks if one of them has an error; that of the lowest rank. An empty message means no
/// error. Collective.
void agree_on(const std::string& error, Communicator& ranks);

/// Runs the work on this rank; if it fails on any rank (std::exception), all ranks throw. A single rank just runs it.
/// Collective.
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

/// Runs the work on rank 0 and broadcasts its bytes; if it fails, all ranks throw. Collective.
template <typename Work>
std::string on_first_rank(Communicator& ranks, const Work& work) {
  return ranks.broadcast(on_all_ranks(ranks, [&] { return ranks.rank() == 0 ? work() : std::string(); }));
}

}  // namespace shapegauge
