#include <array>
#include <charconv>
#include <dlfcn.h>
#include <filesystem>
#include <fmt/format.h>
#include <string_view>

#include "shapegauge/core/base/environment.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/version.h"
#include "shapegauge/experiments/distributed/communicator.h"
#include "shapegauge/experiments/distributed/mpi_module.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

/// Returns the number of processes announced by the launcher.
int announced_processes() {
  // Open MPI's mpirun, other launchers through PMI, and srun for the tasks of a step.
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"}) {
    const std::string text = environment_variable(name).value_or("");
    int count = 0;
    if (!text.empty() && std::from_chars(text.data(), text.data() + text.size(), count).ec == std::errc()) return count;
  }
  return 1;
}

fs::path module_file() {
  if (const auto named = environment_variable("SHAPEGAUGE_MPI_MODULE").value_or(""); !named.empty()) return named;
  std::error_code unknown;
  const fs::path folder = fs::read_symlink("/proc/self/exe", unknown).parent_path();
  for (const fs::path& place : {folder / mpi_module_name, folder / SHAPEGAUGE_MPI_MODULE_FOLDER / mpi_module_name}) {
    if (fs::exists(place, unknown)) return place;
  }
  return {};
}

[[noreturn]] void fail(int processes, std::string_view reason) {
  throw InputError(
      fmt::format("started as one of {} processes, which requires MPI, but {}; without mpirun or srun it runs alone",
                  processes, reason));
}

std::unique_ptr<Communicator> load_mpi(int processes) {
  const fs::path file = module_file();
  if (file.empty()) {
    fail(processes, fmt::format("{} is not installed (a package of its own; a build has it where MPI is installed)",
                                mpi_module_name));
  }
  // Open MPI's own modules look for its symbols among the global ones.
  void* const module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (module == nullptr) fail(processes, fmt::format("{} cannot be loaded: {}", file.string(), ::dlerror()));
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): that is how dlsym gives functions
  const auto join = reinterpret_cast<JoinMpi*>(::dlsym(module, join_mpi_name));
  if (join == nullptr) fail(processes, fmt::format("{} is unusable: {}", file.string(), ::dlerror()));
  std::unique_ptr<Communicator> ranks(join(fmt::format("{} {}", version(), commit()).c_str()));
  if (!ranks) fail(processes, fmt::format("{} belongs to another build of shapegauge", file.string()));
  return ranks;
}

}  // namespace

std::unique_ptr<Communicator> started_processes() {
  const int processes = announced_processes();
  if (processes <= 1) return single_process();
  std::unique_ptr<Communicator> ranks = load_mpi(processes);
  if (ranks->size() != processes) {
    const int joined = ranks->size();
    ranks.reset();
    fail(processes, fmt::format("MPI reports {} only; under Slurm, use srun --mpi=pmix, pmi2 or mpirun", joined));
  }
  return ranks;
}

}  // namespace shapegauge
