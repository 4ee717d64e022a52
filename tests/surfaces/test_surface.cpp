// Surfaces, their normals and curvatures, tools on them, steps between passes: against closed forms, differences and the
// figures of the study "surface".

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/kinematics/great_circle.hpp>

#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/surfaces/cutter.hpp>
#include <leadscrew/surfaces/frame.hpp>
#include <leadscrew/surfaces/step_over.hpp>
#include <leadscrew/surfaces/surface.hpp>
#include <numbers>
#include <random>

#include "patches.hpp"

namespace leadscrew::surfaces {
namespace {

constexpr double degree = std::numbers::pi / 180;

void expect_near(const Vector& found, const Vector& expected, double tolerance) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], tolerance) << "coordinate " << k;
}

struct Held {
  Vector s{}, n{}, axis{}, tip{};
};
Held held(const Surface& surface, double u, double v, const Cutter& cutter, const Orientation& orientation) {
  const SurfaceJet jet = surface.jet(u, v);
  const Frame frame = *frame_of(jet, 1);
  const TangentPair tangents = tangents_of(jet, frame, Direction::u);
  const Vector axis = axis_of(orientation, frame.n, tangents.f);
  return {jet.s, frame.n, axis, tip_of(cutter, jet.s, frame.n, axis, tangents.f)};
}

TEST(Surface, HasTheStudysFigures) {
  const Surface surface(test::patch_a());
  const Held middle = held(surface, 0.5, 0.5, {5, 5}, {}), quarter = held(surface, 0.25, 0.75, {5, 5}, {});
  expect_near(middle.s, {30, 30, 5.9375}, 1e-12);
  expect_near(middle.n, {0.01874341, 0.01874341, 0.99964862}, 5e-9);
  expect_near(quarter.s, {15, 45, 3.260742}, 5e-7);
  expect_near(quarter.n, {-0.0691203, 0.21155002, 0.97491998}, 5e-8);
  expect_near(quarter.tip, {14.654398, 46.05775, 3.135342}, 5e-7);
  const Orientation lead = Orientation::leaning(5 * degree, 0);
  const Held bull = held(surface, 0.25, 0.75, {5, 1}, lead), bull_middle = held(surface, 0.5, 0.5, {5, 1}, lead);
  expect_near(bull.axis, {0.01808024, 0.21074501, 0.97737385}, 5e-9);
  expect_near(bull.tip, {10.913901, 45.074556, 3.316361}, 5e-7);
  expect_near(bull_middle.axis, {0.10581251, 0.01867209, 0.99421077}, 5e-9);
  expect_near(bull_middle.tip, {25.935387, 30.006606, 6.36614}, 5e-7);
}

TEST(Surface, HasTheStudysAreaAndCurvatures) {
  const Surface surface(test::patch_a());
  double area = 0, tilt = 0, concave = 0, convex = 0, at_u = 0, at_v = 0;
  const int n = 400;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
      const SurfaceJet jet = surface.jet(u, v);
      const Frame frame = *frame_of(jet, 1);
      // Simpson's rule both ways
      const auto weight = [&](int k) { return k == 0 || k == n ? 1.0 : k % 2 == 1 ? 4.0 : 2.0; };
      area += weight(i) * weight(j) * std::sqrt(frame.E * frame.G - frame.F * frame.F) / (9.0 * n * n);
      tilt = std::max(tilt, std::acos(frame.n[2]) / degree);
      const auto [most, least] = curvature_of(jet, frame, tangents_of(jet, frame, Direction::u)).principal();
      if (most > concave) at_u = u, at_v = v;
      concave = std::max(concave, most);
      convex = std::max(convex, -least);
    }
  }
  EXPECT_NEAR(area, 3673.206807, 5e-7);
  EXPECT_NEAR(tilt, 22.990, 5e-4);
  EXPECT_NEAR(1 / concave, 45.443, 5e-4);
  EXPECT_EQ(std::min(at_u, at_v), 0);  // the patch is the same with x and y exchanged
  EXPECT_NEAR(std::max(at_u, at_v), 0.9, 0.005);
  EXPECT_NEAR(convex, 0.037956, 5e-7);
}

/// Richardson's extrapolation of central differences.
template <typename F>
Vector derivative(const F& f, double x, double h) {
  const auto central = [&](double step) {
    const Vector high = f(x + step), low = f(x - step);
    return Vector{(high[0] - low[0]) / (2 * step), (high[1] - low[1]) / (2 * step), (high[2] - low[2]) / (2 * step)};
  };
  const Vector coarse = central(h), fine = central(h / 2);
  return {(4 * fine[0] - coarse[0]) / 3, (4 * fine[1] - coarse[1]) / 3, (4 * fine[2] - coarse[2]) / 3};
}

