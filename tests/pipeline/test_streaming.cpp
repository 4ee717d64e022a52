#include <gtest/gtest.h>

#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <leadscrew/pipeline/program.hpp>
#include <sanitizers.hpp>

// Long programs in constant memory. Resident memory is the process': its peak must not grow with the blocks read.

namespace test_streaming {

using namespace leadscrew;

/// Arcs of one circle of 20 mm, 0.05 to 0.3 mm long, travelled again and again: one section without an end. The text is
/// made as it is read.
class ShortArcs {
 public:
  explicit ShortArcs(std::int64_t blocks) : left_(blocks) {}

  base::Result<std::size_t> operator()(std::span<char> buffer) {
    std::size_t count = 0;
    while (count < buffer.size()) {
      if (at_ == size_ && !write()) break;
      buffer[count++] = line_[at_++];
    }
    return count;
  }

 private:
  bool write() {
    at_ = 0;
    if (!begun_) {
      begun_ = true;
      size_ = std::snprintf(line_, sizeof line_, "G21 G90 G17 G64\nG0 X20 Y0\nF6000\n");
      return true;
    }
    if (left_-- <= 0) {
      size_ = left_ == -1 ? std::snprintf(line_, sizeof line_, "M2\n") : 0;
      return size_ > 0;
    }
    // A linear congruence, for lengths that do not repeat.
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    const double share = static_cast<double>(state_ >> 40) / 0x1p24;
    const double x = radius * std::cos(angle_), y = radius * std::sin(angle_);
    angle_ += (0.05 + 0.25 * share) / radius;
    size_ = std::snprintf(line_, sizeof line_, "G3 X%.12f Y%.12f I%.12f J%.12f\n", radius * std::cos(angle_),
                          radius * std::sin(angle_), -x, -y);
    return true;
  }

  static constexpr double radius = 20;
  std::int64_t left_;
  bool begun_ = false;
  char line_[128];
  int at_ = 0, size_ = 0;
  double angle_ = 0;
  std::uint64_t state_ = 1;
};

/// Peak resident memory of the process so far, bytes.
std::int64_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

using testing_support::is_sanitized;

void streams_in_constant_memory(std::int64_t blocks) {
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools;
  std::int64_t errors = 0;
  pipeline::Program program(ShortArcs(blocks), machine, tools, {}, [&](const base::Diagnostic&) { ++errors; });
  std::int64_t early = 0;
  double fastest = 0, slowest = 1e300, last_length = 0;
  const auto begin = std::chrono::steady_clock::now();
  while (program.prepare()) {
    const base::Word word = program.cycle();
    const double speed = (word.path_length - last_length) / machine.period.seconds();
    last_length = word.path_length;
    const std::int64_t read = program.summary().blocks;
    if (early == 0 && read >= blocks / 10) early = peak_memory();
    if (read > blocks / 10 && read < blocks) {
      fastest = std::max(fastest, speed);
      slowest = std::min(slowest, speed);
    }
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const std::int64_t grown = peak_memory() - early;
  std::printf("%lld short arcs: %.0f blocks/s, %.1f s, peak memory grows by %lld bytes to %lld\n",
              static_cast<long long>(blocks), static_cast<double>(blocks) / seconds, seconds,
              static_cast<long long>(grown), static_cast<long long>(peak_memory()));
  EXPECT_EQ(errors, 0);
  EXPECT_EQ(program.summary().moves, blocks + 1);
  EXPECT_GT(early, 0);
  if (!is_sanitized) {
    EXPECT_LT(grown, 1'000'000);
  }
  // It does not stop on the way: the greatest speed is kept all along.
  EXPECT_NEAR(fastest, 100, 0.1);
  EXPECT_NEAR(slowest, 100, 0.1);
}

TEST(StreamedArcs, TakeNoMoreMemoryTheLongerTheyGoOn) {
  streams_in_constant_memory(is_sanitized ? 20'000 : 60'000);
}
TEST(LongStreamedArcs, TakeNoMoreMemoryTheLongerTheyGoOn) {
  streams_in_constant_memory(1'000'000);
}

}  // namespace test_streaming
