#pragma once

#include "shapegauge/experiments/distributed/communicator.h"

namespace shapegauge {

/// The module with all that uses MPI, which the program loads where it was started as one of several processes.
inline constexpr const char* mpi_module_name = "shapegauge_mpi.so";

/// Its one function, by name: joins the other processes. The caller owns the result. `build`: version and commit of the
/// program; null where the module is of another one.
using JoinMpi = Communicator*(const char* build);
inline constexpr const char* join_mpi_name = "shapegauge_join_mpi";

}  // namespace shapegauge
