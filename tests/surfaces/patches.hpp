#pragma once
// Surfaces for tests.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/surfaces/passes.hpp>
#include <leadscrew/surfaces/surface.hpp>
#include <memory>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace leadscrew::surfaces::test {

/// A bicubic Bézier patch over x = 0, 20, 40, 60 and y = 0, 20, 40, 60 with these heights, by u then v.
inline SurfaceForm bicubic(const std::array<std::array<double, 4>, 4>& heights) {
  SurfaceForm form{{3, 3}, {uniform_knots(4, 3), uniform_knots(4, 3)}, {4, 4}, {}};
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) {
      form.net.push_back({{20.0 * static_cast<double>(i), 20.0 * static_cast<double>(j), heights[i][j]}, 1});
    }
  }
  return form;
}

/// The patch of the study "surface".
inline SurfaceForm patch_a() {
  return bicubic({{{0, 6, 6, 0}, {6, 14, 2, -4}, {6, 2, 14, 6}, {0, -4, 6, 8}}});
}

inline SurfaceForm saddle() {
  return bicubic({{{0, 4, 8, 12}, {4, 4, 4, 4}, {4, 4, 4, 4}, {12, 8, 4, 0}}});
}

/// A wavy net with inner knots, steep by no more than the tool can follow.
inline SurfaceForm random_form(std::mt19937& random, double height = 3) {
  std::uniform_real_distribution<double> unit(0, 1);
  const std::array<int, 2> degrees = {3 + static_cast<int>(2 * unit(random)), 3 + static_cast<int>(2 * unit(random))};
  SurfaceForm form{degrees, {}, {6, 7}, {}};
  for (std::size_t d = 0; d < 2; ++d) form.knots[d] = uniform_knots(form.count[d], degrees[d]);
  for (std::size_t k = 0; k < 42; ++k) {
    const double x = static_cast<double>(k % 6), y = static_cast<double>(k / 6);
    form.net.push_back(
        {{10 * x + unit(random), 9 * y + unit(random), height * unit(random)}, 0.8 + 0.4 * unit(random)});
  }
  return form;
}

/// A part of the sphere of this radius about 0, exactly: longitude and latitude of a quarter turn each, the latter from −45°
/// to 45°, both as rational quadratics.
inline SurfaceForm sphere(double radius) {
  const double root = std::sqrt(0.5);
  SurfaceForm form{{2, 2}, {uniform_knots(3, 2), uniform_knots(3, 2)}, {3, 3}, {}};
  // Of the arc of latitudes: (cos, sin) at −45°, where its tangents meet, at 45°.
  const std::array<std::pair<double, double>, 3> latitude = {{{root, -root}, {1 / root, 0}, {root, root}}};
  for (std::size_t j = 0; j < 3; ++j) {
    const auto [c, s] = latitude[j];
    const double wj = j == 1 ? root : 1;
    const std::array<std::pair<double, double>, 3> longitude = {{{1, 0}, {1, 1}, {0, 1}}};
    for (std::size_t i = 0; i < 3; ++i) {
      const double wi = i == 1 ? root : 1;
      form.net.push_back({{radius * c * longitude[i].first, radius * c * longitude[i].second, radius * s}, wi * wj});
    }
  }
  return form;
}

/// A quarter of the cylinder about x of this radius: v goes round, from +y over +z; u along x, 0 … length.
inline SurfaceForm cylinder(double radius, double length) {
  SurfaceForm form{{1, 2}, {uniform_knots(2, 1), uniform_knots(3, 2)}, {2, 3}, {}};
  const std::array<std::pair<double, double>, 3> round = {{{1, 0}, {1, 1}, {0, 1}}};
  for (std::size_t j = 0; j < 3; ++j) {
    const double weight = j == 1 ? std::sqrt(0.5) : 1;
    for (std::size_t i = 0; i < 2; ++i) {
      const double x = i == 0 ? 0 : length;
      form.net.push_back({{x, radius * round[j].first, radius * round[j].second}, weight});
    }
  }
  return form;
}

/// z = 0 over 0 … 40 by 0 … 30.
inline SurfaceForm plane() {
  SurfaceForm form{{1, 1}, {uniform_knots(2, 1), uniform_knots(2, 1)}, {2, 2}, {}};
  for (std::size_t j = 0; j < 2; ++j) {
    for (std::size_t i = 0; i < 2; ++i) form.net.push_back({{i == 0 ? 0.0 : 40.0, j == 0 ? 0.0 : 30.0, 0}, 1});
  }
  return form;
}

/// An upright ball of this radius that leaves ridges of this height, mm, in zigzag along u.
inline Machining ball_on(const SurfaceForm& form, double radius = 5, double scallop = 0.01) {
  Machining machining;
  machining.surface = std::make_shared<Surface>(form);
  machining.cutter = {radius, radius};
  machining.scallop = scallop;
  return machining;
}

/// All passes, without links; a failure fails the test.
inline std::vector<Pass> passes_of(const Machining& machining) {
  std::vector<Pass> passes;
  Passes made(machining);
  while (std::optional<Pass> pass = made.next()) {
    if (!pass->is_link) passes.push_back(*pass);
  }
  EXPECT_FALSE(made.failure());
  return passes;
}

}  // namespace leadscrew::surfaces::test
