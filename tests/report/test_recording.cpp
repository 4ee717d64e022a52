#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <leadscrew/report/path_thinning.hpp>
#include <leadscrew/report/recording.hpp>
#include <map>

#include "byte_sinks.hpp"

namespace leadscrew::report {
namespace test_recording {

using namespace testing_support;

machine::Machine five_axes() {
  machine::Machine machine = machine::mill3();
  machine.axes[base::index(base::Axis::A)] = machine::AxisLimits{-120, 120, 90, 400, 6000, 0.001};
  machine.axes[base::index(base::Axis::C)] = machine::AxisLimits{-360, 360, 90, 400, 6000, 0.001};
  return machine;
}

/// Position, velocity, acceleration, jerk of every word, standing still before the first.
std::vector<std::array<double, 4>> derivatives(const std::vector<base::Word>& words, base::Axis axis) {
  std::vector<std::array<double, 4>> all;
  const auto q = [&](std::size_t i, std::size_t back) {
    return words[i < back ? 0 : i - back].position[base::index(axis)];
  };
  for (std::size_t i = 0; i < words.size(); ++i) {
    const double a = q(i, 0) - q(i, 1), b = q(i, 1) - q(i, 2), c = q(i, 2) - q(i, 3);
    all.push_back({q(i, 0), a * 1e3, (a - b) * 1e6, ((a - b) - (b - c)) * 1e9});
  }
  return all;
}

void expect_brute_force(std::size_t count, std::uint64_t seed) {
  const machine::Machine machine = five_axes();
  const auto words = random_train(count, seed);
  Recording recording(machine, millisecond);
  for (const base::Word& word : words) recording.observe(word);
  RC_ASSERT(recording.words() == static_cast<std::int64_t>(count));
  const auto per_bin = static_cast<std::size_t>(std::llround(recording.bin_seconds() / 1e-3));
  const std::size_t bins = (count + per_bin - 1) / per_bin;
  RC_ASSERT(bins <= 4096u);
  RC_ASSERT(recording.feed().size() == bins);
  for (const base::Axis axis : base::all_axes) {
    RC_ASSERT(recording.axis(axis, 0).size() == (machine.has(axis) ? bins : 0));
    if (!machine.has(axis)) continue;
    const auto values = derivatives(words, axis);
    for (int order = 0; order < 4; ++order) {
      const auto extents = recording.axis(axis, order);
      const double rounding = 1e-12 * std::pow(1e3, order);
      for (std::size_t bin = 0; bin < bins; ++bin) {
        double least = INFINITY, greatest = -INFINITY;
        for (std::size_t i = bin * per_bin; i < std::min(count, (bin + 1) * per_bin); ++i) {
          least = std::min(least, values[i][static_cast<std::size_t>(order)]);
          greatest = std::max(greatest, values[i][static_cast<std::size_t>(order)]);
        }
        RC_ASSERT(std::fabs(extents[bin].least - least) <= rounding);
        RC_ASSERT(std::fabs(extents[bin].greatest - greatest) <= rounding);
      }
    }
  }
}

RC_GTEST_PROP(Recording, ExtentsEqualBruteForce, (std::uint16_t count, std::uint64_t seed)) {
  expect_brute_force(count % 20000, seed);
}

TEST(Recording, ExtentsEqualBruteForceAroundMerges) {
  for (const std::size_t count : {0, 1, 2, 4095, 4096, 4097, 8191, 8192, 8193, 16385}) {
    EXPECT_NO_THROW(expect_brute_force(count, count)) << count;
  }
}

/// Largest distance, in any coordinate, from a word to a polyline that is followed in order.
double departure(const std::vector<base::Word>& words, std::span<const PathPoint> path,
                 const machine::Machine& machine) {
  double worst = 0;
  std::size_t at = 0;
  const auto distance = [&](const base::Word& word, std::size_t segment) {
    const auto& a = path[segment].position;
    const auto& b = path[std::min(segment + 1, path.size() - 1)].position;
    double along = 0, length = 0;
    for (std::size_t i = 0; i < 9; ++i) {
      if (!machine.axes[i]) continue;
      along += (word.position[i] - a[i]) * (b[i] - a[i]);
      length += (b[i] - a[i]) * (b[i] - a[i]);
    }
    const double u = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
    double far = 0;
    for (std::size_t i = 0; i < 9; ++i) {
      if (machine.axes[i]) far = std::max(far, std::fabs(word.position[i] - a[i] - u * (b[i] - a[i])));
    }
    return far;
  };
  for (const base::Word& word : words) {
    double best = INFINITY;
    std::size_t best_at = at;
    for (std::size_t k = at; k < std::min(at + 3, path.size()); ++k) {
      if (distance(word, k) < best) {
        best = distance(word, k);
        best_at = k;
      }
    }
    at = best_at;
    worst = std::max(worst, best);
  }
  return worst;
}

TEST(Recording, ShortPathsAreKeptToHalfAMicrometre) {
  const machine::Machine machine = machine::mill3();
  std::vector<base::Word> words;
  for (int i = 0; i <= 10000; ++i) {
    base::Word word;
    word.tick = base::Tick{i};
    const double angle = i * 1e-3;
    word.position = {20 * std::cos(angle), 20 * std::sin(angle), i < 5000 ? 0 : (i - 5000) * 0.01};
    word.feed = 20;
    words.push_back(word);
  }
  Recording recording(machine, millisecond);
  for (const base::Word& word : words) recording.observe(word);
  EXPECT_LT(recording.path().size(), 3000u);
  EXPECT_EQ(recording.path().front().position, words.front().position);
  EXPECT_EQ(recording.path().back().position, words.back().position);
  EXPECT_LE(departure(words, recording.path(), machine), 0.001);
}

TEST(Recording, LongPathsStayBoundedAndFaithful) {
  const machine::Machine machine = machine::mill3();
  const auto words = random_train(400000, 9);
  Recording recording(machine, millisecond);
  std::size_t most = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    recording.observe(words[i]);
    if (i % 997 == 0) most = std::max(most, recording.path().size());
  }
  EXPECT_LE(most, 20000u);
  EXPECT_GT(recording.path().size(), 5000u);
  EXPECT_EQ(recording.path().back().position, words.back().position);
}

TEST(Recording, LookingAtItDoesNotChangeIt) {
  const machine::Machine machine = machine::mill3();
  Recording a(machine, millisecond), b(machine, millisecond);
  for (const base::Word& word : random_train(9000, 4)) {
    a.observe(word);
    b.observe(word);
    (void)a.path();
    (void)a.feed();
    (void)a.slowest_blocks();
  }
  ASSERT_EQ(a.path().size(), b.path().size());
  for (std::size_t i = 0; i < a.path().size(); ++i) ASSERT_EQ(a.path()[i].position, b.path()[i].position);
}

TEST(Recording, BlocksAreThoseOfAPlainSearch) {
  const machine::Machine machine = machine::mill3();
  const auto words = random_train(3000, 21);
  Recording recording(machine, millisecond);
  std::vector<BlockFigures> blocks;
  for (std::size_t i = 0; i < words.size(); ++i) {
    recording.observe(words[i]);
    if (i == 0 || words[i].line != words[i - 1].line) blocks.push_back({words[i].line, 0, 0, 0, 0, {}, 0});
    if (i > 0) blocks.back().duration += 1e-3;
    if (i > 0) blocks.back().length += words[i].path_length - words[i - 1].path_length;
    for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z}) {
      const std::vector<base::Word> tail(words.begin() + static_cast<std::ptrdiff_t>(i < 3 ? 0 : i - 3),
                                         words.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      const auto d = derivatives(tail, axis).back();
      const auto& limits = machine.limits(axis);
      for (const auto& [order, limit] :
           std::map<int, double>{{1, limits.velocity}, {2, limits.acceleration}, {3, limits.jerk}}) {
        const double ratio = std::fabs(d[static_cast<std::size_t>(order)]) / limit;
        if (ratio > blocks.back().worst_ratio) {
          blocks.back().worst_ratio = ratio;
          blocks.back().worst_axis = axis;
          blocks.back().worst_order = order;
        }
      }
    }
  }
  auto slow = blocks, near = blocks;
  std::ranges::stable_sort(slow, [](const auto& a, const auto& b) { return a.duration > b.duration + 1e-9; });
  std::ranges::stable_sort(near, [](const auto& a, const auto& b) { return a.worst_ratio > b.worst_ratio; });
  const auto slowest = recording.slowest_blocks();
  const auto nearest = recording.nearest_to_limit();
  ASSERT_EQ(slowest.size(), 10u);
  ASSERT_EQ(nearest.size(), 10u);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(slowest[i].line, slow[i].line);
    EXPECT_NEAR(slowest[i].duration, slow[i].duration, 1e-9);
    EXPECT_NEAR(slowest[i].length, slow[i].length, 1e-9);
    EXPECT_EQ(nearest[i].line, near[i].line);
    EXPECT_NEAR(nearest[i].worst_ratio, near[i].worst_ratio, 1e-5);
    EXPECT_EQ(nearest[i].worst_axis, near[i].worst_axis);
    EXPECT_EQ(nearest[i].worst_order, near[i].worst_order);
  }
}

