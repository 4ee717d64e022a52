// A probe of the host's own ends probing moves: motion comes to rest within limits, and the program goes on from there.

#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include "paths.hpp"

namespace test_probe {

using namespace leadscrew;
using Search = gcode::ProbeSearch;

constexpr std::size_t z_axis = base::index(base::Axis::Z);

/// A program's motion, a word at a time, before a surface that the host feels at or below a height of Z.
struct Probing {
  std::unique_ptr<host::Motion> motion;
  std::vector<base::Word> words;
  std::vector<Search> searches;  ///< at each
  int found = 0;

  explicit Probing(const std::string& text, bool has_probe = true) {
    host::MotionOptions options;
    options.has_probe = has_probe;
    auto made = host::Motion::of_program(machine::mill3(), text, options);
    EXPECT_TRUE(made) << made.error().message;
    if (made) motion = std::move(*made);
  }

  void run(double surface) {
    base::Word word;
    while (motion->next({&word, 1}) == 1) {
      words.push_back(word);
      searches.push_back(motion->probing());
      const bool touches = word.position[z_axis] <= surface;
      const Search search = searches.back();
      if ((search == Search::contact && touches) || (search == Search::loss && !touches)) {
        EXPECT_TRUE(motion->probe_found());
        ++found;
      }
    }
  }
  double z_at_end() const { return words.back().position[z_axis]; }
};

/// Of all the motion there is.
base::Word last_word(host::Motion& motion) {
  base::Word word;
  while (motion.next({&word, 1}) == 1) {
  }
  return word;
}

TEST(HostProbe, EndsAMoveBehindContact) {
  Probing probing("G21 F3000\nG0 Z-2\nG38.2 Z-40\nG1 X10 Z#5063 F1000\nM2\n");
  probing.run(-7.3);
  EXPECT_FALSE(probing.motion->failure());
  EXPECT_GT(probing.found, 0);
  double lowest = 0, contact = 0;
  const double period = machine::mill3().period.seconds();
  for (std::size_t i = 0; i < probing.words.size(); ++i) {
    const double z = probing.words[i].position[z_axis];
    lowest = std::min(lowest, z);
    if (contact == 0 && z <= -7.3) contact = z;
    if (i < 2) continue;
    const double before = probing.words[i - 1].position[z_axis], first = probing.words[i - 2].position[z_axis];
    EXPECT_LE(std::abs(z - 2 * before + first), 1.001 * 1000 * period * period + 1e-9) << i;
  }
  // 50 mm/s: a slice of 50 ms, and a stop of at most v²/2a + v·a/2j.
  EXPECT_LT(lowest, contact - 0.5);
  EXPECT_GT(lowest, contact - (50 * 0.06 + 1.25 + 1.3));
  // The program goes on to the place of contact.
  EXPECT_DOUBLE_EQ(probing.z_at_end(), contact);
  EXPECT_DOUBLE_EQ(probing.words.back().position[0], 10);
}

/// A ball that the host feels from random sides, and the simulated one of the same place and size: where the line meets it
/// by the quadratic formula, the simulated probe trips; the other within a period's travel behind; motion rests past it by no
/// more than a slice and a stop.
TEST(HostProbe, FeelsABallFromRandomSides) {
  std::mt19937_64 random(5);
  const auto any = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); };
  for (int k = 0; k < 40; ++k) {
    const machine::Vector centre = {any(-50, 50), any(-50, 50), any(-50, 50)};
    const double radius = any(3, 20), feed = any(5, 60);  // mm/s
    machine::Vector start, aim, way;
    double a = 0, b = 0, c = -radius * radius, side = 0;
    for (std::size_t i = 0; i < 3; ++i) side += std::pow(start[i] = any(-1, 1), 2);
    for (std::size_t i = 0; i < 3; ++i) {
      start[i] = centre[i] + start[i] / std::sqrt(side) * (radius + 15);
      aim[i] = centre[i] + any(-0.4, 0.4) * radius;
      way[i] = 2 * (aim[i] - start[i]);
      a += way[i] * way[i];
      b += way[i] * (start[i] - centre[i]);
      c += (start[i] - centre[i]) * (start[i] - centre[i]);
    }
    const double share = (-b - std::sqrt(b * b - a * c)) / a;
    char text[400];
    std::snprintf(text, sizeof text,
                  "G21 G61 F%.17g\nG0 X%.17g Y%.17g Z%.17g\nG38.2 X%.17g Y%.17g Z%.17g\n#1=#5061\n#2=#5062\nM2\n",
                  feed * 60, start[0], start[1], start[2], start[0] + way[0], start[1] + way[1], start[2] + way[2]);
    machine::Machine machine = machine::mill3();
    machine.probe = machine::Probe{.bodies = {{machine::ProbeBody::Kind::sphere, centre, {}, radius}}};
    const auto simulated = host::Motion::of_program(machine, std::string(text));
    ASSERT_TRUE(simulated) << simulated.error().message;
    const base::Word last = last_word(**simulated);
    Probing real(text);
    base::Word word;
    std::optional<base::AxisVector> felt;
    double before = 0, step = 0;
    const auto travel = [&](const base::AxisVector& p) {
      double square = 0;
      for (std::size_t i = 0; i < 3; ++i) square += (p[i] - start[i]) * (p[i] - start[i]);
      return std::sqrt(square);
    };
    while (real.motion->next({&word, 1}) == 1) {
      double square = 0;
      for (std::size_t i = 0; i < 3; ++i) square += std::pow(word.position[i] - centre[i], 2);
      if (!felt && square <= radius * radius && real.motion->probing() == Search::contact) {
        felt = word.position;
        step = travel(word.position) - before;
        EXPECT_TRUE(real.motion->probe_found());
      }
      before = travel(word.position);
    }
    EXPECT_FALSE(real.motion->failure());
    ASSERT_TRUE(felt) << text;
    const double met = share * std::sqrt(a);
    EXPECT_NEAR(travel(last.position), met, 1e-9) << text;
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(last.position[i], start[i] + share * way[i], 1e-9) << text;
    EXPECT_GE(travel(*felt), met - 1e-9) << text;
    EXPECT_LE(travel(*felt), met + step + 1e-9) << text;
    EXPECT_GT(travel(word.position), travel(*felt));
    EXPECT_LE(travel(word.position), travel(*felt) + feed * 0.06 + feed * feed / 2000 + feed * 1000 / 40000) << text;
  }
}

