// Processes that MPI has started, as a world. Loaded by the command (world_load.cpp).

#include <mpi.h>

#include <cstdlib>

#include <leadscrew/sweep/world.hpp>
#include <numeric>

namespace leadscrew::sweep {

namespace {

class MpiWorld final : public World {
 public:
  MpiWorld() {
    // One thread of each process calls MPI; surveys that are made in others do not.
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    const MPI_Aint bytes = rank_ == 0 ? sizeof(std::int64_t) : 0;
    MPI_Win_allocate(bytes, sizeof(std::int64_t), MPI_INFO_NULL, MPI_COMM_WORLD, &counter_, &window_);
    if (rank_ == 0) *counter_ = 0;
    MPI_Barrier(MPI_COMM_WORLD);
    MPI_Win_lock_all(0, window_);
  }
  ~MpiWorld() override {
    MPI_Win_unlock_all(window_);
    MPI_Win_free(&window_);
    MPI_Finalize();
  }
  MpiWorld(const MpiWorld&) = delete;
  MpiWorld& operator=(const MpiWorld&) = delete;

  int rank() const override { return rank_; }
  int size() const override { return size_; }
  std::int64_t claim() override { return fetch(MPI_SUM, 1); }
  std::int64_t claimed() override { return fetch(MPI_NO_OP, 0); }

  std::string broadcast(std::string of_first) override {
    auto bytes = static_cast<unsigned long long>(of_first.size());
    MPI_Bcast(&bytes, 1, MPI_UNSIGNED_LONG_LONG, 0, MPI_COMM_WORLD);
    of_first.resize(bytes);
    // MPI counts in int.
    constexpr std::size_t most = 1 << 30;
    for (std::size_t at = 0; at < of_first.size(); at += most) {
      const auto count = static_cast<int>(of_first.size() - at < most ? of_first.size() - at : most);
      MPI_Bcast(of_first.data() + at, count, MPI_CHAR, 0, MPI_COMM_WORLD);
    }
    return of_first;
  }

  std::vector<std::string> gather(const std::string& part) override {
    const auto bytes = static_cast<int>(part.size());
    std::vector<int> counts(static_cast<std::size_t>(size_)), places(static_cast<std::size_t>(size_));
    MPI_Gather(&bytes, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
    std::exclusive_scan(counts.begin(), counts.end(), places.begin(), 0);
    std::string all(rank_ == 0 ? static_cast<std::size_t>(places.back() + counts.back()) : 0, '\0');
    MPI_Gatherv(part.data(), bytes, MPI_CHAR, all.data(), counts.data(), places.data(), MPI_CHAR, 0, MPI_COMM_WORLD);
    std::vector<std::string> parts;
    for (std::size_t k = 0; rank_ == 0 && k < counts.size(); ++k)
      parts.push_back(all.substr(static_cast<std::size_t>(places[k]), static_cast<std::size_t>(counts[k])));
    return parts;
  }

  void abort(int status) override {
    MPI_Abort(MPI_COMM_WORLD, status);
    std::abort();
  }

 private:
  std::int64_t fetch(MPI_Op operation, std::int64_t added) {
    std::int64_t before = 0;
    MPI_Fetch_and_op(&added, &before, MPI_INT64_T, 0, 0, operation, window_);
    MPI_Win_flush(0, window_);
    return before;
  }

  int rank_ = 0, size_ = 1;
  MPI_Win window_ = MPI_WIN_NULL;
  std::int64_t* counter_ = nullptr;  // of rank 0
};

}  // namespace

}  // namespace leadscrew::sweep

extern "C" leadscrew::sweep::World* leadscrew_make_world() {
  static leadscrew::sweep::MpiWorld world;
  return &world;
}
