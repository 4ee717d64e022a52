// The deviation told is the distance of Fréchet between words and program: against its recursion over dense samples of
// both (Eiter and Mannila, "Computing discrete Fréchet distance", 1994), on programs full of features smaller than the
// tolerance.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "track.hpp"

namespace leadscrew::referee::test {
namespace test_frechet {

const base::Period period{100'000};  // short: a·T²/8 is two nanometres
const machine::Machine mill = machine::mill3();

double squared_distance(const AxisVector& a, const AxisVector& b) {
  const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return x * x + y * y + z * z;
}

/// Points of the program in order, at most `step` apart along it.
Words points_of(const Program& program, double step) {
  Words points{program.moves.front().start};
  for (const Move& move : program.moves) {
    const int count = 1 + static_cast<int>(length_of(move) / step);
    for (int i = 1; i <= count; ++i) points.push_back(position_on(move, static_cast<double>(i) / count));
  }
  return points;
}

/// Each point replaced by the mean of as many as `width` before and after it; both ends stay.
Words smoothed(const Words& points, std::size_t width) {
  Words sums{AxisVector{}};
  for (const AxisVector& point : points) {
    AxisVector sum = sums.back();
    for (std::size_t k = 0; k < base::axis_count; ++k) sum[k] += point[k];
    sums.push_back(sum);
  }
  Words words = points;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const std::size_t half = std::min({width, i, points.size() - 1 - i});
    for (std::size_t k = 0; k < base::axis_count; ++k) {
      words[i][k] = (sums[i + half + 1][k] - sums[i - half][k]) / static_cast<double>(2 * half + 1);
    }
  }
  return words;
}

/// By the figure: the words keep no limit, and of so many violations not all are listed.
bool departs(const Verdict& verdict, double tolerance) {
  return verdict.deviation_mm > tolerance + 1e-6 && verdict.objects();
}

double discrete_frechet(const Words& a, const Words& b) {
  std::vector<double> row(b.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < a.size(); ++i) {
    double diagonal = i == 0 ? 0 : std::numeric_limits<double>::infinity();
    double left = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < b.size(); ++j) {
      const double above = row[j];
      left = std::max(squared_distance(a[i], b[j]), std::min({left, above, diagonal}));
      row[j] = left;
      diagonal = above;
    }
  }
  return std::sqrt(row.back());
}

/// Arcs and helices of several turns, spikes, tiny segments and reversals, about as large as `size`.
Program tangle(std::mt19937_64& random, double size) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Program program;
  program.fed(10).line(uniform(-8, 8) * size, uniform(-8, 8) * size);
  const int blocks = 2 + static_cast<int>(random() % 3);
  for (int block = 0; block < blocks; ++block) {
    const AxisVector here = program.position;
    AxisVector end = here;
    switch (random() % 5) {
      case 0:
      case 1: {
        const auto plane = static_cast<gcode::Plane>(random() % 3);
        const Axis first = gcode::first_axis(plane), second = gcode::second_axis(plane);
        const double radius = size * uniform(0.3, 1.2), angle = uniform(0, 2 * std::numbers::pi);
        const double center_first = at(here, first) + radius * std::cos(angle);
        const double center_second = at(here, second) + radius * std::sin(angle);
        const double true_radius = std::hypot(at(here, first) - center_first, at(here, second) - center_second);
        if (random() % 2 == 0) {
          const double end_angle = uniform(0, 2 * std::numbers::pi);
          at(end, first) = center_first + true_radius * std::cos(end_angle);
          at(end, second) = center_second + true_radius * std::sin(end_angle);
        }
        if (random() % 2 == 0) at(end, gcode::normal_axis(plane)) += size * uniform(-2, 2);
        const int turns = 1 + static_cast<int>(random() % 5);
        program.arc(end, plane, center_first, center_second, random() % 2 == 0 ? turns : -turns);
        break;
      }
      case 2:  // a spike
        program.line(at(here, Axis::X) + size * uniform(-2, 2), at(here, Axis::Y) + size * uniform(-2, 2)).line(here);
        break;
      case 3:  // tiny segments
        for (int i = 0; i < 30; ++i) {
          program.line(at(program.position, Axis::X) + size * uniform(-0.2, 0.3),
                       at(program.position, Axis::Y) + size * uniform(-0.2, 0.2));
        }
        break;
      default:
        at(end, Axis::Z) += size * uniform(-1, 1);
        at(end, Axis::X) += size * uniform(-4, 4);
        program.line(end);
    }
  }
  return program.line(uniform(-8, 8) * size, uniform(-8, 8) * size);
}

