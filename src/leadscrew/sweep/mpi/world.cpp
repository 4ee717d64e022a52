// Processes that MPI has started, as a world. Loaded by the command (world_load.cpp).
//
// MPI waits by asking again and again, at the cost of a whole processor. Here who waits sleeps meanwhile: a rank that has no
// task left must not slow those that share its processor.
//
// The counter is memory of rank 0. Ranks of one computer, and those of a network that reads and writes memory by itself, change
// it while rank 0 works on a task. Where messages carry the claims (TCP), rank 0 must be in MPI to serve them: a thread of it
// looks in at short intervals then, or every claim would wait for a task's end.

#include <mpi.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <leadscrew/sweep/world.hpp>
#include <mutex>
#include <numeric>
#include <optional>
#include <stop_token>
#include <thread>

namespace leadscrew::sweep {

namespace {

using std::chrono::microseconds;
using Clock = std::chrono::steady_clock;

constexpr microseconds shortest_sleep{20}, longest_sleep{5000};
constexpr microseconds between_services{200};  // by the thread of rank 0: some 1 % of a processor
constexpr std::chrono::milliseconds time_of_trial{50};

class MpiWorld final : public World {
 public:
  MpiWorld() {
    // One thread of a process at a time calls MPI; surveys that are made in others do not.
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    const MPI_Aint bytes = rank_ == 0 ? 2 * sizeof(std::int64_t) : 0;
    MPI_Win_allocate(bytes, sizeof(std::int64_t), MPI_INFO_NULL, MPI_COMM_WORLD, &counters_, &window_);
    if (rank_ == 0) counters_[of_claims] = counters_[of_trial] = 0;
    MPI_Barrier(MPI_COMM_WORLD);
    MPI_Win_lock_all(0, window_);
    if (!is_served_alone() && provided >= MPI_THREAD_SERIALIZED)
      service_.emplace([this](const std::stop_token& stop) { serve(stop); });
  }
  ~MpiWorld() override {
    broadcast({});  // until all have done their tasks
    service_.reset();
    MPI_Win_unlock_all(window_);
    MPI_Win_free(&window_);
    MPI_Finalize();
  }
  MpiWorld(const MpiWorld&) = delete;
  MpiWorld& operator=(const MpiWorld&) = delete;

  int rank() const override { return rank_; }
  int size() const override { return size_; }
  std::int64_t claim() override { return fetch(of_claims, MPI_SUM, 1); }
  std::int64_t claimed() override { return fetch(of_claims, MPI_NO_OP, 0); }

  std::string broadcast(std::string of_first) override {
    auto bytes = static_cast<unsigned long long>(of_first.size());
    finish([&](MPI_Request* request) { MPI_Ibcast(&bytes, 1, MPI_UNSIGNED_LONG_LONG, 0, MPI_COMM_WORLD, request); });
    of_first.resize(bytes);
    // MPI counts in int.
    constexpr std::size_t most = 1 << 30;
    for (std::size_t at = 0; at < of_first.size(); at += most) {
      const auto count = static_cast<int>(of_first.size() - at < most ? of_first.size() - at : most);
      finish(
          [&](MPI_Request* request) { MPI_Ibcast(of_first.data() + at, count, MPI_CHAR, 0, MPI_COMM_WORLD, request); });
    }
    return of_first;
  }

  std::vector<std::string> gather(const std::string& part) override {
    const auto bytes = static_cast<int>(part.size());
    std::vector<int> counts(static_cast<std::size_t>(size_)), places(static_cast<std::size_t>(size_));
    finish([&](MPI_Request* request) {
      MPI_Igather(&bytes, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, MPI_COMM_WORLD, request);
    });
    std::exclusive_scan(counts.begin(), counts.end(), places.begin(), 0);
    std::string all(rank_ == 0 ? static_cast<std::size_t>(places.back() + counts.back()) : 0, '\0');
    finish([&](MPI_Request* request) {
      MPI_Igatherv(part.data(), bytes, MPI_CHAR, all.data(), counts.data(), places.data(), MPI_CHAR, 0, MPI_COMM_WORLD,
                   request);
    });
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
  enum Counter : int { of_claims, of_trial };

  /// Begins what MPI does meanwhile, and sleeps until it is done.
  template <typename Begin>
  void finish(Begin begin) {
    MPI_Request request = MPI_REQUEST_NULL;
    int is_done = 0;
    for (microseconds sleep = shortest_sleep;; sleep = std::min(2 * sleep, longest_sleep)) {
      {
        const std::scoped_lock lock(mpi_);
        if (sleep == shortest_sleep && request == MPI_REQUEST_NULL) begin(&request);
        MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
      }
      if (is_done != 0) return;
      std::this_thread::sleep_for(sleep);
    }
  }

  std::int64_t fetch(Counter counter, MPI_Op operation, std::int64_t added) {
    std::int64_t before = 0;
    finish([&](MPI_Request* request) {
      MPI_Rget_accumulate(&added, 1, MPI_INT64_T, &before, 1, MPI_INT64_T, 0, counter, 1, MPI_INT64_T, operation,
                          window_, request);
    });
    return before;
  }

  /// Does what another rank adds reach memory of rank 0 while that is outside MPI? Of the other ranks always true.
  bool is_served_alone() {
    if (rank_ == size_ - 1) fetch(of_trial, MPI_SUM, 1);
    if (rank_ > 0 || size_ == 1) return true;
    const auto deadline = Clock::now() + time_of_trial;
    const std::atomic_ref<std::int64_t> trial(counters_[of_trial]);
    while (trial == 0 && Clock::now() < deadline) std::this_thread::sleep_for(shortest_sleep);
    return trial != 0;
  }

  void serve(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      int is_there = 0;
      {
        const std::scoped_lock lock(mpi_);
        MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, MPI_STATUS_IGNORE);
      }
      std::this_thread::sleep_for(between_services);
    }
  }

  int rank_ = 0, size_ = 1;
  MPI_Win window_ = MPI_WIN_NULL;
  std::int64_t* counters_ = nullptr;  // of rank 0
  std::mutex mpi_;                    // held by the thread that calls MPI
  std::optional<std::jthread> service_;
};

}  // namespace

}  // namespace leadscrew::sweep

extern "C" leadscrew::sweep::World* leadscrew_make_world() {
  static leadscrew::sweep::MpiWorld world;
  return &world;
}