TEST(Surface, HasTheDerivativesOfDifferences) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 60; ++round) {
    const std::array<int, 2> degrees = {1 + round % 5, 1 + round / 5 % 5};
    SurfaceForm form{degrees, {}, {8, 7}, {}};
    for (std::size_t d = 0; d < 2; ++d) {
      form.knots[d] = uniform_knots(form.count[d], degrees[d]);
      for (double& knot : form.knots[d]) knot = 3 * knot * (1 + 0.5 * knot) - 2;
    }
    for (std::size_t k = 0; k < 56; ++k) {
      const double x = static_cast<double>(k % 8), y = static_cast<double>(k / 8);
      form.net.push_back({{x + unit(random) / 2, y + unit(random) / 2, unit(random)}, 0.5 + unit(random)});
    }
    ASSERT_FALSE(fault_of(form));
    const Surface surface(form);
    const auto& us = surface.breaks(Direction::u);
    const auto& vs = surface.breaks(Direction::v);
    const std::size_t i = static_cast<std::size_t>(round) % (us.size() - 1),
                      j = static_cast<std::size_t>(round) % (vs.size() - 1);
    const double u = us[i] + (0.2 + 0.6 * unit(random)) * (us[i + 1] - us[i]);
    const double v = vs[j] + (0.2 + 0.6 * unit(random)) * (vs[j + 1] - vs[j]);
    const SurfaceJet jet = surface.jet(u, v);
    const double h = 1e-3;
    const auto along_u = [&](Vector SurfaceJet::* member) {
      return derivative([&](double x) { return surface.jet(x, v).*member; }, u, h);
    };
    const auto along_v = [&](Vector SurfaceJet::* member) {
      return derivative([&](double x) { return surface.jet(u, x).*member; }, v, h);
    };
    expect_near(surface.at(u, v), jet.s, 1e-12);
    expect_near(jet.u, along_u(&SurfaceJet::s), 1e-7);
    expect_near(jet.v, along_v(&SurfaceJet::s), 1e-7);
    expect_near(jet.uu, along_u(&SurfaceJet::u), 1e-6);
    expect_near(jet.uv, along_v(&SurfaceJet::u), 1e-6);
    expect_near(jet.vv, along_v(&SurfaceJet::v), 1e-6);
    expect_near(jet.uuu, along_u(&SurfaceJet::uu), 1e-5);
    expect_near(jet.uuv, along_v(&SurfaceJet::uu), 1e-5);
    expect_near(jet.uvv, along_v(&SurfaceJet::uv), 1e-5);
    expect_near(jet.vvv, along_v(&SurfaceJet::vv), 1e-5);
  }
}

TEST(Surface, IsASphereToTheLastBits) {
  const Surface surface(test::sphere(25));
  for (double u = 0; u <= 1; u += 0.1) {
    for (double v = 0; v <= 1; v += 0.1) {
      const SurfaceJet jet = surface.jet(u, v);
      EXPECT_NEAR(numeric::norm(jet.s), 25, 1e-13);
      const Frame frame = *frame_of(jet, 1);
      expect_near(frame.n, {jet.s[0] / 25, jet.s[1] / 25, jet.s[2] / 25}, 1e-13);
      const auto [most, least] = curvature_of(jet, frame, tangents_of(jet, frame, Direction::v)).principal();
      EXPECT_NEAR(most, -0.04, 1e-13);
      EXPECT_NEAR(least, -0.04, 1e-13);
      const Held ball = held(surface, u, v, {4, 4}, {});
      EXPECT_NEAR(std::hypot(ball.tip[0], ball.tip[1], ball.tip[2] + 4), 29, 1e-13);  // the ball's centre
    }
  }
}

TEST(StepOver, HasTheClosedForms) {
  EXPECT_NEAR(step_over(5, 0, 0.01), 0.632139, 5e-7);
  EXPECT_NEAR(step_over(5, 0, 0.05), 1.410674, 5e-7);
  EXPECT_NEAR(step_over(5, -1.0 / 50, 0.01), 0.602662, 5e-7);
  EXPECT_NEAR(step_over(5, 1.0 / 50, 0.01), 0.666401, 5e-7);
  EXPECT_NEAR(step_over(5, 1.0 / 6, 0.01), 1.550789, 5e-7);
  EXPECT_NEAR(step_over(3, -1.0 / 20, 0.005), 0.322855, 5e-7);
  EXPECT_NEAR(scallop_height(5, 0, std::sqrt(8 * 5 * 0.01)), 0.0100100, 5e-8);
  EXPECT_NEAR(scallop_height(5, -1.0 / 50, 0.603023), 0.0100120, 5e-8);
  EXPECT_NEAR(scallop_height(5, 1.0 / 6, 1.549193), 0.0099795, 5e-8);
  // By the law of cosines, as it stands in the header
  for (const double curvature : {-1.0 / 50, -1.0 / 5, 1.0 / 50, 1.0 / 6, 1e-3}) {
    for (const double height : {1e-4, 0.01, 0.5}) {
      const double s = curvature < 0 ? 1 : -1, rho = 1 / std::abs(curvature), D = rho + s * 5, t = rho + s * height;
      EXPECT_NEAR(step_over(5, curvature, height), 2 * rho * std::acos((D * D + t * t - 25) / (2 * D * t)), 1e-8);
      EXPECT_NEAR(scallop_height(5, curvature, step_over(5, curvature, height)), height, 1e-13);
    }
  }
  EXPECT_NEAR(step_over(1e12, -1.0 / 50, 0.01), step_over(std::numeric_limits<double>::infinity(), -1.0 / 50, 0.01),
              1e-6);
}