/// A smoothed tangle judged with a tolerance that it keeps and with one that it does not; empty if both are right.
std::string problem_of_tangle(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const double sizes[] = {0.005, 0.1, 3};
  const double size = sizes[random() % 3], step = 0.04 * size, sampling = 2 * step;
  Program program = tangle(random, size);
  const Words points = points_of(program, step);
  const Words words = smoothed(points, 5 + random() % 150);
  const double truth = discrete_frechet(words, points);
  const auto judge_with = [&](double tolerance) {
    for (Move& move : program.moves) {
      move.path_mode = gcode::PathMode::blend;
      move.tolerance = tolerance;
    }
    return judge(program.moves, words, mill, period);
  };
  const auto told = [&](const char* what, double tolerance, const Verdict& verdict) {
    return what + (", truly " + std::to_string(truth) + " of " + std::to_string(tolerance) + ": ") + describe(verdict);
  };
  const double wide = truth * std::uniform_real_distribution<double>(1, 2)(random) + sampling;
  const Verdict kept = judge_with(wide);
  if (departs(kept, wide)) return told("objects", wide, kept);
  if (kept.deviation_mm < truth - sampling) return told("too little", wide, kept);
  if (kept.deviation_mm > truth + wide / 8) return told("too much", wide, kept);
  if (truth < 3 * sampling) return {};
  const double tight = 0.99 * (truth - sampling);
  const Verdict broken = judge_with(tight);
  if (!departs(broken, tight)) return told("does not object", tight, broken);
  if (broken.deviation_mm < truth - sampling) return told("too little", tight, broken);
  return {};
}

TEST(Frechet, IsTheDeviationOfSmoothedTangles) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) EXPECT_EQ(problem_of_tangle(seed), "") << "seed " << seed;
}

RC_GTEST_PROP(LongFrechet, IsTheDeviationOfSmoothedTangles, (std::uint64_t seed)) {
  const std::string problem = problem_of_tangle(seed);
  if (!problem.empty()) RC_FAIL(problem);
}

/// Whole turns of a circle of this diameter between two lines, with so many of them in the program and in the motion.
Verdict judge_turns(double diameter, int programmed, int made, double tolerance) {
  const auto circles = [&](int turns) {
    Program program;
    program.blended(tolerance).fed(10).line(5 * diameter, 0);
    if (turns > 0) program.circle(5 * diameter, diameter / 2, turns);
    return program.line(5 * diameter, -5 * diameter);
  };
  return judge(circles(programmed).moves, points_of(circles(made), 0.02 * diameter), mill, period);
}

TEST(Frechet, ATurnTooFewOrTooManyIsTheDiameter) {
  for (const double tolerance : {0.002, 0.5}) {
    for (const auto& [programmed, made] : {std::pair{5, 4}, {4, 5}, {1, 0}, {0, 1}}) {
      for (const double diameters : {0.5, 0.98, 1.05, 2.1, 5.0}) {
        const double diameter = diameters * tolerance;
        const Verdict verdict = judge_turns(diameter, programmed, made, tolerance);
        const bool found = departs(verdict, tolerance);
        EXPECT_EQ(found, diameter > tolerance) << programmed << " " << made << " " << diameters << describe(verdict);
        EXPECT_GE(verdict.deviation_mm, 0.98 * diameter) << programmed << " " << made << " " << diameters;
        if (diameter < tolerance) {
          EXPECT_LE(verdict.deviation_mm, diameter + tolerance / 8) << programmed << " " << made << " " << diameters;
        }
      }
    }
  }
}

TEST(Frechet, ARunBackIsHalfItsLength) {
  // Near the end of a block, where a motion may have been made smooth over what follows.
  const double tolerance = 0.1;
  for (const double back : {0.11, 0.15, 0.18, 0.21, 0.4}) {
    Program program, made;
    program.blended(tolerance).fed(10).line(5, 0).line(5, 5);
    made.fed(10).line(4.9, 0).line(4.9 - back, 0).line(5, 0).line(5, 5);
    const Verdict verdict = judge(program.moves, points_of(made, 0.001), mill, period);
    EXPECT_EQ(departs(verdict, tolerance), back > 2 * tolerance) << back << describe(verdict);
    EXPECT_GE(verdict.deviation_mm, back / 2 - 0.001);
    if (back < 2 * tolerance) {
      EXPECT_LE(verdict.deviation_mm, back / 2 + tolerance / 8);
    }
  }
}

}  // namespace test_frechet
}  // namespace leadscrew::referee::test
