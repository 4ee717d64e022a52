// What ranks get of each other, with messages so small that nearly everything goes in pieces: rank 0 says so on a line each.
// `abort`: the last rank ends all of them. `late`: what rank 1 first adds to memory of rank 0 comes late, as over a network.

#include <dirent.h>
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <leadscrew/sweep/world.hpp>
#include <string>
#include <thread>
#include <vector>

extern "C" leadscrew::sweep::World* leadscrew_make_world();

namespace {

using leadscrew::sweep::World;

constexpr std::int64_t claims = 1000;

bool first_is_late = false;

/// A text of so many bytes that no two places of which, nor of two texts, are exchanged unseen.
std::string text_of(int seed, int bytes) {
  std::string text;
  for (int k = 0; k < bytes; ++k) text.push_back(static_cast<char>('!' + (seed * 31 + k * k + k / 7) % 90));
  return text;
}

/// Threads that this process has.
int threads() {
  int count = 0;
  DIR* const folder = ::opendir("/proc/self/task");
  while (const dirent* const entry = ::readdir(folder)) count += entry->d_name[0] == '.' ? 0 : 1;
  ::closedir(folder);
  return count;
}

/// Bytes of a rank: none, less than a piece, just one, and many.
int bytes_of(int rank, int round) {
  constexpr int sizes[] = {0, 7, 16, 1000, 17, 1};
  return sizes[(rank + round) % 6];
}

bool gathers(World& world) {
  bool is_right = true;
  for (int round = 0; round < 6; ++round) {
    const auto parts = world.gather(text_of(world.rank(), bytes_of(world.rank(), round)));
    is_right &= parts.size() == static_cast<std::size_t>(world.rank() == 0 ? world.size() : 0);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const int rank = static_cast<int>(k);
      is_right &= parts[k] == text_of(rank, bytes_of(rank, round));
    }
  }
  return is_right;
}

bool broadcasts(World& world) {
  const std::string said = text_of(5, 1000);
  const std::string heard = world.broadcast(world.rank() == 0 ? said : "");
  std::size_t right = 0;
  for (const std::string& part : world.gather(heard)) right += part == said ? 1 : 0;
  return right == static_cast<std::size_t>(world.size());
}

bool claims_each_once(World& world) {
  std::string own;
  for (std::int64_t claim = world.claim(); claim < claims; claim = world.claim()) own += std::to_string(claim) + " ";
  std::vector<int> times(claims);
  for (const std::string& part : world.gather(own)) {
    for (const char* at = part.c_str(); *at != '\0'; at = std::strchr(at, ' ') + 1)
      ++times.at(static_cast<std::size_t>(std::atoll(at)));
  }
  return std::ranges::all_of(times, [](int count) { return count == 1; });
}

}  // namespace

/// In place of MPI's own.
extern "C" int MPI_Rget_accumulate(const void* added, int added_count, MPI_Datatype added_type, void* before,
                                   int before_count, MPI_Datatype before_type, int rank, MPI_Aint place, int count,
                                   MPI_Datatype type, MPI_Op operation, MPI_Win window, MPI_Request* request) {
  int own = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &own);
  if (first_is_late && own == 1) std::this_thread::sleep_for(std::chrono::seconds(1));
  first_is_late = false;
  return PMPI_Rget_accumulate(added, added_count, added_type, before, before_count, before_type, rank, place, count,
                              type, operation, window, request);
}

int main(int count, char** words) {
  first_is_late = count > 1 && std::strcmp(words[1], "late") == 0;
  World& world = *leadscrew_make_world();
  if (count > 1 && std::strcmp(words[1], "abort") == 0 && world.rank() == world.size() - 1) world.abort(3);
  const int own_threads = threads();
  const bool gathered = gathers(world), broadcast = broadcasts(world), claimed = claims_each_once(world);
  if (world.rank() == 0)
    std::printf("gather %d\nbroadcast %d\nclaims %d\nthreads %d\n", gathered, broadcast, claimed, own_threads);
}
