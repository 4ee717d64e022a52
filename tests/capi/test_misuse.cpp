#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "called.hpp"

// A code for every misuse, and for whatever is wrong with a program or a move.

using namespace leadscrew;
using namespace leadscrew::capi_tests;

namespace test_misuse {

TEST(Capi, SaysWhatIsWrongWithAProgram) {
  leadscrew_error error = sized_error();
  leadscrew_motion* motion = nullptr;
  std::vector<std::string> codes;
  leadscrew_options options = no_options();
  options.user = &codes;
  options.on_diagnostic = [](const leadscrew_error* found, void* user) {
    static_cast<std::vector<std::string>*>(user)->emplace_back(found->code);
  };
  const std::string text = "G21 G90\nG1 X5000 F100\nG77\nM2\n";
  EXPECT_EQ(leadscrew_motion_of_program(mill().get(), text.data(), text.size(), &options, &motion, &error),
            LEADSCREW_REJECTED);
  EXPECT_EQ(motion, nullptr);
  EXPECT_EQ(error.line, 2);
  EXPECT_STREQ(error.code, "travel");
  EXPECT_EQ(codes.size(), 2U);
}

TEST(Capi, SaysWhatIsWrongWithAMove) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  leadscrew_move other_axis = line(1, 0, 0, 50);
  other_axis.end[3] = 1;
  leadscrew_move still = line(0, 0, 0, 50);
  still.kind = LEADSCREW_DWELL;
  still.seconds = -1;
  const std::pair<leadscrew_move, const char*> wrong[] = {
      {line(nan, 0, 0, 50), "move-finite"},
      {line(inf, 0, 0, 50), "move-finite"},
      {line(1, 0, 0, 0), "move-feed"},
      {line(1, 0, 0, -inf), "move-feed"},
      {line(1, 0, 0, nan), "move-feed"},
      {line(1e6, 0, 0, 50), "travel"},
      {other_axis, "move-axis"},
      {still, "move-time"},
      {arc(10, 0, 5, 0, 0, 50), "arc-turns"},
      {arc(10, 0, 4, 0, 1, 50), "arc-radius"},
      {arc(10, 0, nan, 0, 1, 50), "move-finite"},
      {arc(0, 0, -400, 0, 1, 50), "travel"},
  };
  const Motion motion = moves();
  for (const auto& [move, code] : wrong) {
    leadscrew_error error = sized_error();
    EXPECT_EQ(leadscrew_motion_push(motion.get(), &move, &error), LEADSCREW_REJECTED) << code;
    EXPECT_STREQ(error.code, code) << error.message;
  }
  const leadscrew_move right = line(1, 0, 0, 50);
  ASSERT_EQ(leadscrew_motion_push(motion.get(), &right, nullptr), LEADSCREW_OK);
  leadscrew_motion_finish(motion.get());
  expect_same(words_of(motion.get()), pipeline_words("G1 X1 F3000\nM2\n"), false);
}

TEST(Capi, SaysWhatIsWrongWithACurve) {
  double positions[4 * LEADSCREW_AXES] = {};
  for (int i = 0; i < 4; ++i) positions[LEADSCREW_AXES * i] = i;
  leadscrew_move right{};
  right.size = sizeof right;
  right.kind = LEADSCREW_CURVE;
  right.degree = 3;
  right.points = 4;
  right.positions = positions;
  right.feed = 50;
  const auto expect = [&](const leadscrew_move& move, const char* code, int result = LEADSCREW_REJECTED) {
    leadscrew_error error = sized_error();
    EXPECT_EQ(leadscrew_motion_push(moves().get(), &move, &error), result) << code;
    EXPECT_STREQ(error.code, code) << error.message;
  };
  leadscrew_move move = right;
  move.degree = 6;
  expect(move, "misuse", LEADSCREW_MISUSE);
  move = right;
  move.positions = nullptr;
  expect(move, "misuse", LEADSCREW_MISUSE);
  move = right;
  move.points = 3;
  expect(move, "curve-points");
  const double weights[] = {1, 0, 1, 1}, falling[] = {0, 0, 0, 0, 1, 1, 1, .5}, often[] = {0, 0, 0, 0, 0, 1, 1, 1},
               point[] = {0, 0, 0, 0, 0, 0, 0, 0};
  move = right;
  move.weights = weights;
  expect(move, "curve-weight");
  move = right;
  move.knots = falling;
  expect(move, "knot-order");
  move.knots = often;
  expect(move, "knot-multiplicity");
  move.knots = point;
  expect(move, "knot-multiplicity");
  positions[0] = 1;
  expect(right, "curve-start");
}

