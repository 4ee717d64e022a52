#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "called.hpp"

// The C interface gives the words of the pipeline, bit for bit.

using namespace leadscrew;
using namespace leadscrew::capi_tests;

namespace test_motion {

const std::string two_lines_and_an_arc = "G21 G90 G17\nG1 X10 F3000\nG3 X10 Y10 I0 J5\nG1 X0 Y10 Z2\nM2\n";

TEST(Capi, GivesTheWordsOfAProgram) {
  for (const std::size_t capacity : {1U, 7U, 100U, 5000U})
    expect_same(words_of(program(plate).get(), capacity), pipeline_words(plate));
}

TEST(Capi, GivesTheWordsOfMoves) {
  const Motion motion = moves();
  for (const leadscrew_move& move : {line(10, 0, 0, 50), arc(10, 10, 10, 5, 1, 50), line(0, 10, 2, 50)})
    ASSERT_EQ(leadscrew_motion_push(motion.get(), &move, nullptr), LEADSCREW_OK);
  leadscrew_motion_finish(motion.get());
  expect_same(words_of(motion.get()), pipeline_words(two_lines_and_an_arc), false);
  EXPECT_EQ(leadscrew_motion_progress(motion.get()), LEADSCREW_ENDED);
}

TEST(Capi, GivesTheWordsOfACurve) {
  const double positions[] = {0,  0,   0, 0, 0, 0, 0, 0, 0, 5,  10, 0, 0, 0, 0, 0, 0, 0,
                              15, -10, 0, 0, 0, 0, 0, 0, 0, 20, 0,  0, 0, 0, 0, 0, 0, 0};
  leadscrew_move curve{};
  curve.size = sizeof curve;
  curve.kind = LEADSCREW_CURVE;
  curve.degree = 3;
  curve.points = 4;
  curve.positions = positions;
  curve.feed = 100;
  const Motion motion = moves();
  ASSERT_EQ(leadscrew_motion_push(motion.get(), &curve, nullptr), LEADSCREW_OK);
  leadscrew_motion_finish(motion.get());
  expect_same(words_of(motion.get()), pipeline_words("G17 G5 X20 Y0 I5 J10 P-5 Q-10 F6000\nM2\n"), false);
}

std::string output_of(const std::string& command) {
  std::string output;
  std::FILE* pipe = popen(command.c_str(), "r");
  for (std::array<char, 4096> part; const std::size_t count = std::fread(part.data(), 1, part.size(), pipe);)
    output.append(part.data(), count);
  EXPECT_EQ(pclose(pipe), 0) << command;
  return output;
}

void expect_printed(const std::string& output, const std::vector<base::Word>& words) {
  std::istringstream lines(output);
  for (const base::Word& word : words) {
    long long tick = -1;
    std::string x, y, z;
    lines >> tick >> x >> y >> z;
    ASSERT_EQ(tick, base::count(word.tick));
    ASSERT_EQ(std::stod(x), word.position[0]);
    ASSERT_EQ(std::stod(y), word.position[1]);
    ASSERT_EQ(std::stod(z), word.position[2]);
  }
  std::string more;
  EXPECT_FALSE(lines >> more);
}

TEST(Capi, ExampleInCPrintsTheWords) {
  expect_printed(output_of(LEADSCREW_WORDS_BY_C " " LEADSCREW_SOURCE_DIR "/examples/01-plate.ngc"),
                 pipeline_words(plate));
  expect_printed(output_of(LEADSCREW_WORDS_BY_C), pipeline_words(two_lines_and_an_arc));
}

TEST(Capi, TellsEventsInOrder) {
  const std::string text = "G21 G90\nG1 X5 F3000\nM8\nX10\nS500 M3\nX20\nM2\n";
  std::vector<std::string> codes;
  leadscrew_options options = no_options();
  options.user = &codes;
  options.on_event = [](const leadscrew_event* event, void* user) {
    EXPECT_EQ(event->size, sizeof *event);
    static_cast<std::vector<std::string>*>(user)->emplace_back(event->code);
  };
  words_of(program(text, options).get());
  EXPECT_EQ(codes, (std::vector<std::string>{"M8", "S", "M3", "M2"}));
}

constexpr char side[] = "o<side> sub\nG91 G1 X#1 F1200\nG90\no<side> endsub\nM2\n";

/// A folder of one subprogram, and what it was asked for.
struct Folder {
  std::vector<std::string> asked;

