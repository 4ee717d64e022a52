#include <cmath>
#include <cstring>

#include "paths.hpp"

// A host's motion has the words of the pipeline, whoever gives its moves, and whenever.

namespace test_motion {

using namespace leadscrew;
using namespace leadscrew::host_tests;

std::vector<gcode::Move> moves_of(const std::string& text) {
  std::vector<gcode::Move> moves;
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools;
  gcode::Reader reader(gcode::text_source(text), machine, tools, {}, [](const base::Diagnostic&) {});
  for (gcode::Move move; reader.next(move);) {
    if (move.kind != gcode::Move::Kind::event) moves.push_back(move);
  }
  return moves;
}

/// The end of a program has a line of its own, which its last word has.
bool same(const std::vector<base::Word>& a, const std::vector<base::Word>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].tick != b[i].tick || (i + 1 < a.size() && a[i].line != b[i].line) || a[i].state != b[i].state)
      return false;
    if (std::memcmp(&a[i].position, &b[i].position, sizeof a[i].position) != 0) return false;
  }
  return true;
}

RC_GTEST_PROP(HostMotion, OfMovesHasTheWordsOfTheirProgram, ()) {
  const std::string text = random_path();
  RC_LOG() << text;
  const std::vector<gcode::Move> moves = moves_of(text);
  const std::vector<base::Word> expected = words_of(*program(text));
  host::Motion motion(machine::mill3());
  RC_ASSERT(motion.smooth(0.01).has_value());
  std::vector<base::Word> words;
  for (const gcode::Move& move : moves) {
    RC_ASSERT(motion.push(move).has_value());
    if (*rc::gen::inRange(0, 3) == 0) {  // what is known by now
      const auto some = words_of(motion, static_cast<std::size_t>(*rc::gen::inRange(1, 50)));
      words.insert(words.end(), some.begin(), some.end());
      RC_ASSERT(motion.progress() == pipeline::Progress::wants_moves);
    }
  }
  motion.finish();
  const auto rest = words_of(motion);
  words.insert(words.end(), rest.begin(), rest.end());
  RC_ASSERT(motion.progress() == pipeline::Progress::ended);
  RC_ASSERT(same(words, expected));
}

TEST(HostMotion, RefusesAProgramWithAnError) {
  std::vector<std::string> codes;
  const auto motion = host::Motion::of_program(machine::mill3(), "G1 X5000 F100\nG77\nM2\n", {},
                                               [&](const base::Diagnostic& found) { codes.emplace_back(found.code); });
  ASSERT_FALSE(motion);
  EXPECT_EQ(motion.error().code, "travel");
  EXPECT_EQ(codes.size(), 2U);
}

TEST(HostMotion, MachinesASurfaceThatTheToolGougesWhereTheHostAllowsIt) {
  // A trough of radius 11.1 mm at its bottom, a ball of 20.
  const std::string text =
      "G0 Z50\nG6.4 D1 P3 Q2 I3 J2\nX0 Y0 Z9\nX10 Z0\nX20 Z9\nX0 Y20\nX10 Z0\nX20 Z9\n"
      "G6.5 D1 T1 Q3 L2 Z30 F3000\nM2\n";
  machine::Tool ball;
  ball.number = 1;
  ball.diameter = 40;
  ball.corner_radius = 20;
  host::MotionOptions options;
  options.tools = machine::ToolTable({ball});
  const auto refused = host::Motion::of_program(machine::mill3(), text, options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "surface-gouge");
  options.allows_gouging = true;
  const std::unique_ptr<host::Motion> allowed = program(text, options);
  ASSERT_TRUE(allowed);
  const auto planned = allowed->plan();
  ASSERT_TRUE(planned);
  EXPECT_GT(planned->duration(), 1);
  std::size_t low = 0;
  for (const base::Word& word : words_of(*allowed)) low += word.position[2] < 10;
  EXPECT_GT(low, 1000U);
  EXPECT_FALSE(allowed->failure());
}

/// Lines enough that reading them asks several times.
const std::string long_program = [] {
  std::string text = "G21 G90 G64 P0.01 F3000\n";
  for (int i = 0; i < 4000; ++i) text += "G1 X" + std::to_string(i % 7) + " Y" + std::to_string(i % 11) + "\n";
  return text + "M2\n";
}();

TEST(HostMotion, TellsHowMuchOfAProgramItHasRead) {
  std::vector<double> shares;
  host::MotionOptions options;
  options.goes_on = [&](double share) {
    shares.push_back(share);
    return true;
  };
  program(long_program, options);
  ASSERT_GT(shares.size(), 5U);
  EXPECT_EQ(shares.front(), 0);
  EXPECT_GT(shares.back(), 0.9);
  EXPECT_LE(shares.back(), 1);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
}