TEST(HostProbe, IsAskedOnlyAlongItsMove) {
  Probing probing("G21 F600\nG0 Z-2\nG38.3 Z-4\nG0 Z-20\nM2\n");
  probing.run(-10);
  EXPECT_EQ(probing.found, 0);
  for (std::size_t i = 0; i < probing.words.size(); ++i) {
    const double z = probing.words[i].position[z_axis];
    const bool along = -3.99 < z && z < -2.01;
    if (!along && -4.01 <= z && z <= -1.99) continue;
    EXPECT_EQ(probing.searches[i], along ? Search::contact : Search::nothing) << z;
  }
  EXPECT_DOUBLE_EQ(probing.z_at_end(), -20);
}

TEST(HostProbe, TellsTheProgramWhetherItHasFound) {
  const std::string program = "G21 F600\nG38.3 Z-4\nG0 X[5+#5070]\nM2\n";
  Probing found(program), missed(program);
  found.run(-3);
  missed.run(-5);
  EXPECT_DOUBLE_EQ(found.words.back().position[0], 6);
  EXPECT_DOUBLE_EQ(missed.words.back().position[0], 5);
  EXPECT_DOUBLE_EQ(missed.z_at_end(), -4);
}

TEST(HostProbe, ThatMustFindEndsMotionWhereItDoesNot) {
  Probing probing("G21 F600\nG38.2 Z-4\nG0 X5\nM2\n");
  probing.run(-5);
  ASSERT_TRUE(probing.motion->failure());
  EXPECT_EQ(probing.motion->failure()->code, "probe-failed");
  EXPECT_EQ(probing.motion->failure()->place.line, 2);
  EXPECT_DOUBLE_EQ(probing.words.back().position[0], 0);
  EXPECT_DOUBLE_EQ(probing.z_at_end(), -4);
}