TEST(Capi, ReturnsACodeForEveryMisuse) {
  const Machine machine = mill();
  leadscrew_machine* other = nullptr;
  leadscrew_motion* made = nullptr;
  leadscrew_word word;
  std::size_t count = 7;
  leadscrew_options short_options = no_options();
  short_options.size = 8;
  leadscrew_move short_move = line(1, 0, 0, 50), strange = short_move;
  short_move.size = 0;
  strange.kind = 9;
  leadscrew_move before_all = line(1, 0, 0, 50);
  before_all.line = -1;
  leadscrew_options long_options = no_options(), two_tables = no_options(), endless_tools = no_options();
  long_options.size = SIZE_MAX;
  two_tables.tools = two_tables.tools_file = "";
  endless_tools.tools = "";
  endless_tools.tools_length = SIZE_MAX;
  const double position[LEADSCREW_AXES] = {};
  const Motion motion = moves();
  leadscrew_trajectory* planned = nullptr;
  ASSERT_EQ(leadscrew_motion_plan(motion.get(), &planned, nullptr), LEADSCREW_OK);
  const Trajectory trajectory(planned);
  leadscrew_pose pose{};
  const double not_a_time = std::numeric_limits<double>::quiet_NaN();
  leadscrew_state state{}, short_state{};
  state.size = sizeof state;
  short_state.size = 335;  // the first version's has 336
  const int codes[] = {
      leadscrew_machine_builtin(nullptr, &other, nullptr),
      leadscrew_machine_builtin("mill3", nullptr, nullptr),
      leadscrew_machine_of_text(nullptr, 0, &other, nullptr),
      leadscrew_machine_of_file(nullptr, &other, nullptr),
      leadscrew_motion_of_program(nullptr, "", 0, nullptr, &made, nullptr),
      leadscrew_motion_of_program(machine.get(), nullptr, 0, nullptr, &made, nullptr),
      leadscrew_motion_of_program(machine.get(), "", 0, &short_options, &made, nullptr),
      leadscrew_motion_of_program(machine.get(), "", SIZE_MAX, nullptr, &made, nullptr),
      leadscrew_machine_of_text("", SIZE_MAX, &other, nullptr),
      leadscrew_motion_of_moves(machine.get(), nullptr, nullptr, nullptr),
      leadscrew_motion_smooth(nullptr, 0, nullptr),
      leadscrew_motion_push(nullptr, &strange, nullptr),
      leadscrew_motion_push(motion.get(), nullptr, nullptr),
      leadscrew_motion_push(motion.get(), &short_move, nullptr),
      leadscrew_motion_push(motion.get(), &strange, nullptr),
      leadscrew_motion_push(motion.get(), &before_all, nullptr),
      leadscrew_motion_end_for_now(nullptr),
      leadscrew_motion_finish(nullptr),
      leadscrew_motion_next(nullptr, &word, sizeof word, 1, &count, nullptr),
      leadscrew_motion_next(motion.get(), nullptr, sizeof word, 1, &count, nullptr),
      leadscrew_motion_next(motion.get(), &word, sizeof word - 1, 1, &count, nullptr),
      leadscrew_motion_next(motion.get(), &word, sizeof word, 1, nullptr, nullptr),
      leadscrew_motion_override(nullptr, 1, nullptr),
      leadscrew_motion_abort(nullptr),
      leadscrew_motion_reset(nullptr, position, nullptr),
      leadscrew_motion_reset(motion.get(), nullptr, nullptr),
      leadscrew_motion_of_moves(machine.get(), &long_options, &made, nullptr),
      leadscrew_motion_of_moves(machine.get(), &two_tables, &made, nullptr),
      leadscrew_motion_of_moves(machine.get(), &endless_tools, &made, nullptr),
      leadscrew_motion_plan(nullptr, &planned, nullptr),
      leadscrew_motion_plan(motion.get(), nullptr, nullptr),
      leadscrew_trajectory_at(nullptr, 0, &state, nullptr),
      leadscrew_trajectory_at(trajectory.get(), 0, nullptr, nullptr),
      leadscrew_trajectory_at(trajectory.get(), 0, &short_state, nullptr),
      leadscrew_trajectory_at(trajectory.get(), std::numeric_limits<double>::quiet_NaN(), &state, nullptr),
      leadscrew_trajectory_sample(nullptr, position, 1, &state, sizeof state, nullptr, 0, nullptr),
      leadscrew_trajectory_sample(trajectory.get(), nullptr, 1, &state, sizeof state, nullptr, 0, nullptr),
      leadscrew_trajectory_sample(trajectory.get(), position, 1, nullptr, sizeof state, nullptr, 0, nullptr),
      leadscrew_trajectory_sample(trajectory.get(), position, 1, &state, 335, nullptr, 0, nullptr),
      leadscrew_trajectory_sample(trajectory.get(), position, 1, &state, sizeof state, &pose, 8, nullptr),
      leadscrew_trajectory_sample(trajectory.get(), &not_a_time, 1, &state, sizeof state, nullptr, 0, nullptr),
  };
  for (const int code : codes) EXPECT_EQ(code, LEADSCREW_MISUSE) << &code - codes;
  EXPECT_EQ(leadscrew_motion_override(motion.get(), 2.5, nullptr), LEADSCREW_REJECTED);
  EXPECT_EQ(leadscrew_motion_smooth(motion.get(), -1, nullptr), LEADSCREW_REJECTED);
  EXPECT_EQ(leadscrew_machine_builtin("lathe", &other, nullptr), LEADSCREW_REJECTED);
  EXPECT_EQ(leadscrew_machine_of_text("axis = 3", 8, &other, nullptr), LEADSCREW_REJECTED);
  EXPECT_EQ(leadscrew_machine_of_file("/nowhere.toml", &other, nullptr), LEADSCREW_INPUT);
  EXPECT_EQ(other, nullptr);
  EXPECT_EQ(made, nullptr);
  EXPECT_EQ(leadscrew_motion_progress(nullptr), LEADSCREW_ENDED);
  EXPECT_EQ(leadscrew_machine_period(nullptr), 0);
  EXPECT_EQ(leadscrew_trajectory_duration(nullptr), 0);
  leadscrew_motion_free(nullptr);
  leadscrew_machine_free(nullptr);
  leadscrew_trajectory_free(nullptr);
}

