// A planner and a cycle in threads of their own, as fast as they can, neither waiting for the other.

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <leadscrew/interpolator/controller.hpp>
#include <mixed_paths.hpp>
#include <random>
#include <smooth_words.hpp>
#include <thread>

namespace test_controller_threads {

using namespace leadscrew;
using namespace testing_support;
using interpolator::Controller;
using Offer = Controller::Offer;
using Clock = std::chrono::steady_clock;

/// Goes round a closed path for some time in chunks of random size; whenever it is late, plans anew from where the last
/// accepted chunk comes to rest.
class Rounds {
 public:
  Rounds(Controller& controller, const Path& path) : controller_(controller), path_(path) {}

  void run(Clock::duration time) {
    const auto end = Clock::now() + time;
    do {
      at_ = 0;
      while (path_.length() - at_ > 1e-9) go_on();
      ++laps_;
    } while (Clock::now() < end);
    while (!controller_.idle()) {
      step();
      std::this_thread::yield();
    }
  }

  /// Waits until the planner has done something, or is done.
  void wait_for_step(const std::atomic<bool>& done) const {
    const std::int64_t before = steps_.load(std::memory_order_relaxed);
    while (steps_.load(std::memory_order_relaxed) == before && !done.load(std::memory_order_relaxed))
      std::this_thread::yield();
  }

  std::int64_t laps() const { return laps_; }
  std::int64_t replans() const { return replans_; }
  std::int64_t continued() const { return continued_; }

 private:
  // Relaxed, so that it orders nothing that the controller should.
  void step() { steps_.fetch_add(1, std::memory_order_relaxed); }

  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }

  void go_on() {
    const double seconds = std::exp(uniform(std::log(0.0005), std::log(0.3)));
    for (CutChunk& cut : cut_motion(path_, at_, path_.length(), uniform(20, 100), path_jerk, seconds)) {
      if (uniform(0, 1) < 0.05) pause(uniform(0, 200e-6));
      Offer answer = controller_.offer(cut.chunk);
      step();
      for (; answer == Offer::full; answer = controller_.offer(cut.chunk)) {
        step();
        std::this_thread::yield();
      }
      if (answer == Offer::late) {
        ++replans_;
        return;
      }
      if (cut.begin != at_) ++continued_;
      at_ = cut.rest;
    }
  }

  void pause(double seconds) {
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    while (Clock::now() < end) {
    }
  }

  Controller& controller_;
  const Path& path_;
  double at_ = 0;  ///< where the last accepted chunk comes to rest
  std::int64_t laps_ = 0, replans_ = 0, continued_ = 0;
  std::minstd_rand random_{20};
  std::atomic<std::int64_t> steps_{0};
};

void hammer(std::size_t capacity) {
  const Path path = stadium();
  Controller controller(path_period, {}, capacity);
  SmoothWords words(path, path_jerk, path_period);
  Rounds rounds(controller, path);
  std::atomic<bool> done{false};
  std::thread cycle([&] {
    // Here and there the planner gets time, whatever else this computer does: it must be late often, but not always.
    std::minstd_rand random{7};
    while (!done.load(std::memory_order_relaxed)) {
      words.look(controller.next());
      if (random() % 64 == 0) rounds.wait_for_step(done);
    }
  });
  rounds.run(std::chrono::milliseconds(500));
  done = true;
  cycle.join();
  words.look(controller.next());
  EXPECT_EQ(words.gaps(), 0);
  EXPECT_LT(words.jerk(), 1 + 1e-4);
  // Where laps meet, 1e-7 to either side is the end of one; and each may end 1e-9 short of the path.
  EXPECT_LT(words.aside(), 1e-7 + 1e-9 * static_cast<double>(rounds.laps()));
  EXPECT_NEAR(words.last().path_length, static_cast<double>(rounds.laps()) * path.length(), 1e-6);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(words.last().position[i], 0, 1e-9);
  EXPECT_GE(controller.starvations(), rounds.replans());
  // The test means something only if both happened.
  EXPECT_GT(rounds.replans(), 0);
  EXPECT_GT(rounds.continued(), 0);
  testing::Test::RecordProperty("words", static_cast<int>(words.count()));
  testing::Test::RecordProperty("replans", static_cast<int>(rounds.replans()));
  testing::Test::RecordProperty("continued", static_cast<int>(rounds.continued()));
}

TEST(TwoThreads, HandOverWithoutAJump) {
  hammer(8);
}

TEST(TwoThreads, HandOverWithoutAJumpThroughTheSmallestRing) {
  hammer(2);
}

}  // namespace test_controller_threads
