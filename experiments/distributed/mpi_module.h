#pragma once

#include "shapegauge/experiments/distributed/communicator.h"

namespace shapegauge {

/// Name of the module with all code that uses MPI, loaded if there are several processes.
inline constexpr const char* mpi_module_name = "shapegauge_mpi.so";

/// Only function of the module: joins the other processes. The caller owns the result. `build` is the version and
/// commit of the program; null if the module has another one.
using JoinMpi = Communicator*(const char* build);
inline constexpr const char* join_mpi_name = "shapegauge_join_mpi";

}  // namespace shapegauge