TEST(Capi, IsNotUsedFromWithinItself) {
  struct Seen {
    leadscrew_motion* motion = nullptr;
    int code = 0;
  } seen;
  leadscrew_options options = no_options();
  options.user = &seen;
  options.on_event = [](const leadscrew_event*, void* user) {
    auto* const self = static_cast<Seen*>(user);
    self->code = leadscrew_motion_abort(self->motion);
    leadscrew_motion_free(self->motion);
  };
  const Motion motion = program("G1 X1 F1000\nM2\n", options);
  seen.motion = motion.get();
  words_of(motion.get());
  EXPECT_EQ(seen.code, LEADSCREW_MISUSE);
}

TEST(Capi, LeavesLongerStructuresOfLaterVersionsAlone) {
  struct Later {
    leadscrew_error error;
    char more[16];
  } later{};
  later.error.size = sizeof later;
  std::memset(later.more, 7, sizeof later.more);
  leadscrew_machine* machine = nullptr;
  EXPECT_EQ(leadscrew_machine_builtin("lathe", &machine, &later.error), LEADSCREW_REJECTED);
  EXPECT_EQ(later.error.size, sizeof later);
  EXPECT_STREQ(later.error.code, "machine-name");
  EXPECT_EQ(later.more[0], 7);

  struct LaterWord {
    leadscrew_word word;
    double more;
  };
  std::vector<LaterWord> words(10);
  for (LaterWord& word : words) word.more = 3;
  std::size_t count = 0;
  const Motion motion = program(plate);
  ASSERT_EQ(leadscrew_motion_next(motion.get(), &words[0].word, sizeof words[0], 10, &count, nullptr), LEADSCREW_OK);
  ASSERT_EQ(count, 10U);
  for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(words[i].word.tick, static_cast<std::int64_t>(i));
  for (const LaterWord& word : words) EXPECT_EQ(word.more, 3);
}

