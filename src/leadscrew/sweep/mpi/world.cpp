// Processes that MPI has started, as a world. Loaded by the command (world_load.cpp).
//
// MPI waits by asking again and again, at the cost of a whole processor. Here who waits sleeps meanwhile: a rank that has no
// task left must not slow those that share its processor.
//
// The counter is memory of rank 0. Ranks of one computer, and those of a network that reads and writes memory by itself, change
// it while rank 0 works on a task. Where messages carry the claims (TCP), rank 0 must be in MPI to serve them: a thread of it
// looks in at short intervals then, or every claim would wait for a task's end.

#include <mpi.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <leadscrew/sweep/world.hpp>
#include <limits>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

namespace leadscrew::sweep {

namespace {

using std::chrono::microseconds;
using Clock = std::chrono::steady_clock;

constexpr microseconds shortest_sleep{20}, longest_sleep{5000};
constexpr microseconds between_services{200};  // by the thread of rank 0: some 1 % of a processor
constexpr std::chrono::milliseconds time_of_trial{100};

// MPI counts in int: what is larger goes in pieces. Tests have a smaller one.
#ifndef LEADSCREW_LARGEST_MESSAGE
#define LEADSCREW_LARGEST_MESSAGE (1 << 30)
#endif
constexpr std::size_t largest_message = LEADSCREW_LARGEST_MESSAGE;  // bytes
static_assert(largest_message > 0 && largest_message <= std::numeric_limits<int>::max());

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
    if (is_aborted_) return;  // while it ends
    broadcast({});            // others stay until rank 0, which has gathered from all, is here
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
    for (std::size_t at = 0; at < of_first.size(); at += largest_message) {
      const auto count = static_cast<int>(std::min(largest_message, of_first.size() - at));
      finish(
          [&](MPI_Request* request) { MPI_Ibcast(of_first.data() + at, count, MPI_CHAR, 0, MPI_COMM_WORLD, request); });
    }
    return of_first;
  }

  std::vector<std::string> gather(const std::string& part) override {
    const std::vector<Size> sizes = gather_sizes(part.size());
    std::vector<std::string> parts(sizes.size());
    for (std::size_t k = 0; k < parts.size(); ++k) parts[k].reserve(sizes[k]);
    const auto largest = static_cast<std::size_t>(largest_of_all(part.size()));
    // As much of each as all together fit into a message.
    const std::size_t piece = std::max<std::size_t>(1, largest_message / static_cast<std::size_t>(size_));
    for (std::size_t at = 0; at < largest; at += piece) gather_pieces(part, sizes, at, piece, parts);
    return parts;
  }

  void abort(int status) override {
    service_.reset();  // one thread at a time calls MPI, here too
    is_aborted_ = true;
    MPI_Abort(MPI_COMM_WORLD, status);
    std::abort();
  }

 private:
  using Size = unsigned long long;
  enum Counter : int { of_claims, of_trial };

  /// Of rank 0: of each rank; of the others empty.
  std::vector<Size> gather_sizes(Size own) {
    std::vector<Size> sizes(rank_ == 0 ? static_cast<std::size_t>(size_) : 0);
    finish([&](MPI_Request* request) {
      MPI_Igather(&own, 1, MPI_UNSIGNED_LONG_LONG, sizes.data(), 1, MPI_UNSIGNED_LONG_LONG, 0, MPI_COMM_WORLD, request);
    });
    return sizes;
  }
  Size largest_of_all(Size own) {
    Size largest = 0;
    finish([&](MPI_Request* request) {
      MPI_Iallreduce(&own, &largest, 1, MPI_UNSIGNED_LONG_LONG, MPI_MAX, MPI_COMM_WORLD, request);
    });
    return largest;
  }
  /// Adds to the parts, of rank 0, what each rank has from this place on, as much as a piece.
  void gather_pieces(const std::string& own, const std::vector<Size>& sizes, std::size_t at, std::size_t piece,
                     std::vector<std::string>& parts) {
    const auto bytes_here = [&](Size size) {
      return static_cast<int>(std::min<Size>(piece, size - std::min<Size>(at, size)));
    };
    std::vector<int> counts, places;
    int total = 0;
    for (const Size size : sizes) {
      places.push_back(total);
      counts.push_back(bytes_here(size));
      total += counts.back();
    }
    std::string all(static_cast<std::size_t>(total), '\0');
    const int count = bytes_here(own.size());
    finish([&](MPI_Request* request) {
      MPI_Igatherv(own.data() + (own.size() < at ? own.size() : at), count, MPI_CHAR, all.data(), counts.data(),
                   places.data(), MPI_CHAR, 0, MPI_COMM_WORLD, request);
    });
    for (std::size_t k = 0; k < parts.size(); ++k)
      parts[k].append(all, static_cast<std::size_t>(places[k]), static_cast<std::size_t>(counts[k]));
  }

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

  /// Does what each of the other ranks adds reach memory of rank 0 while that is outside MPI? Some of them may be on its
  /// computer, others not. Of the other ranks always true.
  bool is_served_alone() {
    if (rank_ > 0) {
      fetch(of_trial, MPI_SUM, 1);
      return true;
    }
    const auto deadline = Clock::now() + time_of_trial;
    const std::atomic_ref<std::int64_t> trial(counters_[of_trial]);
    while (trial < size_ - 1 && Clock::now() < deadline) std::this_thread::sleep_for(shortest_sleep);
    return trial == size_ - 1;
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
  bool is_aborted_ = false;
};

}  // namespace

}  // namespace leadscrew::sweep

extern "C" leadscrew::sweep::World* leadscrew_make_world() {
  static leadscrew::sweep::MpiWorld world;
  return &world;
}