TEST(Cutter, HasTheEffectiveRadiiOfToolsThatLean) {
  const TangentPair tangents{{1, 0, 0}, {0, 1, 0}};
  const auto radius = [&](double R, double r, double lead) {
    const Vector axis = {std::sin(lead * degree), 0, std::cos(lead * degree)};
    return effective_radius(curvature_of({R, r}, {0, 0, 1}, axis, tangents));
  };
  EXPECT_NEAR(radius(5, 0, 3), 95.537, 5e-4);
  EXPECT_NEAR(radius(5, 0, 10), 28.794, 5e-4);
  EXPECT_NEAR(radius(5, 1, 5), 46.895, 5e-4);
  EXPECT_NEAR(radius(5, 2, 15), 13.591, 5e-4);
  EXPECT_NEAR(radius(8, 2, 10), 36.553, 5e-4);
  EXPECT_NEAR(radius(5, 5, 10), 5, 1e-12);
  EXPECT_TRUE(std::isinf(radius(5, 1, 0)));
  // Leaning sideways it is r.
  const Vector aside = {0, std::sin(0.2), std::cos(0.2)};
  EXPECT_NEAR(effective_radius(curvature_of({5, 1}, {0, 0, 1}, aside, tangents)), 1, 1e-12);
}

TEST(Cutter, GougesPatchAAboveItsSmallestRadiusOfCurvature) {
  const Surface surface(test::patch_a());
  const auto least = [&](double R) {
    double clearance = 1;
    for (int j = 0; j <= 200; ++j) {
      for (int i = 0; i <= 200; ++i) {
        const SurfaceJet jet = surface.jet(i / 200.0, j / 200.0);
        const Frame frame = *frame_of(jet, 1);
        const TangentPair pair = tangents_of(jet, frame, Direction::u);
        clearance = std::min(clearance, local_clearance(curvature_of(Cutter{R, R}, frame.n, {0, 0, 1}, pair),
                                                        curvature_of(jet, frame, pair)));
      }
    }
    return clearance;
  };
  EXPECT_GT(least(45.43), 0);
  EXPECT_LT(least(45.45), 0);
}

TEST(SurfaceFault, IsFound) {
  using Kind = SurfaceFault::Kind;
  EXPECT_FALSE(fault_of(test::patch_a()));
  EXPECT_FALSE(fault_of(test::sphere(10)));
  const auto kind_of = [](const auto& change) {
    SurfaceForm form = test::patch_a();
    change(form);
    const auto fault = fault_of(form);
    return fault ? std::optional(fault->kind) : std::nullopt;
  };
  EXPECT_EQ(kind_of([](SurfaceForm& f) { f.net.pop_back(); }), Kind::counts);
  EXPECT_EQ(kind_of([](SurfaceForm& f) { f.degree[0] = 4; }), Kind::counts);
  EXPECT_EQ(kind_of([](SurfaceForm& f) { f.net[3].position[1] = std::nan(""); }), Kind::not_finite);
  EXPECT_EQ(kind_of([](SurfaceForm& f) { f.net[3].weight = 0; }), Kind::weight);
  EXPECT_EQ(kind_of([](SurfaceForm& f) { f.net[3].weight = -2; }), Kind::weight);
  EXPECT_EQ(kind_of([](SurfaceForm& f) { f.knots[1][2] = 0.1; }), Kind::knots);
  EXPECT_EQ(kind_of([](SurfaceForm& f) { f.knots[0][5] = -1; }), Kind::knots);
  EXPECT_EQ(kind_of([](SurfaceForm& f) {
              for (std::size_t i = 0; i < 4; ++i) f.net[4 + i] = f.net[i];
            }),
            Kind::rows);
  EXPECT_EQ(kind_of([](SurfaceForm& f) {
              for (std::size_t i = 0; i < 4; ++i) f.net[i].position = {1, 2, 3};
            }),
            Kind::normal);
  EXPECT_EQ(kind_of([](SurfaceForm& f) {  // weights leave a derivative of rounding errors
              for (std::size_t i = 0; i < 4; ++i) f.net[i] = {{1.0 / 3, 2.0 / 7, 3}, 1 + static_cast<double>(i) / 9};
            }),
            Kind::normal);
  const auto rows = fault_of([] {
    SurfaceForm form = test::patch_a();
    for (std::size_t j = 0; j < 4; ++j) form.net[2 + 4 * j] = form.net[1 + 4 * j];
    return form;
  }());
  ASSERT_TRUE(rows);
  EXPECT_EQ(rows->direction, Direction::u);
  EXPECT_EQ(rows->index, 2u);
}

}  // namespace
}  // namespace leadscrew::surfaces
