#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <leadscrew/study/tube.hpp>
#include <leadscrew/study/tube_fragments.hpp>
#include <numbers>

namespace leadscrew::study {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double fragment_feed = 100, fragment_tolerance = 0.01;

/// Lines and arcs from machine zero on, coordinates to three decimals.
class Contour {
 public:
  Contour& line(PlaneVector to) { return block("G1", to); }
  /// By its centre's offset from where it begins; counterclockwise.
  Contour& left_arc(PlaneVector to, PlaneVector center) { return block("G3", to, &center); }
  Contour& right_arc(PlaneVector to, PlaneVector center) { return block("G2", to, &center); }
  /// Lines on a circle about `center`, from one angle (radians) to another.
  Contour& chords(PlaneVector center, double radius, double from, double to, int count) {
    for (int k = 1; k <= count; ++k) {
      const double angle = from + (to - from) * k / count;
      line(center + radius * PlaneVector{std::cos(angle), std::sin(angle)});
    }
    return *this;
  }

  ProgrammedContour contour() const { return contour_; }

 private:
  static PlaneVector rounded(PlaneVector a) { return {std::round(a.x * 1000) / 1000, std::round(a.y * 1000) / 1000}; }

  Contour& block(const char* code, PlaneVector to, const PlaneVector* center = nullptr) {
    const PlaneVector end = rounded(to);
    contour_.blocks += code + word('X', end.x) + word('Y', end.y);
    if (center != nullptr) contour_.blocks += word('I', center->x) + word('J', center->y);
    contour_.blocks += '\n';
    return *this;
  }

  ProgrammedContour contour_;
};

template <int degrees>
ProgrammedContour corner() {
  constexpr double leg = 5;
  const double turn = degrees * pi / 180;
  return Contour().line({leg, 0}).line({leg + leg * std::cos(turn), leg * std::sin(turn)}).contour();
}

ProgrammedContour square_of_ten() {
  return Contour().line({10, 0}).line({10, 10}).line({0, 10}).line({}).contour();
}

ProgrammedContour hexagon() {
  return Contour().chords({-5, 0}, 5, 0, 2 * pi, 6).contour();
}

ProgrammedContour star_of_ten() {
  return Contour().chords({0, -10}, 10, pi / 2, 4.5 * pi, 5).contour();
}

/// Twenty lines up and down by 45°, the pitch in micrometres.
template <int pitch>
ProgrammedContour zigzag() {
  constexpr double step = pitch / 1000.0;
  Contour zigzag;
  for (int k = 1; k <= 20; ++k) zigzag.line({k * step, k % 2 * step});
  return zigzag.contour();
}

/// Twenty lines of 0.2 to 4 mm, each turned by up to 1.8 radians from the one before; drawn by a linear congruential
/// generator (Numerical Recipes, 7.1).
template <std::uint32_t seed>
ProgrammedContour random_walk() {
  std::uint32_t state = seed;
  const auto draw = [&] { return (state = 1664525 * state + 1013904223) / 4294967296.0; };
  Contour walk;
  PlaneVector at;
  double heading = 0;
  for (int k = 0; k < 20; ++k) {
    heading += 1.8 * (2 * draw() - 1);
    const double length = 0.2 * std::pow(20, draw());
    at = at + length * PlaneVector{std::cos(heading), std::sin(heading)};
    walk.line(at);
  }
  return walk.contour();
}

/// Letters as strokes, their bows of chords of 15° and 22.5°.
ProgrammedContour engraving() {
  return Contour()
      .line({0, 5})
      .line({2, 5})
      .chords({2, 3.75}, 1.25, pi / 2, -pi / 2, 8)
      .line({0, 2.5})
      .line({1.5, 2.5})
      .line({3.25, 0})
      .line({5, 0})
      .chords({5, 1}, 1, -pi / 2, pi / 2, 12)
      .line({4, 4})
      .line({4.4, 5})
      .contour();
}

ProgrammedContour raster() {
  Contour raster;
  for (int row = 0; row < 4; ++row) {
    const double end = row % 2 == 0 ? 10 : 0, y = 0.2 * row;
    if (row > 0) raster.line({10 - end, y});
    raster.line({end, y});
  }
  return raster.contour();
}

/// Once round 10 by 8 mm with quarter arcs R 2 mm, tangent to the lines.
ProgrammedContour rounded_pocket() {
  return Contour()
      .line({6, 0})
      .left_arc({8, 2}, {0, 2})
      .line({8, 6})
      .left_arc({6, 8}, {-2, 0})
      .line({0, 8})
      .left_arc({-2, 6}, {0, -2})
      .line({-2, 2})
      .left_arc({0, 0}, {2, 0})
      .contour();
}

/// Arcs that meet lines at corners and tangentially.
ProgrammedContour arcs_and_corners() {
  return Contour()
      .line({6, 0})
      .right_arc({6, 4}, {2, 2})
      .line({2, 4})
      .left_arc({0, 2}, {0, -2})
      .line({0, 0.5})
      .line({1, 0})
      .contour();
}

constexpr std::array<TubeFragment, 17> fragments = {{
    {"corner-10", {"corner that turns 10°, 2 × 5 mm", corner<10>, fragment_feed, fragment_tolerance}, 0.29319},
    {"corner-45", {"corner that turns 45°, 2 × 5 mm", corner<45>, fragment_feed, fragment_tolerance}, 0.35288},
    {"corner-90", {"corner that turns 90°, 2 × 5 mm", corner<90>, fragment_feed, fragment_tolerance}, 0.35929},
    {"corner-135", {"corner that turns 135°, 2 × 5 mm", corner<135>, fragment_feed, fragment_tolerance}, 0.33394},
    {"square", {"square of 10 mm", square_of_ten, fragment_feed, fragment_tolerance}, 0.90176},
    {"hexagon", {"hexagon of 5 mm", hexagon, fragment_feed, fragment_tolerance}, 1.01887},
    {"star", {"five-pointed star, R 10 mm", star_of_ten, fragment_feed, fragment_tolerance}, 1.45465},
    {"zigzag-0.05", {"zigzag, pitch 0.05 mm", zigzag<50>, fragment_feed, fragment_tolerance}, 0.54079},
    {"zigzag-0.5", {"zigzag, pitch 0.5 mm", zigzag<500>, fragment_feed, fragment_tolerance}, 1.34766},
    {"zigzag-2", {"zigzag, pitch 2 mm", zigzag<2000>, fragment_feed, fragment_tolerance}, 2.56101},
    {"walk-1", {"random walk 1, 20 lines", random_walk<1>, fragment_feed, fragment_tolerance}, 1.51323},
    {"walk-2", {"random walk 2, 20 lines", random_walk<2>, fragment_feed, fragment_tolerance}, 1.28713},
    {"walk-3", {"random walk 3, 20 lines", random_walk<3>, fragment_feed, fragment_tolerance}, 1.53886},
    {"engraving", {"engraved strokes, 28 lines", engraving, fragment_feed, fragment_tolerance}, 1.17558},
    {"raster", {"raster, 4 rows 0.2 mm apart", raster, fragment_feed, fragment_tolerance}, 1.02453},
    {"pocket",
     {"pocket, 4 lines and 4 quarter arcs R 2 mm", rounded_pocket, fragment_feed, fragment_tolerance},
     0.74426},
    {"arcs",
     {"4 lines and 2 arcs, corners and tangents", arcs_and_corners, fragment_feed, fragment_tolerance},
     0.69211},
}};

}  // namespace

std::span<const TubeFragment> tube_fragments() {
  return fragments;
}

}  // namespace leadscrew::study