TEST(HostProbe, ThatTouchesBeforeItsMoveEndsMotion) {
  Probing probing("G21 F600 G0 Z-6\nG38.2 Z-9\nG0 X5\nM2\n");
  probing.run(-5);
  ASSERT_TRUE(probing.motion->failure());
  EXPECT_EQ(probing.motion->failure()->code, "probe-state");
  EXPECT_DOUBLE_EQ(probing.z_at_end(), -6);
}

TEST(HostProbe, GoesTowardsAndAway) {
  Probing probing("G21 F600\nG38.2 Z-40\nG38.4 Z0 F60\nG0 X[0-#5063]\nM2\n");
  probing.run(-7);
  EXPECT_FALSE(probing.motion->failure());
  EXPECT_NEAR(probing.words.back().position[0], 7, 0.002);
  EXPECT_GT(probing.words.back().position[0], 6.9);
}

TEST(HostProbe, TakesAPlaceThatWasMeasured) {
  Probing probing("G21 F600\nG38.2 Z-40\nG0 X[0-#5063]\nM2\n");
  base::Word word;
  for (bool told = false; probing.motion->next({&word, 1}) == 1;) {
    if (told || word.position[z_axis] > -3) continue;
    EXPECT_TRUE(probing.motion->probe_found(base::AxisVector{0, 0, -2.75}));
    EXPECT_TRUE(probing.motion->probe_found(base::AxisVector{0, 0, -2.5}));  // the first counts
    told = true;
  }
  EXPECT_DOUBLE_EQ(word.position[0], 2.75);
}

TEST(HostProbe, FindsWhileHeld) {
  Probing probing("G21 F600\nG38.2 Z-40\nG0 X[0-#5063]\nM2\n");
  base::Word word;
  while (probing.motion->next({&word, 1}) == 1 && word.position[z_axis] > -3) {
  }
  ASSERT_TRUE(probing.motion->override_feed(0));
  while (probing.motion->next({&word, 1}) == 1) {
  }
  EXPECT_EQ(probing.motion->progress(), pipeline::Progress::held);
  ASSERT_TRUE(probing.motion->probe_found());
  ASSERT_TRUE(probing.motion->override_feed(1));
  const double z = word.position[z_axis];
  while (probing.motion->next({&word, 1}) == 1) {
  }
  EXPECT_FALSE(probing.motion->failure());
  EXPECT_DOUBLE_EQ(word.position[0], -z);
  EXPECT_NEAR(word.position[z_axis], z, 1e-5);  // rest comes between two words
}

TEST(HostProbe, IsRefusedWhereNothingIsProbed) {
  Probing probing("G21 F600\nG1 X1\nG38.2 Z-4\nM2\n");
  EXPECT_EQ(probing.motion->probe_found().error().code, "probe-idle");
  base::Word word;
  ASSERT_EQ(probing.motion->next({&word, 1}), 1u);
  EXPECT_EQ(probing.motion->probe_found().error().code, "probe-idle");
  while (probing.motion->probing() == Search::nothing && probing.motion->next({&word, 1}) == 1) {
  }
  EXPECT_EQ(probing.motion->probe_found(base::AxisVector{NAN}).error().code, "move-finite");
}

TEST(HostProbe, IsPlannedAsIfItTouchedWhereItsMoveLeads) {
  Probing probing("G21 F600\nG38.2 Z-4\nG0 X[0-#5063]\nM2\n");
  const auto planned = probing.motion->plan();
  ASSERT_TRUE(planned);
  EXPECT_DOUBLE_EQ(planned->at(planned->duration()).position[0], 4);
}

TEST(HostProbe, IsSimulatedWhereTheHostHasNone) {
  Probing probing("G21 F600\nG38.2 Z-4\nG0 X[0-#5063]\nM2\n", false);
  probing.run(-1);
  EXPECT_EQ(probing.found, 0);
  EXPECT_DOUBLE_EQ(probing.words.back().position[0], 4);
}

}  // namespace test_probe
