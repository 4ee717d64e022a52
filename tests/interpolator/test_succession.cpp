#include <gtest/gtest.h>

#include <array>
#include <condition_variable>
#include <functional>
#include <leadscrew/interpolator/succession.hpp>
#include <mutex>
#include <thread>
#include <vector>

// Planner and cycle over the succession of chunks, in every interleaving of their accesses to shared memory.

namespace test_succession {

using namespace leadscrew;

/// Runs two sides by turns. Each asks for its turn before every access; who gets it is read from a list of choices, and
/// once that is over the first side that can go on does.
class Turns {
 public:
  explicit Turns(std::vector<std::size_t> choices) : choices_(std::move(choices)) {}

  void run(const std::function<void()>& planner, const std::function<void()>& cycle) {
    std::thread first([&] { play(0, planner); }), second([&] { play(1, cycle); });
    first.join();
    second.join();
  }
  /// The next list of choices, depth first; false behind the last.
  bool advance() {
    while (!choices_.empty() && (choices_.back() == 1 || !was_free_[choices_.size() - 1])) choices_.pop_back();
    if (choices_.empty()) return false;
    choices_.back() = 1;
    return true;
  }
  const std::vector<std::size_t>& choices() const { return choices_; }

  static void await() { mine->turns->ask(mine->side); }

 private:
  struct Me {
    Turns* turns;
    std::size_t side;
  };
  static thread_local Me* mine;

  void play(std::size_t side, const std::function<void()>& work) {
    Me me{this, side};
    mine = &me;
    ask(side);  // nothing happens before both are there
    work();
    const std::lock_guard lock(mutex_);
    ended_[side] = true;
    running_ = false;
    give_turn();
    changed_.notify_all();
  }

  void ask(std::size_t side) {
    std::unique_lock lock(mutex_);
    waits_[side] = true;
    if (turn_ == side) running_ = false;
    give_turn();
    changed_.notify_all();
    changed_.wait(lock, [&] { return running_ && turn_ == side; });
    waits_[side] = false;
  }

  /// To one that waits, when both wait or have ended.
  void give_turn() {
    const auto is_ready = [&](std::size_t side) { return waits_[side] || ended_[side]; };
    if (running_ || !is_ready(0) || !is_ready(1) || (ended_[0] && ended_[1])) return;
    const bool is_free = !ended_[0] && !ended_[1];
    if (next_ == choices_.size()) choices_.push_back(ended_[0] ? 1 : 0);
    was_free_.resize(choices_.size());
    was_free_[next_] = is_free;
    turn_ = is_free ? choices_[next_] : ended_[0] ? 1 : 0;
    ++next_;
    running_ = true;
  }

  std::vector<std::size_t> choices_;
  std::vector<bool> was_free_;
  std::size_t next_ = 0, turn_ = 2;
  bool running_ = false;
  std::array<bool, 2> waits_{}, ended_{};
  std::mutex mutex_;
  std::condition_variable changed_;
};
thread_local Turns::Me* Turns::mine = nullptr;

template <class Value>
class ByTurns {
 public:
  ByTurns(Value value) : value_(value) {}  // NOLINT: as std::atomic
  Value load(std::memory_order) const {
    Turns::await();
    return value_;
  }
  void store(Value value, std::memory_order) {
    Turns::await();
    value_ = value;
  }
  bool compare_exchange_strong(Value& expected, Value desired, std::memory_order, std::memory_order = {}) {
    Turns::await();
    if (value_ != expected) {
      expected = value_;
      return false;
    }
    value_ = desired;
    return true;
  }

 private:
  Value value_;
};

constexpr std::size_t chunks = 3;  // behind standing at the start

/// As Controller::offer and Controller::go_on use the succession, and nothing else.
struct Model {
  std::array<interpolator::Succession<ByTurns>, chunks + 1> links;
  std::array<bool, chunks + 1> begins_at_rest{};
  std::size_t reached = 0;  ///< the cycle's
  std::size_t stops = 0;    ///< tails that have run
  std::size_t late = 0;     ///< chunks that the planner has had refused
  bool has_stopped = true;  ///< has the chunk in motion come to rest?
  bool has_jumped = false;  ///< has motion gone on that had been stopped?

  void plan() {
    for (std::size_t next = 1; next <= chunks; ++next) {
      links[next].reset(false);
      begins_at_rest[next] = next == 1;
      if (next > 1) {
        if (!links[next - 1].is_closed() && links[next - 1].follow()) continue;
        ++late;  // refused: planned anew from rest
        begins_at_rest[next] = true;
      }
      links[next - 1].follow_at_rest();
    }
  }

  void cycle(int words) {
    for (int word = 0; word < words; ++word) go_on();
  }
  void go_on() {
    const bool is_followed = links[reached].claim();
    if (!has_stopped && !(is_followed && !begins_at_rest[reached + 1])) {
      has_stopped = true;
      ++stops;
      return;
    }
    if (!is_followed) return;
    ++reached;
    if (has_stopped && !begins_at_rest[reached]) has_jumped = true;
    has_stopped = false;
  }
};

TEST(Succession, NeverGoesOnWithMotionThatWasStoppedInAnyInterleaving) {
  std::int64_t interleavings = 0, with_late = 0, without_stop = 0;
  for (std::vector<std::size_t> choices;;) {
    Turns run(choices);
    Model model;
    run.run([&] { model.plan(); }, [&] { model.cycle(5); });
    // What was accepted is reached, however late the cycle looks.
    Turns rest({});
    rest.run([] {}, [&] { model.cycle(3 * static_cast<int>(chunks)); });
    ++interleavings;
    with_late += model.late > 0;
    without_stop += model.late == 0 && model.stops == 1;
    ASSERT_FALSE(model.has_jumped) << testing::PrintToString(run.choices());
    ASSERT_EQ(model.reached, chunks) << testing::PrintToString(run.choices());
    ASSERT_LE(model.late, model.stops) << testing::PrintToString(run.choices());
    if (!run.advance()) break;
    choices = run.choices();
  }
  // All that can happen has.
  EXPECT_GT(interleavings, 100);
  EXPECT_GT(with_late, 0);
  EXPECT_GT(without_stop, 0);
}

}  // namespace test_succession
