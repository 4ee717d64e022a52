// What interpolators by least error work out at a clock: the steps that follow are those it asks for.

#include <gtest/gtest.h>

#include <leadscrew/nc/pulse_signals.hpp>
#include <map>
#include <string>

namespace leadscrew::nc {
namespace test_pulse_signals {

using pulse::Direction;
using pulse::Point;

using Values = std::map<std::string, std::int64_t>;

Values values_of(const PulseRun& run, const PulseCurve& curve) {
  Values values;
  const Registers signals = signals_of(run, curve);
  for (const Register& each : signals.all()) values[std::string(each.name)] = each.value;
  return values;
}

/// Full circles, and quarters from each axis, both ways.
std::vector<PulseCurve> arcs_of_radius(std::int64_t radius) {
  std::vector<PulseCurve> arcs;
  const Point center{2, -3};
  for (const Direction direction : {Direction::counterclockwise, Direction::clockwise}) {
    for (const Point offset : {Point{radius, 0}, Point{0, radius}, Point{-radius, 0}, Point{0, -radius}}) {
      const auto sense = static_cast<std::int64_t>(direction);
      const Point start{center.x + offset.x, center.y + offset.y};
      arcs.push_back({PulseCurve::Shape::arc, start, start, center, direction});
      const Point quarter{center.x - sense * offset.y, center.y + sense * offset.x};
      arcs.push_back({PulseCurve::Shape::arc, start, quarter, center, direction});
    }
  }
  return arcs;
}

std::int64_t f_at(Point at, const PulseCurve& curve) {
  const std::int64_t x = at.x - curve.center.x, y = at.y - curve.center.y;
  const std::int64_t x0 = curve.start.x - curve.center.x, y0 = curve.start.y - curve.center.y;
  return x * x + y * y - x0 * x0 - y0 * y0;
}

/// n1, n2 and n3 are F where the steps lead that could be made, and the one with the least |n| is made.
TEST(PulseSignals, TheLeastCandidateIsTheStepThatFollows) {
  for (std::int64_t radius = 1; radius <= 40; ++radius) {
    for (const PulseCurve& curve : arcs_of_radius(radius)) {
      PulseRun run(PulseMethod::min_error, curve);
      while (!run.done()) {
        const Values before = values_of(run, curve);
        const Point from = run.at();
        const auto [dx, dy] = run.step().step;
        const std::string taken = dx != 0 && dy != 0 ? "n1" : dx == 0 ? "n2" : "n3";
        ASSERT_EQ(before.at(taken), f_at(run.at(), curve)) << radius << ": " << from.x << ' ' << from.y;
        for (const char* other : {"n1", "n2", "n3"}) {
          ASSERT_LE(std::abs(before.at(taken)), std::abs(before.at(other))) << radius << other;
        }
        ASSERT_EQ(before.at("n1") - before.at("n2"), before.at("n3") - before.at("F")) << radius;
        EXPECT_EQ(values_of(run, curve).at("F"), f_at(run.at(), curve));
      }
    }
  }
}

/// Eq. 19 and its likes of the other quadrants, from their definition: p on the circle beside the next step of the
/// longer axis, beyond the middle of the two candidates or not.
TEST(PulseSignals, DSaysWhetherTheShorterAxisSteps) {
  for (std::int64_t radius = 1; radius <= 40; ++radius) {
    for (const PulseCurve& curve : arcs_of_radius(radius)) {
      PulseRun run(PulseMethod::improved_min_error, curve);
      while (!run.done()) {
        const std::int64_t d = values_of(run, curve).at("d");
        const Point from{run.at().x - curve.center.x, run.at().y - curve.center.y};
        const auto [dx, dy] = run.step().step;
        // On a diagonal either axis may be the longer one.
        if (std::abs(from.x) == std::abs(from.y)) continue;
        const bool x_is_long = std::abs(from.x) < std::abs(from.y);
        const auto [step_x, step_y] = pulse::tangent(pulse::quadrant(from, curve.direction), curve.direction).step;
        const std::int64_t next = x_is_long ? from.x + step_x : from.y + step_y;
        const std::int64_t shorter = x_is_long ? from.y : from.x, step = x_is_long ? step_y : step_x;
        ASSERT_EQ(d, 4 * (radius * radius - next * next) - (2 * shorter + step) * (2 * shorter + step)) << radius;
        const bool both = dx != 0 && dy != 0;
        ASSERT_EQ(both, step * shorter >= 0 ? d >= 0 : d <= 0) << radius << ": " << from.x << ' ' << from.y;
      }
    }
  }
}

/// An end off the circle is stepped to when the arc is over: F goes along.
TEST(PulseSignals, FIsTrueOnTheLastStepsToAnEndOffTheCircle) {
  for (const PulseMethod method :
       {PulseMethod::point_comparison, PulseMethod::min_error, PulseMethod::improved_min_error}) {
    int off = 0;
    for (std::int64_t x = 0; x <= 30; ++x) {
      for (std::int64_t y = 0; y <= 30; ++y) {
        const PulseCurve curve{PulseCurve::Shape::arc, {30, 0}, {x, y}, {}, Direction::counterclockwise};
        if (curve.end == curve.start || !problems_of(curve, std::nullopt).empty()) continue;
        PulseRun run(method, curve);
        while (!run.done()) {
          run.step();
          ASSERT_EQ(values_of(run, curve).at("F"), f_at(run.at(), curve)) << x << ' ' << y;
        }
        ASSERT_EQ(run.at(), curve.end);
        off += f_at(run.at(), curve) != 0 ? 1 : 0;
      }
    }
    EXPECT_GT(off, 20);
  }
}

TEST(PulseSignals, NamesAreThoseOfThePapers) {
  using Shape = PulseCurve::Shape;
  using Names = std::vector<std::string_view>;
  EXPECT_EQ(names_in_paper("rx", PulseMethod::dda, Shape::arc), Names{"Sum_X"});
  EXPECT_EQ(names_in_paper("ry", PulseMethod::dda, Shape::arc), (Names{"Sum_Y", "Sum_Z"}));
  EXPECT_EQ(names_in_paper("n2", PulseMethod::min_error, Shape::arc), Names{"Val_n2"});
  // Integrator 1 moves X on a line and Y on an arc.
  EXPECT_EQ(names_in_paper("rx", PulseMethod::koren, Shape::line), Names{"r1"});
  EXPECT_EQ(names_in_paper("rx", PulseMethod::koren, Shape::arc), Names{"r2"});
  EXPECT_EQ(names_in_paper("q", PulseMethod::koren, Shape::arc), Names{});
}

}  // namespace test_pulse_signals
}  // namespace leadscrew::nc
