// What is wrong with a trace is found, named, and found on the right line.

#include <gtest/gtest.h>

#include "track.hpp"

namespace leadscrew::referee::test {
namespace test_sabotage {

class Sabotage : public testing::TestWithParam<std::int64_t> {
 protected:
  machine::Machine machine = machine::mill3();
  base::Period period{GetParam()};

  /// A plate: approach, notch, arc, pocket, circle thrice, pocket, away.
  static Program plate() {
    Program program;
    program.fed(40).line(10, 0);                                  // 1
    program.line(20, 0).line(20, -5).line(25, -5).line(25, 0);    // 2 3 4 5: a notch 5 mm deep
    program.line(40, 0);                                          // 6
    program.arc({50, 10}, gcode::Plane::XY, 40, 10, 1);           // 7
    program.line(50, 20);                                         // 8
    program.line(56, 20).line(56, 26).line(50, 26).line(50, 20);  // 9 10 11 12: a pocket
    program.line(50, 40);                                         // 13
    program.circle(45, 40, 3);                                    // 14
    program.line(50, 60);                                         // 15
    program.line(56, 60).line(56, 66).line(50, 66).line(50, 60);  // 16 17 18 19: another pocket
    program.line(0, 60);                                          // 20
    return program;
  }

  Verdict judge_motion(const Program& program, const Words& words) const {
    return judge(program.moves, words, machine, period);
  }
  /// The program with lines first…last left out and the one before going on to the end of the last.
  static Program without(Program program, int first, int last) {
    auto& moves = program.moves;
    const AxisVector end = moves[static_cast<std::size_t>(last - 1)].end;
    moves.erase(moves.begin() + (first - 1), moves.begin() + last);
    if (static_cast<std::size_t>(first - 1) < moves.size()) {
      Move& next = moves[static_cast<std::size_t>(first - 1)];
      if (next.start != end) next.start = moves[static_cast<std::size_t>(first - 2)].end;
    }
    return program;
  }
  Words motion(const Program& program) const { return exact_motion(program, machine, period); }
};

TEST_P(Sabotage, NoneNoObjection) {
  const Verdict verdict = judge_motion(plate(), motion(plate()));
  EXPECT_FALSE(verdict.objects()) << describe(verdict);
  EXPECT_LE(verdict.deviation_mm, 1e-9);
  EXPECT_LE(verdict.feed_max_ratio, 0.9001);
  EXPECT_GE(verdict.feed_max_ratio, period.nanoseconds <= 1'000'000 ? 0.899 : 0.8);
  EXPECT_DOUBLE_EQ(verdict.feed_programmed_max, 40);
}

/// Motion that runs through where the program asks for rest; where it asks for none, it may.
TEST_P(Sabotage, RestLeftOut) {
  Program through, parted;
  through.fed(40).line(20, 0).line(20, 10);
  parted.fed(40).line(10, 0).line(20, 0).line(20, 10);
  const auto asked = [&](Move::Kind kind, base::Event::Kind event, bool waits) {
    Program program = parted;
    Move stand;
    stand.kind = kind;
    stand.start = stand.end = {10};
    stand.line = base::Line{7};
    stand.event = {event, 0, base::Line{7}, 0, waits};
    program.moves.insert(program.moves.begin() + 1, stand);
    return program;
  };
  using Kind = base::Event::Kind;
  for (const Program& program :
       {asked(Move::Kind::dwell, Kind::pause, true), asked(Move::Kind::event, Kind::pause, true),
        asked(Move::Kind::event, Kind::spindle_clockwise, true)}) {
    const Verdict sabotaged = judge_motion(program, motion(through)), kept = judge_motion(program, motion(parted));
    ASSERT_EQ(sabotaged.violation_count, 1) << describe(sabotaged);
    EXPECT_EQ(sabotaged.violations[0].what, "stop");
    EXPECT_EQ(base::number(sabotaged.violations[0].line), 7);
    EXPECT_GT(sabotaged.violations[0].value, sabotaged.violations[0].limit);
    EXPECT_FALSE(kept.objects()) << describe(kept);
  }
  const Program travels = asked(Move::Kind::event, Kind::spindle_speed, false);
  EXPECT_FALSE(judge_motion(travels, motion(through)).objects());
}

TEST_P(Sabotage, NotchSkipped) {
  Program short_cut = plate();
  short_cut.moves.erase(short_cut.moves.begin() + 2, short_cut.moves.begin() + 5);
  short_cut.moves[2].start = short_cut.moves[1].end;
  const Verdict verdict = judge_motion(plate(), motion(short_cut));
  EXPECT_TRUE(verdict.objects());
  EXPECT_GE(verdict.deviation_mm, 4.9) << describe(verdict);
  EXPECT_LE(verdict.deviation_mm, 7.2) << describe(verdict);
  EXPECT_TRUE(has(verdict, "skipped path", 3) || has(verdict, "skipped path", 4)) << describe(verdict);
  EXPECT_FALSE(has(verdict, "end"));
  for (const Violation& violation : verdict.violations) {
    EXPECT_GE(base::number(violation.line), 2) << describe(verdict);
    EXPECT_LE(base::number(violation.line), 6) << describe(verdict);
  }
}

TEST_P(Sabotage, PocketSkipped) {
  const Verdict verdict = judge_motion(plate(), motion(without(plate(), 9, 12)));
  EXPECT_GE(verdict.deviation_mm, 5.9) << describe(verdict);
  EXPECT_TRUE(has(verdict, "skipped path")) << describe(verdict);
  EXPECT_FALSE(has(verdict, "end"));
}

TEST_P(Sabotage, PocketsInReverseOrder) {
  Program swapped;
  swapped.moves = {};
  const Program program = plate();
  const auto go = [&](int first, int last) {
    for (int line = first; line <= last; ++line) {
      Move move = program.moves[static_cast<std::size_t>(line - 1)];
      if (move.start != swapped.position && move.kind == Move::Kind::line) move.start = swapped.position;
      swapped.moves.push_back(move);
      swapped.position = move.end;
    }
  };
  go(1, 8);
  go(15, 19);
  go(8, 14);
  go(20, 20);
  const Verdict verdict = judge_motion(program, motion(swapped));
  EXPECT_TRUE(has(verdict, "deviation") || has(verdict, "skipped path")) << describe(verdict);
  EXPECT_GE(verdict.deviation_mm, 5) << describe(verdict);
}

TEST_P(Sabotage, TwoTurnsInsteadOfThree) {
  Program two = plate();
  two.moves[13].turns = 2;
  const Verdict verdict = judge_motion(plate(), motion(two));
  EXPECT_GE(verdict.deviation_mm, 4.9) << describe(verdict);
  EXPECT_TRUE(has(verdict, "skipped path", 14) || has(verdict, "deviation", 14)) << describe(verdict);
  EXPECT_FALSE(has(verdict, "end"));
}

TEST_P(Sabotage, CircleTheWrongWay) {
  Program wrong = plate();
  wrong.moves[13].turns = -3;
  const Verdict verdict = judge_motion(plate(), motion(wrong));
  EXPECT_GE(verdict.deviation_mm, 4.9) << describe(verdict);
  EXPECT_TRUE(has(verdict, "deviation", 14)) << describe(verdict);
}

TEST_P(Sabotage, CornerCutByFiveMicrometres) {
  Program cut = plate();
  cut.moves[1].end[0] -= 0.005;  // line 2 ends early, line 3 begins lower
  cut.moves[2].start[1] -= 0.005;
  Move bevel = cut.moves[1];
  bevel.start = cut.moves[1].end;
  bevel.end = cut.moves[2].start;
  cut.moves.insert(cut.moves.begin() + 2, bevel);
  const Verdict verdict = judge_motion(plate(), motion(cut));
  ASSERT_TRUE(verdict.objects());
  if (period.nanoseconds <= 1'000'000) {
    EXPECT_NEAR(verdict.deviation_mm, 0.005 / std::sqrt(2), 0.0015) << describe(verdict);
  }
  for (const Violation& violation : verdict.violations) {
    EXPECT_TRUE(base::number(violation.line) == 2 || base::number(violation.line) == 3) << describe(verdict);
    EXPECT_TRUE(violation.what == "deviation" || violation.what == "skipped path") << describe(verdict);
  }
}

TEST_P(Sabotage, OffByTwoNanometres) {
  Words words = motion(plate());
  for (AxisVector& word : words) at(word, Axis::Z) += 2e-6;
  const Verdict verdict = judge_motion(plate(), words);
  EXPECT_NEAR(verdict.deviation_mm, 2e-6, 1e-10);
  EXPECT_TRUE(has(verdict, "start", 1));
  EXPECT_TRUE(has(verdict, "end", 20));
  EXPECT_GE(verdict.violation_count, static_cast<std::int64_t>(words.size()));
}

TEST_P(Sabotage, OffByHalfANanometreIsAllowed) {
  Words words = motion(plate());
  for (AxisVector& word : words) at(word, Axis::Z) += 0.5e-6;
  const Verdict verdict = judge_motion(plate(), words);
  EXPECT_NEAR(verdict.deviation_mm, 0.5e-6, 1e-10);
  EXPECT_FALSE(verdict.objects()) << describe(verdict);
}

TEST_P(Sabotage, OneWordOffByAMicrometre) {
  Words words = motion(plate());
  const std::size_t n = words.size() / 2;
  at(words[n], Axis::Z) += 1e-3;
  const Verdict verdict = judge_motion(plate(), words);
  EXPECT_NEAR(verdict.deviation_mm, 1e-3, 1e-9) << describe(verdict);
  int deviations = 0;
  for (const Violation& violation : verdict.violations) {
    if (violation.what != "deviation") continue;
    ++deviations;
    EXPECT_DOUBLE_EQ(violation.t, static_cast<double>(n) * period.seconds());
    EXPECT_NEAR(violation.value, 1e-3, 1e-9);
  }
  EXPECT_EQ(deviations, 1) << describe(verdict);
  EXPECT_EQ(has(verdict, "Z jerk"), period.nanoseconds <= 1'000'000);
}

TEST_P(Sabotage, StopsEarly) {
  Words words = motion(plate());
  while (at(words.back(), Axis::X) < 1) words.pop_back();
  const Verdict verdict = judge_motion(plate(), words);
  EXPECT_TRUE(has(verdict, "end", 20)) << describe(verdict);
  EXPECT_GT(verdict.end_error_mm, 0.9);
  EXPECT_DOUBLE_EQ(verdict.deviation_mm, verdict.end_error_mm);
}

TEST_P(Sabotage, LeavesOutTheLastBlocks) {
  Program most = plate();
  most.moves.resize(13);
  const Verdict verdict = judge_motion(plate(), motion(most));
  EXPECT_TRUE(has(verdict, "end", 20)) << describe(verdict);
  EXPECT_TRUE(has(verdict, "skipped path")) << describe(verdict);
  EXPECT_NEAR(verdict.end_error_mm, std::hypot(50, 20), 1e-9);
  EXPECT_NEAR(verdict.deviation_mm, std::hypot(50, 20), 1e-9);
}

TEST_P(Sabotage, StartsElsewhere) {
  Program late = plate();
  late.moves[0].start[0] = 3;
  const Verdict verdict = judge_motion(plate(), motion(late));
  EXPECT_TRUE(has_only(verdict, "start") && has(verdict, "start", 1)) << describe(verdict);
  EXPECT_NEAR(verdict.start_error_mm, 3, 1e-9);
  EXPECT_NEAR(verdict.deviation_mm, 3, 1e-9) << describe(verdict);
}

TEST_P(Sabotage, ABlockOnePercentTooFast) {
  Program program = plate();
  program.moves.clear();
  program.position = {};
  program.fed(20).line(40, 0);
  program.fed(10).line(40, 40);
  program.arc({40, 0}, gcode::Plane::XY, 40, 20, -1);
  program.fed(20).line(0, 0);
  for (const int line : {2, 3}) {
    std::vector<double> durations = durations_of(program.moves, machine);
    const Move& move = program.moves[static_cast<std::size_t>(line - 1)];
    for (const double ratio : {0.999, 1.01}) {
      durations[static_cast<std::size_t>(line - 1)] = law_velocity * length_of(move) / (ratio * 10);
      const Verdict verdict = judge_motion(program, sample(program.moves, durations, period));
      if (ratio < 1) {
        EXPECT_FALSE(verdict.objects()) << describe(verdict);
        EXPECT_NEAR(verdict.feed_max_ratio, ratio, 1e-4);
      } else {
        EXPECT_TRUE(has(verdict, "feed", line) && has_only(verdict, "feed")) << describe(verdict);
        EXPECT_NEAR(verdict.feed_max_ratio, ratio, 1e-4);
      }
    }
  }
}

TEST_P(Sabotage, ATightCircleHalfAPercentTooFast) {
  Program program;
  program.fed(20).circle(1, 0, 10);  // at 20 ms chords are 0.7 % shorter than the arc
  for (const double ratio : {0.9995, 1.005}) {
    const std::vector<double> duration = {law_velocity * length_of(program.moves[0]) / (ratio * 20)};
    const Verdict verdict = judge_motion(program, sample(program.moves, duration, period));
    EXPECT_NEAR(verdict.feed_max_ratio, ratio, 2e-4);
    EXPECT_EQ(has(verdict, "feed", 1), ratio > 1) << describe(verdict);
  }
}

TEST_P(Sabotage, ABulgeJumpedOverBetweenTwoWords) {
  // A quarter arc with both its ends on the line between two words; its middle is 0.29 mm away.
  Program program;
  const double half = std::sqrt(0.5);
  program.line(2 - half, 0).arc({2 + half}, gcode::Plane::XY, 2, -half, -1).line(4, 0);
  const Verdict verdict = judge_motion(program, {{0}, {1}, {3}, {4}});
  // X is seen to accelerate beyond its limit, Y and Z are not seen to: they may by what jerk allows in a period.
  const double unseen = std::min(1000.0, 20000 * period.seconds());
  const double excuse = std::hypot(1000, unseen, unseen) * period.seconds() * period.seconds() / 8;
  EXPECT_NEAR(verdict.deviation_mm, 1 - half - excuse, 1e-6) << describe(verdict);
  EXPECT_TRUE(has(verdict, "skipped path", 2)) << describe(verdict);
}

TEST_P(Sabotage, ANotchLeftOutAtConstantSpeed) {
  // Half of what the acceleration limits alone would excuse; words at constant speed show that there was no such
  // acceleration.
  const double limit_excuse = std::sqrt(3.0) * 1000 * period.seconds() * period.seconds() / 8;
  const double depth = limit_excuse / 2, step = 10 * period.seconds();
  Program program;
  program.line(50.5 * step, 0).line(50.5 * step, depth).line(50.5 * step, 0).line(100 * step, 0);
  std::vector<AxisVector> words;
  for (int n = 0; n <= 100; ++n) words.push_back({n * step});
  const Verdict verdict = judge_motion(program, words);
  EXPECT_TRUE(has(verdict, "skipped path", 2) || has(verdict, "skipped path", 3)) << describe(verdict);
  EXPECT_GT(verdict.deviation_mm, 0);
}

TEST_P(Sabotage, FeedOfRotaryAndInverseTimeBlocks) {
  const machine::Machine five = five_axes();
  Program program;
  AxisVector turned{};
  at(turned, Axis::C) = 90;
  program.fed(20).line(turned);  // degrees/s
  program.feed = {gcode::Feed::Mode::per_second, 0.25};
  program.line({30, 40, 0, 0, 0, 120});  // 50 mm in 4 s
  for (const int line : {1, 2}) {
    std::vector<double> durations = {law_velocity * 90 / 19.9, law_velocity * 4 / 0.995};
    EXPECT_FALSE(judge(program.moves, sample(program.moves, durations, period), five, period).objects());
    durations[static_cast<std::size_t>(line - 1)] /= 1.01;
    const Verdict verdict = judge(program.moves, sample(program.moves, durations, period), five, period);
    EXPECT_TRUE(has(verdict, "feed", line) && has_only(verdict, "feed")) << describe(verdict);
    EXPECT_DOUBLE_EQ(verdict.feed_programmed_max, 12.5);
  }
}

TEST_P(Sabotage, RotaryAxisLeftOut) {
  const machine::Machine five = five_axes();
  Program program;
  program.fed(20).line({30, 0, 0, 0, 0, 45});
  Words words = exact_motion(program, five, period);
  for (AxisVector& word : words) at(word, Axis::C) = 0;
  const Verdict verdict = judge(program.moves, words, five, period);
  EXPECT_TRUE(has(verdict, "end", 1) && has(verdict, "deviation", 1));
  EXPECT_NEAR(verdict.end_error_mm, 50 * std::numbers::pi / 4, 1e-9);
}

TEST_P(Sabotage, RecoversAfterAnExcursionAndJudgesTheRest) {
  const Program program = plate();
  Words words = motion(program);
  const auto on_line = [&](double x, double y) {
    return static_cast<std::size_t>(std::find_if(words.begin(), words.end(),
                                                 [&](const AxisVector& word) {
                                                   return std::abs(word[0] - x) < 1.5 && std::abs(word[1] - y) < 1.5;
                                                 }) -
                                    words.begin());
  };
  const std::size_t first = on_line(5, 0), second = on_line(30, 60);
  at(words[first], Axis::Z) += 0.5;
  at(words[second], Axis::Z) += 0.2;
  const Verdict verdict = judge_motion(program, words);
  EXPECT_TRUE(has(verdict, "deviation", 1)) << describe(verdict);
  EXPECT_TRUE(has(verdict, "deviation", 20)) << describe(verdict);
  EXPECT_NEAR(verdict.deviation_mm, 0.5, 1e-9) << describe(verdict);
}

TEST_P(Sabotage, RunsBackAlongALine) {
  Program program, wrong;
  program.line(10, 0);
  wrong.line(7, 0).line(3, 0).line(10, 0);
  const Verdict verdict = judge_motion(program, motion(wrong));
  EXPECT_TRUE(has(verdict, "deviation", 1) && has_only(verdict, "deviation")) << describe(verdict);
  // Fréchet's distance is 2 mm: half of what it runs back. Nobody waits for it here, so all of that is told.
  EXPECT_GE(verdict.deviation_mm, 2) << describe(verdict);
  EXPECT_LE(verdict.deviation_mm, 4 + 1e-9) << describe(verdict);
}

TEST_P(Sabotage, RunsBackAlongAnArc) {
  Program program, wrong;
  program.position = wrong.position = {10};
  program.arc({0, 10}, gcode::Plane::XY, 0, 0, 1);
  const auto at_degrees = [](double angle) {
    const double radians = angle * std::numbers::pi / 180;
    return AxisVector{10 * std::cos(radians), 10 * std::sin(radians)};
  };
  wrong.arc(at_degrees(60), gcode::Plane::XY, 0, 0, 1).arc(at_degrees(30), gcode::Plane::XY, 0, 0, -1);
  wrong.arc({0, 10}, gcode::Plane::XY, 0, 0, 1);
  const Verdict verdict = judge_motion(program, motion(wrong));
  EXPECT_TRUE(has(verdict, "deviation", 1) && has_only(verdict, "deviation")) << describe(verdict);
  EXPECT_GE(verdict.deviation_mm, 20 * std::sin(std::numbers::pi / 24)) << describe(verdict);
}

TEST_P(Sabotage, HalfAsMuchAgainAsTheTolerance) {
  Program program;
  program.blended(0.02).line(30, 0).line(30, 20);
  for (const double off : {0.019, 0.03}) {
    Words words = motion(program);
    for (AxisVector& word : words) at(word, Axis::Z) += off;
    const Verdict verdict = judge_motion(program, words);
    for (const char* const what : {"deviation", "start", "end"}) {
      EXPECT_EQ(has(verdict, what), off > 0.02) << what << describe(verdict);
    }
    EXPECT_NEAR(verdict.deviation_mm, off, 1e-9);
    EXPECT_EQ(verdict.tolerance_mm, 0.02);
  }
}

INSTANTIATE_TEST_SUITE_P(Periods, Sabotage, testing::Values(100'000, 1'000'000, 20'000'000),
                         [](const auto& one) { return std::to_string(one.param / 1000) + "us"; });

}  // namespace test_sabotage
}  // namespace leadscrew::referee::test
