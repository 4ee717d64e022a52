#pragma once
// Verdicts on motions along NURBS curves, and the points that such curves are made of.

#include <gtest/gtest.h>

#include "curves.hpp"

namespace leadscrew::referee::test {

inline constexpr double rounding = 5e-8;  // mm; a twentieth of a nanometre

inline const machine::Machine mill = machine::mill3();

inline void expect_sound(const Verdict& verdict) {
  EXPECT_FALSE(verdict.objects()) << describe(verdict);
  EXPECT_LE(verdict.deviation_mm, rounding);
  EXPECT_LE(verdict.start_error_mm, 1e-9);
  EXPECT_LE(verdict.end_error_mm, 1e-9);
}

inline gcode::ControlPoint at_xy(double x, double y, double weight = 1) {
  return {{x, y}, weight};
}

}  // namespace leadscrew::referee::test
