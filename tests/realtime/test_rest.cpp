// Words cease at any instant: where the drives come to rest.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/realtime/word_stream.hpp>
#include <memory>

#include "differences.hpp"
#include "live.hpp"

namespace test_rest {

using namespace leadscrew;
using testing_support::words_of;
using testing_support::worst_ratio;

/// Turns back where the travel of X ends, and touches its end once more along an arc.
const std::string at_the_end_of_travel =
    "G21 G90 G94 G17 F12000\nG64 P0.05\nG1 X30\nG1 X5 Y8\nG1 X20 Y18\nG3 X20 Y38 I0 J10\nG1 X0\nM2\n";

machine::Machine short_mill() {
  machine::Machine machine = machine::mill3();
  machine.axes[0]->travel_max = 30;
  return machine;
}

double to_line(double x, double y, double x0, double y0, double x1, double y1) {
  const double dx = x1 - x0, dy = y1 - y0;
  const double share = std::clamp(((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(x - x0 - share * dx, y - y0 - share * dy);
}

/// To what is programmed.
double distance(const base::AxisVector& q) {
  const double x = q[0], y = q[1];
  const double lines = std::min({to_line(x, y, 0, 0, 30, 0), to_line(x, y, 30, 0, 5, 8), to_line(x, y, 5, 8, 20, 18),
                                 to_line(x, y, 20, 38, 0, 38)});
  return x < 20 ? lines : std::min(lines, std::abs(std::hypot(x - 20, y - 28) - 10));
}

/// The whole program: fewer chunks than a controller holds, so that none is late.
std::vector<planner::Chunk> chunks_of(const std::string& text, const machine::Machine& machine) {
  const machine::ToolTable tools;
  pipeline::MotionSource source(gcode::text_source(text), machine, tools, {}, nullptr);
  source.planner().slice(0.04);
  std::vector<planner::Chunk> chunks;
  while (auto chunk = source.next()) chunks.push_back(std::move(*chunk));
  return chunks;
}

/// The drives' side of a run whose maker is gone after so many words: every position, one a period.
class Abandoned {
 public:
  std::vector<base::AxisVector> q;
  std::size_t words = 0, stop_path = 0;  ///< of these

  Abandoned(const machine::Machine& machine, const std::vector<planner::Chunk>& chunks, std::int64_t last_word) {
    // Far ahead: no word waits for its time.
    auto chunk = chunks.begin();
    const auto next = [&] { return chunk == chunks.end() ? std::nullopt : std::optional(*chunk++); };
    realtime::Runner runner(
        {.period = machine.period, .look_ahead = 60, .lead = 1'000'000, .slice = 20},
        {.next = next, .refuse = [] {}, .override_feed = [](double) {}},
        {.take = [&](const base::Word& word) { return stream_->push(word); },
         .append_stop_position = [&](const base::PathPlace& to) { return stream_->append_stop_position(to); },
         .publish = [&, last_word] { return taken() <= last_word && stream_->publish(); }});
    runner.start();
    while (!runner.has_ended()) realtime::sleep_until(realtime::now() + 100'000);
    EXPECT_EQ(runner.counters().starvations, 0);
    EXPECT_FALSE(runner.counters().too_long_to_rest);
    come_to_rest();
  }

 private:
  using Stream = realtime::WordStream<4096, 1024>;

  std::int64_t taken() const { return static_cast<std::int64_t>(stream_->waiting()); }
  void come_to_rest() {
    base::Word word;
    while (stream_->pop(word)) q.push_back(word.position);
    words = q.size();
    EXPECT_TRUE(stream_->leave_if_empty());
    for (base::PathPlace place; stream_->follow_stop_path(place);) q.push_back(place.position);
    stop_path = q.size() - words;
  }

  std::unique_ptr<Stream> stream_ = std::make_unique<Stream>();
};

TEST(Rest, IsOnThePathWithinTravelAndLimitsWheneverWordsCease) {
  const machine::Machine machine = short_mill();
  const std::vector<base::Word> words = words_of(at_the_end_of_travel, machine);
  const std::vector<planner::Chunk> chunks = chunks_of(at_the_end_of_travel, machine);
  ASSERT_LT(chunks.size(), 60U);
  std::size_t longest = 0, in_motion = 0;
  for (std::size_t last = 1; last < words.size(); last += 7) {
    Abandoned drives(machine, chunks, static_cast<std::int64_t>(last));
    longest = std::max(longest, drives.stop_path);
    in_motion += drives.stop_path > 20;
    // A slice at most is not seen any more.
    ASSERT_LE(drives.words, last);
    ASSERT_GE(drives.words + 20, std::min(last, words.size()));
    for (std::size_t k = 0; k < std::min(drives.words, words.size()); ++k) {
      ASSERT_EQ(drives.q[k], words[k].position) << k;
    }
    for (const base::AxisVector& q : drives.q) {
      ASSERT_LE(distance(q), 0.05 * (1 + 1e-6)) << last;
      ASSERT_LE(q[0], 30) << last;
    }
    drives.q.insert(drives.q.begin(), 3, words[0].position);
    for (int tick = 0; tick < 3; ++tick) drives.q.push_back(drives.q.back());
    ASSERT_LE(worst_ratio(drives.q, machine, 3), 1.001) << last;
  }
  EXPECT_GT(in_motion, 100U);
  // Along a line a stop from full speed takes v/a + a/J = 0.25 s.
  EXPECT_LE(longest, 700U);
}

}  // namespace test_rest