TEST(Recording, AnEmptyOneIsEmpty) {
  const machine::Machine machine = machine::mill3();
  const Recording recording(machine, millisecond);
  EXPECT_EQ(recording.words(), 0);
  EXPECT_EQ(recording.seconds(), 0);
  EXPECT_TRUE(recording.feed().empty());
  EXPECT_TRUE(recording.path().empty());
  EXPECT_TRUE(recording.slowest_blocks().empty());
  EXPECT_TRUE(recording.axis(base::Axis::A, 1).empty());
}

RC_GTEST_PROP(Thinning, StaysWithinItsTolerance, (std::uint64_t seed, std::uint16_t count)) {
  const auto words = random_train(count % 2000 + 2, seed);
  const machine::Machine machine = machine::mill3();
  std::vector<PathPoint> points;
  for (const base::Word& word : words) points.push_back({word.position, word.feed});
  const double tolerance = std::ldexp(1e-4, static_cast<int>(seed % 12));
  thin(points, machine.axis_set(), {tolerance, 1e9});
  double worst = 0;
  std::size_t segment = 0, begin = 0;
  for (std::size_t i = 1; i < words.size(); ++i) {
    // Between two kept points every coordinate is within the tolerance of the line through them, over distance
    // travelled.
    if (words[i].position != points[segment + 1].position) continue;
    std::vector<double> travelled{0};
    for (std::size_t k = begin + 1; k <= i; ++k) {
      double step = 0;
      for (std::size_t a = 0; a < 3; ++a) step += std::fabs(words[k].position[a] - words[k - 1].position[a]);
      travelled.push_back(travelled.back() + step);
    }
    for (std::size_t k = begin; k <= i; ++k) {
      for (std::size_t a = 0; a < 3; ++a) {
        const double from = words[begin].position[a], to = words[i].position[a];
        worst = std::max(
            worst, std::fabs(words[k].position[a] - from - (to - from) * travelled[k - begin] / travelled.back()));
      }
    }
    begin = i;
    ++segment;
  }
  RC_ASSERT(segment + 1 == points.size());
  RC_ASSERT(worst <= tolerance * (1 + 1e-6));
}

}  // namespace test_recording
}  // namespace leadscrew::report