  leadscrew_options options() {
    leadscrew_options options = no_options();
    options.user = this;
    options.on_subprogram = [](const char* name, const char** text, std::size_t* length, void* user) {
      static_cast<Folder*>(user)->asked.emplace_back(name);
      *text = side;
      *length = sizeof side - 1;
      return std::strcmp(name, "side") == 0 ? 0 : 1;
    };
    return options;
  }
};

TEST(Capi, CallsSubprogramsOfTheHost) {
  Folder folder;
  const Motion motion =
      program("G21 G90 G64 P0.01\no<Side> call [10]\no<side> call [5]\nG1 Y3\nM2\n", folder.options());
  const auto words = words_of(motion.get());
  EXPECT_EQ(folder.asked, std::vector<std::string>{"side"});
  expect_same(words, pipeline_words("G21 G90 G64 P0.01\nG1 X10 F1200\nX15\nY3\nM2\n"), false);
  const leadscrew_word &first = words[words.size() / 4], &second = words[words.size() * 2 / 3], &last = words.back();
  EXPECT_EQ(first.line, 2);
  EXPECT_EQ(first.file, 1);
  EXPECT_EQ(second.line, 2);
  EXPECT_EQ(second.file, 1);
  EXPECT_GT(second.visit, first.visit);
  EXPECT_EQ(last.line, 5);
  EXPECT_EQ(last.file, 0);
  EXPECT_GT(last.visit, second.visit);
}

TEST(Capi, SaysWhichSubprogramIsMissing) {
  Folder folder;
  const leadscrew_options options = folder.options();
  const std::string text = "G21\no<edge> call\nM2\n";
  leadscrew_motion* motion = nullptr;
  leadscrew_error error = sized_error();
  EXPECT_EQ(leadscrew_motion_of_program(mill().get(), text.data(), text.size(), &options, &motion, &error),
            LEADSCREW_REJECTED);
  EXPECT_STREQ(error.code, "missing-sub");
  EXPECT_EQ(error.line, 2);
  EXPECT_EQ(folder.asked, std::vector<std::string>{"edge"});
}

TEST(Capi, EndsLoopsWhoseFuelIsUsedUp) {
  const std::string text = "G21 G90\n#1=0\no1 while [#1 lt 50]\n#1=[#1+1]\no1 endwhile\nM2\n";
  leadscrew_options options = no_options();
  leadscrew_error error = sized_error();
  const auto code = [&](std::int64_t fuel) {
    leadscrew_motion* motion = nullptr;
    options.fuel = fuel;
    const int result = leadscrew_motion_of_program(mill().get(), text.data(), text.size(), &options, &motion, &error);
    leadscrew_motion_free(motion);
    return result;
  };
  EXPECT_EQ(code(0), LEADSCREW_OK);
  EXPECT_EQ(code(1000), LEADSCREW_OK);
  EXPECT_EQ(code(50), LEADSCREW_REJECTED);
  EXPECT_STREQ(error.code, "fuel-exhausted");
  EXPECT_EQ(code(-1), LEADSCREW_REJECTED);
  EXPECT_STREQ(error.code, "fuel");
}

TEST(Capi, MachinesASurfaceThatTheToolGougesWhereThatIsAllowed) {
  // A trough of radius 11.1 mm at its bottom, a ball of 20.
  const std::string text =
      "G0 Z50\nG6.4 D1 P3 Q2 I3 J2\nX0 Y0 Z9\nX10 Z0\nX20 Z9\nX0 Y20\nX10 Z0\nX20 Z9\n"
      "G6.5 D1 T1 Q3 L2 Z30 F3000\nM2\n";
  const std::string tools = "T1 D40 R20\n";
  leadscrew_options options = no_options();
  options.tools = tools.data();
  options.tools_length = tools.size();
  leadscrew_error error = sized_error();
  leadscrew_motion* motion = nullptr;
  EXPECT_EQ(leadscrew_motion_of_program(mill().get(), text.data(), text.size(), &options, &motion, &error),
            LEADSCREW_REJECTED);
  EXPECT_STREQ(error.code, "surface-gouge");
  EXPECT_EQ(error.line, 9);
  options.allow_gouging = 1;
  const auto words = words_of(program(text, options).get());
  EXPECT_GT(std::count_if(words.begin(), words.end(), [](const auto& word) { return word.position[2] < 10; }), 1000);
}

TEST(Capi, TellsFunctionsOfTheMachine) {
  const std::string text = "G21 G90\nM19 R90 Q1.5 P2\nM66 P3 L4 Q2\nG1 X5 F3000\nM50 P0\nM101 P1 Q-2\nM2\n";
  std::vector<leadscrew_event> events;
  leadscrew_options options = no_options();
  options.user = &events;
  options.on_event = [](const leadscrew_event* event, void* user) {
    static_cast<std::vector<leadscrew_event>*>(user)->push_back(*event);
  };
  words_of(program(text, options).get());
  const struct {
    const char* code;
    int waits, output;
    double value, q;
  } rows[] = {{"M19", 1, 2, 90, 1.5}, {"M66", 1, 3, 4, 2}, {"M50", 0, 0, 0, 0}, {"M101", 1, 101, 1, -2}};
  ASSERT_EQ(events.size(), std::size(rows) + 1);
  for (std::size_t i = 0; i < std::size(rows); ++i) {
    EXPECT_STREQ(events[i].code, rows[i].code);
    EXPECT_EQ(events[i].waits, rows[i].waits) << i;
    EXPECT_EQ(events[i].output, rows[i].output) << i;
    EXPECT_EQ(events[i].value, rows[i].value) << i;
    EXPECT_EQ(events[i].q, rows[i].q) << i;
  }
}

TEST(Capi, AsksForInputs) {
  leadscrew_options options = no_options();
  options.has_inputs = 1;
  const Motion motion = program("G21 G90 F3000\nG1 X5\nM66 P0\nG1 X[10 * #5399]\nM2\n", options);
  EXPECT_EQ(leadscrew_motion_input_is(motion.get(), 1, nullptr), LEADSCREW_REJECTED);
  words_of(motion.get());
  EXPECT_EQ(leadscrew_motion_progress(motion.get()), LEADSCREW_WANTS_INPUT);
  EXPECT_EQ(leadscrew_motion_input_is(motion.get(), 1, nullptr), LEADSCREW_OK);
  EXPECT_EQ(words_of(motion.get()).back().position[0], 10);
  EXPECT_EQ(leadscrew_motion_progress(motion.get()), LEADSCREW_ENDED);
}

TEST(Capi, AdaptsTheFeedBehindM52) {
  const Motion motion = program("G21 G90 G61 F3000\nG1 X50\nM52\nG1 X100\nM2\n");
  EXPECT_EQ(leadscrew_motion_adapt(motion.get(), 2, nullptr), LEADSCREW_REJECTED);
  EXPECT_EQ(leadscrew_motion_adapt(motion.get(), 0.2, nullptr), LEADSCREW_OK);
  double before = 0, behind = 0;
  for (const leadscrew_word& word : words_of(motion.get())) {
    if (std::abs(word.position[0] - 25) < 0.1) before = word.feed;
    if (std::abs(word.position[0] - 75) < 0.1) behind = word.feed;
  }
  EXPECT_NEAR(before, 50, 1e-5);
  EXPECT_NEAR(behind, 10, 1e-5);
}

TEST(Capi, WaitsForMovesAndGoesOn) {
  const Motion motion = moves();
  EXPECT_EQ(words_of(motion.get()).size(), 0U);
  EXPECT_EQ(leadscrew_motion_progress(motion.get()), LEADSCREW_WANTS_MOVES);
  const leadscrew_move there = line(10, 0, 0, 50), back = line(0, 0, 0, inf);
  leadscrew_motion_push(motion.get(), &there, nullptr);
  leadscrew_motion_end_for_now(motion.get());
  const auto first = words_of(motion.get());
  EXPECT_EQ(leadscrew_motion_progress(motion.get()), LEADSCREW_WANTS_MOVES);
  ASSERT_FALSE(first.empty());
  EXPECT_NEAR(first.back().position[0], 10, 0.01);  // the word at the end itself belongs to what follows
  leadscrew_motion_push(motion.get(), &back, nullptr);
  leadscrew_motion_finish(motion.get());
  const auto second = words_of(motion.get());
  ASSERT_FALSE(second.empty());
  EXPECT_EQ(second.front().tick, first.back().tick + 1);
  EXPECT_EQ(second.back().position[0], 0);
  EXPECT_EQ(second.back().state, 0);
}

/// Largest third difference of X, mm/s³, over words of 1 ms.
double greatest_jerk(const std::vector<leadscrew_word>& words) {
  double greatest = 0;
  for (std::size_t i = 3; i < words.size(); ++i) {
    const double difference =
        words[i].position[0] - 3 * words[i - 1].position[0] + 3 * words[i - 2].position[0] - words[i - 3].position[0];
    greatest = std::max(greatest, std::abs(difference) * 1e9);
  }
  return greatest;
}

TEST(Capi, HoldsAndGoesOnWithinLimits) {
  const Motion motion = moves();
  const leadscrew_move far = line(300, 0, 0, 50);
  leadscrew_motion_push(motion.get(), &far, nullptr);
  leadscrew_motion_finish(motion.get());
  std::vector<leadscrew_word> words(1000);
  std::size_t count = 0;
  ASSERT_EQ(leadscrew_motion_next(motion.get(), words.data(), sizeof words[0], 1000, &count, nullptr), LEADSCREW_OK);
  ASSERT_EQ(count, 1000U);
  ASSERT_EQ(leadscrew_motion_override(motion.get(), 0, nullptr), LEADSCREW_OK);
  auto more = words_of(motion.get());
  EXPECT_EQ(leadscrew_motion_progress(motion.get()), LEADSCREW_HELD);
  words.insert(words.end(), more.begin(), more.end());
  EXPECT_LT(words.size(), 1400U);
  EXPECT_LT(words.back().position[0], 75);
  ASSERT_EQ(leadscrew_motion_override(motion.get(), 2, nullptr), LEADSCREW_OK);
  more = words_of(motion.get());
  words.insert(words.end(), more.begin(), more.end());
  EXPECT_EQ(leadscrew_motion_progress(motion.get()), LEADSCREW_ENDED);
  EXPECT_EQ(words.back().position[0], 300);
  EXPECT_LE(greatest_jerk(words), 1.001 * machine::mill3().limits(base::Axis::X).jerk);
}

TEST(Capi, AbortsAtRestAndStartsAnew) {
  for (const bool held : {false, true}) {
    const Motion motion = moves();
    const leadscrew_move far = line(300, 0, 0, 50), late = line(300, 10, 0, 50);
    leadscrew_motion_push(motion.get(), &far, nullptr);
    std::vector<leadscrew_word> words(1000);
    std::size_t count = 0;
    leadscrew_motion_end_for_now(motion.get());
    leadscrew_motion_next(motion.get(), words.data(), sizeof words[0], 1000, &count, nullptr);
    const double nowhere[LEADSCREW_AXES] = {1, 2, 3};
    EXPECT_EQ(leadscrew_motion_reset(motion.get(), nowhere, nullptr), LEADSCREW_REJECTED);
    if (held) leadscrew_motion_override(motion.get(), 0, nullptr);
    ASSERT_EQ(leadscrew_motion_abort(motion.get()), LEADSCREW_OK);
    EXPECT_EQ(leadscrew_motion_push(motion.get(), &late, nullptr), LEADSCREW_REJECTED);
    const auto more = words_of(motion.get());
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(leadscrew_motion_progress(motion.get()), LEADSCREW_ENDED);
    EXPECT_EQ(words.back().state, 0);
    EXPECT_LT(words.back().position[0], 75);
    EXPECT_LE(greatest_jerk(words), 1.001 * machine::mill3().limits(base::Axis::X).jerk);
    ASSERT_EQ(leadscrew_motion_reset(motion.get(), words.back().position, nullptr), LEADSCREW_OK);
    ASSERT_EQ(leadscrew_motion_push(motion.get(), &late, nullptr), LEADSCREW_OK);
    leadscrew_motion_finish(motion.get());
    const auto last = words_of(motion.get());
    EXPECT_EQ(last.front().position[0], words.back().position[0]);
    EXPECT_EQ(last.back().position[1], 10);
  }
}

TEST(Capi, EndsProbingMovesWhereTheHostsProbeTouches) {
  leadscrew_options options = no_options();
  options.has_probe = 1;
  for (const bool measured : {false, true}) {
    const Motion motion = program("G21 F600\nG1 X1\nG38.2 Z-20\nG38.4 Z0\nG0 X[0-#5063]\nM2\n", options);
    EXPECT_EQ(leadscrew_motion_probe_found(motion.get(), nullptr, nullptr), LEADSCREW_REJECTED);
    leadscrew_word word{};
    double lost = 0, contact = 0;
    bool touching = false;
    for (std::size_t count = 1; count == 1;) {
      ASSERT_EQ(leadscrew_motion_next(motion.get(), &word, sizeof word, 1, &count, nullptr), LEADSCREW_OK);
      const int looks_for = leadscrew_motion_probing(motion.get());
      touching = word.position[2] <= -5;
      if (looks_for == LEADSCREW_CONTACT && touching && contact == 0) {
        contact = word.position[2];
        ASSERT_EQ(leadscrew_motion_probe_found(motion.get(), nullptr, nullptr), LEADSCREW_OK);
      }
      if (looks_for == LEADSCREW_LOSS && !touching && lost == 0) {
        lost = measured ? -5 : word.position[2];
        const double place[LEADSCREW_AXES] = {1, 0, -5};
        ASSERT_EQ(leadscrew_motion_probe_found(motion.get(), measured ? place : nullptr, nullptr), LEADSCREW_OK);
      }
    }
    EXPECT_NEAR(contact, -5, 0.02);
    EXPECT_DOUBLE_EQ(word.position[0], -lost);
    EXPECT_EQ(leadscrew_motion_progress(motion.get()), LEADSCREW_ENDED);
  }
  EXPECT_EQ(leadscrew_motion_probing(nullptr), LEADSCREW_NO_PROBING);
}

}  // namespace test_motion
