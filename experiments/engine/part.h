// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace shapegauge {

/// One of `count` parts of a distributed run, which processes compute independently.
struct Part {
  std::size_t number = 1;  ///< number of this part of the run, from 1 to `count`
  std::size_t count = 1;   ///< number of parts of the run

  /// Returns true if the item of that index belongs to the part. Neighbouring items belong to different parts.
  [[nodiscard]] bool has(std::size_t index) const { return index % count == number - 1; }
  /// Returns the items that belong to the part: every `count`-th one.
  [[nodiscard]] std::vector<std::size_t> of(const std::vector<std::size_t>& items) const;
};

/// Parses "K/N", from 1/N to N/N, or "auto": the part of this process in a Slurm job array, or among the processes
/// started by mpirun or srun, from their environment variables. Throws InputError for other text, and for "auto"
/// without these variables.
Part parse_part(std::string_view text);

}  // namespace shapegauge
