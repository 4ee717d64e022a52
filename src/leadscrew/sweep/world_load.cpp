#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <leadscrew/sweep/world_load.hpp>
#include <string>

namespace leadscrew::sweep {

namespace {

/// What mpirun of Open MPI, of MPICH and srun tell a process of how many there are.
constexpr std::array<const char*, 3> sizes = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"};

bool works_together() {
  for (const char* name : sizes) {
    const char* const value = std::getenv(name);
    if (value != nullptr && std::atoi(value) > 1) return true;
  }
  return false;
}

base::Diagnostic no_module(const std::string& why) {
  return {base::Severity::error,
          "sweep-mpi",
          fmt::format("several processes were started, and there is no MPI in this installation: {}", why),
          "build where MPI is (packages/sweep.txt), or start the command without mpirun",
          {},
          {}};
}

}  // namespace

base::Result<World*> load_world() {
  if (!works_together()) return nullptr;
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  constexpr std::array<const char*, 2> places = {"leadscrew-mpi.so", "../lib/leadscrew/leadscrew-mpi.so"};
  std::string why;
  for (const char* const place : places) {
    const std::filesystem::path path = folder / place;
    if (!std::filesystem::exists(path, error)) continue;
    // MPI's own modules look for its names among all that are loaded.
    void* const module = ::dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (module == nullptr) {
      why = ::dlerror();
      continue;
    }
    const auto make = reinterpret_cast<MakeWorld>(::dlsym(module, make_world_name));
    if (make != nullptr) return make();
    why = fmt::format("{} has no {}", path.string(), make_world_name);
  }
  return base::failure(no_module(why.empty() ? "leadscrew-mpi.so is missing" : why));
}

}  // namespace leadscrew::sweep
