// What the planner holds while an endless section streams through it.

#include <gtest/gtest.h>

#include <allocations.hpp>
#include <array>
#include <numbers>
#include <planned.hpp>
#include <six_axes.hpp>

namespace test_memory {

using namespace leadscrew;

constexpr std::int64_t two_megabytes = 2'000'000;

struct Unchanged {
  void begin(planner::Planner&) {}
  void after(planner::Planner&, const planner::Chunk&) {}
};

/// Pushes pieces as the planner wants them and throws chunks away.
template <typename NextPiece, typename Feed = Unchanged>
std::int64_t most_memory(const machine::Machine& machine, const geometry::Point& start, int pieces, NextPiece next,
                         Feed feed = {}) {
  const std::int64_t before = testing_support::memory_held();
  testing_support::watch_memory();
  planner::Planner planner(machine, start);
  feed.begin(planner);
  std::int64_t chunks = 0;
  const auto take_chunks = [&] {
    while (const std::optional<planner::Chunk> chunk = planner.pop()) {
      ++chunks;
      feed.after(planner, *chunk);
    }
  };
  for (int k = 0; k < pieces; ++k) {
    planner.push(next());
    take_chunks();
  }
  planner.finish();
  take_chunks();
  EXPECT_GT(chunks, 2);
  EXPECT_EQ(planner.refused_windows(), 0);
  return testing_support::most_memory_held() - before;
}

TEST(PlannerMemory, OfShortArcsIsBelowTwoMegabytes) {
  const machine::Machine machine = machine::mill3();
  geometry::Point at{10};
  const std::int64_t most = most_memory(machine, at, 20'000, [&] {
    const toolpath::Piece piece = testing_support::arc_piece(at, 0, 0, 0.01, 100);
    at = geometry::end(piece.curve);
    return piece;
  });
  EXPECT_LT(most, two_megabytes);
  RecordProperty("bytes", std::to_string(most));
}

TEST(PlannerMemory, OfCurvesInSixAxesIsBelowTwoMegabytes) {
  const machine::Machine machine = testing_support::mill_of_six_axes();
  testing_support::CurveInSixAxes curve(50);
  const std::int64_t most = most_memory(machine, curve.start(), 1000, [&] { return curve.next(); });
  EXPECT_LT(most, two_megabytes);
  RecordProperty("bytes", std::to_string(most));
}

/// Three times a second, from the twentieth of the programmed feed to twice as much.
class RestlessFeed {
 public:
  void begin(planner::Planner& planner) { planner.slice(0.02); }
  void after(planner::Planner& planner, const planner::Chunk& chunk) {
    since_ += chunk.duration.value();
    if (since_ < 0.3) return;
    since_ = 0;
    planner.override_feed(factors_[next_++ % factors_.size()]);
  }

 private:
  std::array<double, 10> factors_ = {0.05, 1, 0.3, 2, 0.05, 1, 0.1, 0.5, 1, 0.07};
  std::size_t next_ = 0;
  double since_ = 0;
};

TEST(PlannerMemory, IsBelowTwoMegabytesWhileTheFeedChanges) {
  const machine::Machine machine = testing_support::mill_of_six_axes();
  testing_support::CurveInSixAxes curve(50);
  const auto next = [&] { return curve.next(); };
  const std::int64_t most = most_memory(machine, curve.start(), 100, next, RestlessFeed());
  EXPECT_LT(most, two_megabytes);
  RecordProperty("bytes", std::to_string(most));
}

/// A helix of a hundred turns, R 10 mm, in one piece: 6.3 m without a break.
TEST(PlannerMemory, OfOneLongPieceIsBelowTwoMegabytesAtAHundredthOfTheFeed) {
  struct Slow {
    void begin(planner::Planner& planner) {
      planner.slice(0.02);
      planner.override_feed(0.01);
    }
    void after(planner::Planner& planner, const planner::Chunk& chunk) {
      planned_ += chunk.duration.value();
      if (planned_ > 2) planner.override_feed(1);
    }
    double planned_ = 0;
  };
  const machine::Machine machine = machine::mill3();
  const geometry::Point start{10};
  geometry::Point end = start;
  end[2] = 100;
  const double angle = 200 * std::numbers::pi, length = geometry::Arc::helix_length(10, angle, 100);
  const toolpath::Piece helix{geometry::Arc(start, end, 0, 1, 0, 0, angle, length), 100, {}};
  const std::int64_t most = most_memory(machine, start, 1, [&] { return helix; }, Slow());
  EXPECT_LT(most, two_megabytes);
  RecordProperty("bytes", std::to_string(most));
}

}  // namespace test_memory
