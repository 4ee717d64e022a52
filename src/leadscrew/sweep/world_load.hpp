#pragma once
// How the command finds the processes it works together with.

#include <leadscrew/base/result.hpp>
#include <leadscrew/sweep/world.hpp>

namespace leadscrew::sweep {

/// Null where the process works alone: neither mpirun nor srun has started it. Error: `sweep-mpi` where one has and there is
/// no leadscrew-mpi.so beside the command or in ../lib/leadscrew, or it cannot be loaded.
base::Result<World*> load_world();

}  // namespace leadscrew::sweep
