#pragma once
// Processes that work together, on one computer or on many: what a sweep asks of MPI. leadscrew-mpi.so, which is built where MPI
// is, makes one; the command itself is linked without MPI and loads it when mpirun or srun has started it.

#include <cstdint>
#include <string>
#include <vector>

namespace leadscrew::sweep {

class World {
 public:
  virtual ~World() = default;

  virtual int rank() const = 0;  ///< 0 … size() − 1
  virtual int size() const = 0;
  /// 0, 1, 2, … each once, whoever asks.
  virtual std::int64_t claim() = 0;
  /// How many claims there were; an estimate while others claim.
  virtual std::int64_t claimed() = 0;
  /// What rank 0 gives, to all. All call it.
  virtual std::string broadcast(std::string of_first) = 0;
  /// What each gives, in their order, to rank 0; to the others nothing. All call it.
  virtual std::vector<std::string> gather(const std::string& part) = 0;
  /// Ends all processes.
  [[noreturn]] virtual void abort(int status) = 0;
};

/// The name of the function in leadscrew-mpi.so that makes the world, of type MakeWorld; it goes when the process ends.
inline constexpr const char* make_world_name = "leadscrew_make_world";
using MakeWorld = World* (*)();

}  // namespace leadscrew::sweep
