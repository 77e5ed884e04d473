// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/engine/part.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <optional>

#include "shapegauge/core/base/environment.h"
#include "shapegauge/core/base/error.h"

namespace shapegauge {

namespace {

std::optional<std::size_t> number_in(std::string_view text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::optional<std::size_t> number_of(const char* variable) {
  return number_in(environment_variable(variable).value_or(""));
}

/// Returns the part of the process with that index from 0, if both variables are set.
std::optional<Part> part_of_process(const char* index_variable, const char* count_variable) {
  const auto index = number_of(index_variable);
  const auto count = number_of(count_variable);
  if (!index || !count || *count == 0) return std::nullopt;
  return Part{.number = *index % *count + 1, .count = *count};
}

std::optional<Part> part_of_job_array() {
  const auto task = number_of("SLURM_ARRAY_TASK_ID");
  const auto count = number_of("SLURM_ARRAY_TASK_COUNT");
  if (!task || !count || *count == 0) return std::nullopt;
  // Arrays may begin at any number, such as --array=1-64, but their numbers must be evenly spaced.
  const std::size_t first = number_of("SLURM_ARRAY_TASK_MIN").value_or(0);
  const std::size_t step = std::max<std::size_t>(number_of("SLURM_ARRAY_TASK_STEP").value_or(1), 1);
  const std::size_t last = number_of("SLURM_ARRAY_TASK_MAX").value_or(first + (*count - 1) * step);
  if ((last - first) / step + 1 != *count) {
    throw InputError(fmt::format(
        "`part=auto` needs a Slurm job array with evenly spaced numbers, such as 1-64, and this one has {} from {} to "
        "{}; to repeat single parts use K/N",
        *count, first, last));
  }
  return Part{.number = (*task - first) / step % *count + 1, .count = *count};
}

Part part_of_environment() {
  if (const auto part = part_of_job_array()) return *part;
  // Under Slurm, mpirun itself is started by srun: its variables come first.
  if (const auto part = part_of_process("OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE")) return *part;
  if (const auto part = part_of_process("SLURM_PROCID", "SLURM_NTASKS")) return *part;
  throw InputError(
      "`part=auto` needs a Slurm job array (SLURM_ARRAY_TASK_ID, SLURM_ARRAY_TASK_COUNT), mpirun "
      "(OMPI_COMM_WORLD_RANK, "
      "OMPI_COMM_WORLD_SIZE) or srun (SLURM_PROCID, SLURM_NTASKS); otherwise use K/N, such as 3/64");
}

}  // namespace

std::vector<std::size_t> Part::of(const std::vector<std::size_t>& items) const {
  std::vector<std::size_t> shard;
  for (std::size_t i = number - 1; i < items.size(); i += count) shard.push_back(items[i]);
  return shard;
}

Part parse_part(std::string_view text) {
  if (text == "auto") return part_of_environment();
  const std::size_t slash = text.find('/');
  const auto number = number_in(text.substr(0, slash));
  const auto count = slash == std::string_view::npos ? std::nullopt : number_in(text.substr(slash + 1));
  if (!number || !count || *number < 1 || *number > *count) {
    throw InputError(
        fmt::format("`part` must be auto or K/N with K from 1 to N, such as 3/64, not \"{}\"", printable(text, 100)));
  }
  return {.number = *number, .count = *count};
}

}  // namespace shapegauge