TEST(HostMotion, ReadsNoFurtherThanItIsWanted) {
  int asked = 0;
  host::MotionOptions options;
  options.goes_on = [&](double) { return ++asked < 5; };
  const auto motion = host::Motion::of_program(machine::mill3(), long_program, options);
  ASSERT_FALSE(motion);
  EXPECT_EQ(motion.error().code, "interrupted");
  EXPECT_EQ(asked, 5);
  // One block of many moves.
  asked = 0;
  const auto repeated = host::Motion::of_program(machine::mill3(), "G91 G81 Z-1 R0 L100000 F3000\nM2\n", options);
  ASSERT_FALSE(repeated);
  EXPECT_EQ(repeated.error().code, "interrupted");
}

TEST(HostMotion, RestsOnItsPathWhenItsPlanningIsInterrupted) {
  bool goes_on = true;
  host::MotionOptions options;
  options.goes_on = [&](double) { return goes_on; };
  const auto motion = program(long_program, options);
  ASSERT_TRUE(motion);
  std::vector<base::Word> words(1000);
  ASSERT_EQ(motion->next(words), words.size());
  goes_on = false;
  const auto rest = words_of(*motion);
  ASSERT_FALSE(rest.empty());
  EXPECT_LT(rest.size(), 2000U);
  EXPECT_EQ(rest.back().state, base::MotionState::rest);
  EXPECT_EQ(motion->progress(), pipeline::Progress::ended);
  ASSERT_TRUE(motion->failure());
  EXPECT_EQ(motion->failure()->code, "interrupted");
  EXPECT_EQ(motion->plan().error().code, "interrupted");
}

TEST(HostMotion, TellsEventsWithTheirWords) {
  std::vector<std::string> codes;
  host::MotionOptions options;
  options.on_event = [&](const base::PassedEvent& event) { codes.emplace_back(base::code_of(event)); };
  words_of(*program("G21 G90\nG1 X5 F3000\nM8\nX10\nM3 S100\nX0\nM2\n", options));
  EXPECT_EQ(codes, (std::vector<std::string>{"M8", "S", "M3", "M2"}));
}

TEST(HostMotion, RestsWhereItEndsForNowAndIsResetAtItsEnd) {
  host::Motion motion(machine::mill3());
  ASSERT_TRUE(motion.push(host::line({10}, 50)));
  ASSERT_TRUE(motion.push(host::line({10, 10}, host::rapid)));
  motion.end_for_now();
  const auto first = words_of(motion);
  ASSERT_FALSE(first.empty());
  EXPECT_EQ(motion.progress(), pipeline::Progress::wants_moves);
  EXPECT_FALSE(motion.reset({}));
  ASSERT_TRUE(motion.push(host::dwell(0.1)));
  motion.finish();
  EXPECT_EQ(motion.push(host::line({}, 50)).error().code, "motion-ended");
  const auto second = words_of(motion);
  ASSERT_FALSE(second.empty());
  EXPECT_EQ(second.back().position, (base::AxisVector{10, 10}));
  EXPECT_GE(second.size(), 100U);
  EXPECT_EQ(motion.reset({1e9}).error().code, "travel");
  ASSERT_TRUE(motion.reset({10, 10}));
  ASSERT_TRUE(motion.push(host::line({}, 50)));
  motion.finish();
  const auto third = words_of(motion);
  EXPECT_EQ(base::count(third.front().tick), 0);
  EXPECT_EQ(third.back().position, base::AxisVector{});
}

TEST(HostMotion, LeavesNothingChangedByAMoveThatIsRefused) {
  host::Motion motion(machine::mill3());
  EXPECT_EQ(motion.push(host::line({0, 0, 0, 5}, 50)).error().code, "move-axis");
  EXPECT_EQ(motion.push(host::line({NAN}, 50)).error().code, "move-finite");
  EXPECT_EQ(motion.push(host::arc({}, gcode::Plane::XY, 0, 500, 1, 50)).error().code, "travel");
  EXPECT_EQ(motion.push(host::dwell(-1)).error().code, "move-time");
  EXPECT_EQ(motion.smooth(NAN).error().code, "tolerance");
  EXPECT_EQ(motion.override_feed(-0.1).error().code, "override");
  EXPECT_EQ(motion.end(), base::AxisVector{});
  motion.finish();
  EXPECT_TRUE(words_of(motion).size() <= 1);
}

}  // namespace test_motion
