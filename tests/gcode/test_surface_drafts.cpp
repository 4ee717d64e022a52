// What one reading of a program finds of its surfaces, and others of the same program then do not find again.

#include <leadscrew/gcode/surface_drafts.hpp>

#include "surface_programs.hpp"

namespace leadscrew::gcode {
namespace test_surface_drafts {

const std::string control = "F600\nG0 Z40\nG43.4 H1\nG0 Z60\n";

Conditions at_a_table() {
  return with_shapes("table-table-ac");
}

Conditions with_drafts(Conditions conditions, const std::shared_ptr<SurfaceDrafts>& drafts) {
  conditions.options.surface_drafts = drafts;
  return conditions;
}

/// Bit for bit.
void expect_same(const std::vector<OnSurface>& a, const std::vector<OnSurface>& b, const std::string& text) {
  ASSERT_EQ(a.size(), b.size()) << text;
  for (std::size_t k = 0; k < a.size(); ++k) {
    ASSERT_EQ(a[k].move.kind, b[k].move.kind) << text;
    ASSERT_EQ(a[k].move.start, b[k].move.start) << text;
    ASSERT_EQ(a[k].move.end, b[k].move.end) << text;
    ASSERT_EQ(a[k].move.curve.knots, b[k].move.curve.knots) << text;
    ASSERT_EQ(a[k].move.curve.points.size(), b[k].move.curve.points.size()) << text;
    for (std::size_t i = 0; i < a[k].move.curve.points.size(); ++i)
      ASSERT_EQ(a[k].move.curve.points[i].position, b[k].move.curve.points[i].position) << text;
    ASSERT_EQ(a[k].machined.pass, b[k].machined.pass) << text;
  }
}

TEST(SurfaceDrafts, MovesOfASecondReadingAreThoseOfTheFirst) {
  for (const std::string words : {"T1 Q3 A0", "T2 Q3 A8", "T2 Q3 A8 B5 S1", "T2 Q3 A8 S3", "T2 H0.1 A8 S4",
                                  "T2 H0.1 A8 S5", "T2 H0.2 A5 L2 P3 R1 U0.1 V0.9"}) {
    const std::string text = control + patch_a() + "G6.5 D1 " + words + " Z60\nM2\n";
    const auto alone = read_surfaces(text, at_a_table());
    const auto drafts = new_surface_drafts();
    const Conditions sharing = with_drafts(at_a_table(), drafts);
    expect_same(alone, read_surfaces(text, sharing), text);
    EXPECT_EQ(drafts->count(), 1U);
    EXPECT_EQ(drafts->found(), 0U);
    expect_same(alone, read_surfaces(text, sharing), text);
    EXPECT_EQ(drafts->count(), 1U);
    EXPECT_EQ(drafts->found(), 1U);
  }
}

/// Everything that a draft follows from is changed once: none of another is used.
TEST(SurfaceDrafts, OfAnythingElseAreNotUsed) {
  const std::string surface = patch_a(), block = "G6.5 D1 T2 Q6 A8 Z60\nM2\n";
  const std::vector<std::string> texts = {
      control + surface + block,
      control + surface + "G6.5 D1 T2 Q6.1 A8 Z60\nM2\n",
      control + surface + "G6.5 D1 T2 H0.5 A8 Z60\nM2\n",
      control + surface + "G6.5 D1 T1 Q6 A8 Z60\nM2\n",
      control + surface + "G6.5 D1 T2 Q6 A8.5 Z60\nM2\n",
      control + surface + "G6.5 D1 T2 Q6 A8 B1 Z60\nM2\n",
      control + surface + "G6.5 D1 T1 Q6 A0 Z60\nM2\n",
      control + surface + "G6.5 D1 T2 Q6 A8 L2 Z60\nM2\n",
      control + surface + "G6.5 D1 T2 Q6 A8 S1 Z60\nM2\n",
      control + surface + "G6.5 D1 T2 Q6 A8 P2 Z60\nM2\n",
      control + surface + "G6.5 D1 T2 Q6 A8 U0.1 Z60\nM2\n",
      control + surface + "G6.5 D1 T2 Q6 A8 J0.9 Z60\nM2\n",
      control + surface + "G6.5 D1 T2 Q6 A8 C0.001 Z60\nM2\n",
      control + "G0 C200\n" + surface + block,
      control + "G54 G10 L2 P1 X1\n" + surface + block,
      control + "G68 X0 Y0 R10\n" + surface + block,
      control + surface + "G6.4 D1 P2 Q2 I2 J2\nX0 Y0 Z0\nX20\nX0 Y10\nX20\n" + block,
  };
  const auto drafts = new_surface_drafts();
  std::size_t expected = 0;
  for (const std::string& text : texts) {
    expect_same(read_surfaces(text, at_a_table()), read_surfaces(text, with_drafts(at_a_table(), drafts)), text);
    EXPECT_EQ(drafts->count(), ++expected) << text;
  }
  // Another machine: its chain, and travel that asks for another beginning.
  Conditions askew = at_a_table(), narrow = at_a_table(), slow = at_a_table();
  askew.machine.rotary_chain->axes[0].point[0] += 1;
  narrow.machine.axes[base::index(base::Axis::C)]->travel_max = 3500;
  slow.machine.axes[base::index(base::Axis::C)]->velocity = 20;
  for (const Conditions& other : {askew, narrow, slow}) {
    expect_same(read_surfaces(texts[0], other), read_surfaces(texts[0], with_drafts(other, drafts)), texts[0]);
    EXPECT_EQ(drafts->count(), ++expected);
  }
  Conditions gouging = with_drafts(at_a_table(), drafts);
  gouging.options.allows_gouging = true;
  read_surfaces(texts[0], gouging);
  EXPECT_EQ(drafts->count(), ++expected);
  EXPECT_EQ(drafts->found(), 0U);
}

TEST(SurfaceDrafts, ThatCouldNotBeAreNotKept) {
  const auto drafts = new_surface_drafts();
  Conditions conditions = with_drafts(at_a_table(), drafts);
  conditions.machine.axes[base::index(base::Axis::C)]->travel_min = -100;
  conditions.machine.axes[base::index(base::Axis::C)]->travel_max = 100;
  for (int times = 0; times < 2; ++times) {
    EXPECT_EQ(read(control + patch_a() + "G6.5 D1 T1 Q2 A0 Z60\nM2\n", conditions).problems(), "22:1 rotary-travel; ");
    EXPECT_EQ(drafts->count(), 0U);
  }
}

/// So many there may be, and so many bytes; those that came first stay.
TEST(SurfaceDrafts, AreBounded) {
  const Conditions table = at_a_table();
  const auto key_of = [&](double step, std::size_t points) {
    surfaces::SurfaceForm form;
    form.degree = {1, 1};
    form.count = {points, 2};
    form.knots = {surfaces::uniform_knots(points, 1), surfaces::uniform_knots(2, 1)};
    for (std::size_t j = 0; j < 2; ++j) {
      for (std::size_t i = 0; i < points; ++i)
        form.net.push_back({{static_cast<double>(i), static_cast<double>(j), 0}, 1});
    }
    surfaces::Machining machining;
    machining.surface = std::make_shared<const surfaces::Surface>(form);
    machining.step = step;
    return SurfaceDraftKey{machining, *kinematics::Chain::of(*table.machine.rotary_chain), {}, {}};
  };
  SurfaceDrafts many;
  for (std::size_t k = 0; k < 2 * SurfaceDrafts::most_drafts; ++k)
    many.keep(key_of(1 + static_cast<double>(k), 2), {{k, {}}, nullptr});
  EXPECT_EQ(many.count(), SurfaceDrafts::most_drafts);
  EXPECT_EQ(many.find(key_of(1, 2))->choice.side, 0U);
  EXPECT_EQ(many.find(key_of(11, 2))->choice.side, 10U);
  EXPECT_FALSE(many.find(key_of(1000, 2)));
  SurfaceDrafts great;
  constexpr std::size_t points = 2000;
  for (std::size_t k = 0; k < 20; ++k) great.keep(key_of(1 + static_cast<double>(k), points), {});
  EXPECT_GE(great.count(), 3U);
  EXPECT_LE(great.count() * 2 * points * sizeof(surfaces::NetPoint), SurfaceDrafts::most_bytes);
  EXPECT_LT(great.count(), 20U);
  great.keep(key_of(100, 2), {});
  EXPECT_TRUE(great.find(key_of(100, 2)));
}

}  // namespace test_surface_drafts
}  // namespace leadscrew::gcode