/// Memory of just so many bytes, which hold a structure that says so.
template <class Struct>
std::unique_ptr<char[]> of_size(Struct given, std::size_t size) {
  given.size = size;
  std::unique_ptr<char[]> bytes(new char[size]());
  std::memcpy(bytes.get(), &given, std::min(size, sizeof given));
  return bytes;
}

TEST(Capi, UnderstandsShorterStructuresOfEarlierVersions) {
  constexpr std::size_t first = offsetof(leadscrew_options, tools);
  leadscrew_options options = no_options();
  options.start[0] = 3;
  const auto earlier = of_size(options, first);
  leadscrew_motion* made = nullptr;
  ASSERT_EQ(leadscrew_motion_of_moves(mill().get(), reinterpret_cast<const leadscrew_options*>(earlier.get()), &made,
                                      nullptr),
            LEADSCREW_OK);
  const Motion motion(made);
  leadscrew_motion_finish(motion.get());
  EXPECT_EQ(words_of(motion.get()).front().position[0], 3);
  const auto shorter = of_size(options, first - 1);
  EXPECT_EQ(leadscrew_motion_of_moves(mill().get(), reinterpret_cast<const leadscrew_options*>(shorter.get()), &made,
                                      nullptr),
            LEADSCREW_MISUSE);
}

TEST(Capi, UnderstandsLongerStructuresAsLongAsTheyAskForNothingNew) {
  const auto options = of_size(no_options(), sizeof(leadscrew_options) + 24);
  const auto move = of_size(line(1, 0, 0, 50), sizeof(leadscrew_move) + 8);
  const auto* later_options = reinterpret_cast<const leadscrew_options*>(options.get());
  const auto* later_move = reinterpret_cast<const leadscrew_move*>(move.get());
  leadscrew_motion* made = nullptr;
  ASSERT_EQ(leadscrew_motion_of_moves(mill().get(), later_options, &made, nullptr), LEADSCREW_OK);
  const Motion motion(made);
  EXPECT_EQ(leadscrew_motion_push(motion.get(), later_move, nullptr), LEADSCREW_OK);
  options[sizeof(leadscrew_options) + 23] = 1;
  move[sizeof(leadscrew_move)] = 1;
  EXPECT_EQ(leadscrew_motion_of_moves(mill().get(), later_options, &made, nullptr), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_motion_push(motion.get(), later_move, nullptr), LEADSCREW_MISUSE);
}

TEST(Capi, TellsWhatIsWrongWithTools) {
  const std::string text = "G1 X1 F100\nM2\n";
  const auto result = [&](const leadscrew_options& options, leadscrew_error& error) {
    leadscrew_motion* motion = nullptr;
    const int code = leadscrew_motion_of_program(mill().get(), text.data(), text.size(), &options, &motion, &error);
    EXPECT_EQ(motion, nullptr);
    return code;
  };
  leadscrew_error error = sized_error();
  leadscrew_options options = no_options();
  options.tools = "T1 P1 Z3\nT1 P2\n";
  options.tools_length = std::strlen(options.tools);
  EXPECT_EQ(result(options, error), LEADSCREW_REJECTED);
  EXPECT_STREQ(error.code, "repeated-tool");
  EXPECT_EQ(error.line, 2);
  options = no_options();
  options.tools_file = "/nowhere.tbl";
  EXPECT_EQ(result(options, error), LEADSCREW_INPUT);
  EXPECT_STREQ(error.code, "io-open");
}

TEST(Capi, OutlivesItsMachine) {
  Machine machine = mill();
  leadscrew_motion* made = nullptr;
  ASSERT_EQ(leadscrew_motion_of_program(machine.get(), plate.data(), plate.size(), nullptr, &made, nullptr),
            LEADSCREW_OK);
  const Motion motion(made);
  machine.reset();
  expect_same(words_of(motion.get()), pipeline_words(plate));
}

}  // namespace test_misuse
