// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace shapegauge {

/// One of `count` parts of a distributed run, which processes compute independently.
struct Part {
  std::size_t number = 1;  ///< position of this part among all parts of the run, from 1 to `count`
  std::size_t count = 1;   ///< number of parts of the run

  /// Returns true if this part computes the item (shape or matrix row) with that index: every `count`-th item.
  [[nodiscard]] bool has(std::size_t index) const { return index % count == number - 1; }
  /// Selects the items that this part computes: every `count`-th item of `items`, from index `number` - 1 on.
  [[nodiscard]] std::vector<std::size_t> of(const std::vector<std::size_t>& items) const;
};

/// Parses "K/N" for part K of N, or "auto": the part of this process in a Slurm job array, or among the processes
/// started by mpirun or srun, from their environment variables. Throws InputError for other text, and for "auto"
/// without these variables.
Part parse_part(std::string_view text);

}  // namespace shapegauge
