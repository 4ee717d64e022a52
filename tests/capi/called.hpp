#pragma once
// What tests of the C interface call again and again, and what is expected of it.

#include <gtest/gtest.h>
#include <leadscrew.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace leadscrew::capi_tests {

inline constexpr double inf = HUGE_VAL;

struct Free {
  void operator()(leadscrew_machine* machine) const { leadscrew_machine_free(machine); }
  void operator()(leadscrew_motion* motion) const { leadscrew_motion_free(motion); }
  void operator()(leadscrew_trajectory* trajectory) const { leadscrew_trajectory_free(trajectory); }
};
using Trajectory = std::unique_ptr<leadscrew_trajectory, Free>;
using Machine = std::unique_ptr<leadscrew_machine, Free>;
using Motion = std::unique_ptr<leadscrew_motion, Free>;

inline Machine mill() {
  leadscrew_machine* machine = nullptr;
  EXPECT_EQ(leadscrew_machine_builtin("mill3", &machine, nullptr), LEADSCREW_OK);
  return Machine(machine);
}

inline leadscrew_options no_options() {
  leadscrew_options options{};
  options.size = sizeof options;
  return options;
}

inline Motion program(const std::string& text, const leadscrew_options& options = no_options()) {
  leadscrew_motion* motion = nullptr;
  leadscrew_error error{};
  error.size = sizeof error;
  EXPECT_EQ(leadscrew_motion_of_program(mill().get(), text.data(), text.size(), &options, &motion, &error),
            LEADSCREW_OK)
      << error.message;
  return Motion(motion);
}

inline Motion moves(const leadscrew_options& options = no_options()) {
  leadscrew_motion* motion = nullptr;
  EXPECT_EQ(leadscrew_motion_of_moves(mill().get(), &options, &motion, nullptr), LEADSCREW_OK);
  return Motion(motion);
}

inline leadscrew_move line(double x, double y, double z, double feed) {
  leadscrew_move move{};
  move.size = sizeof move;
  move.end[0] = x;
  move.end[1] = y;
  move.end[2] = z;
  move.feed = feed;
  return move;
}

inline leadscrew_move arc(double x, double y, double center_x, double center_y, int turns, double feed) {
  leadscrew_move move = line(x, y, 0, feed);
  move.kind = LEADSCREW_ARC;
  move.center[0] = center_x;
  move.center[1] = center_y;
  move.turns = turns;
  return move;
}

/// All there are, in calls of so many.
inline std::vector<leadscrew_word> words_of(leadscrew_motion* motion, std::size_t capacity = 100) {
  std::vector<leadscrew_word> all, some(capacity);
  for (std::size_t count = 1; count > 0;) {
    EXPECT_EQ(leadscrew_motion_next(motion, some.data(), sizeof some[0], capacity, &count, nullptr), LEADSCREW_OK);
    all.insert(all.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return all;
}

inline std::vector<base::Word> pipeline_words(const std::string& text) {
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools;
  pipeline::Program run(gcode::text_source(text), machine, tools, {}, nullptr);
  std::vector<base::Word> words;
  while (run.prepare()) words.push_back(run.cycle());
  return words;
}

inline void expect_same(const std::vector<leadscrew_word>& words, const std::vector<base::Word>& expected,
                        bool lines = true) {
  ASSERT_EQ(words.size(), expected.size());
  for (std::size_t i = 0; i < words.size(); ++i) {
    const leadscrew_word& word = words[i];
    ASSERT_EQ(word.tick, base::count(expected[i].tick));
    ASSERT_EQ(std::memcmp(word.position, expected[i].position.data(), sizeof word.position), 0) << i;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(word.path_length), std::bit_cast<std::uint64_t>(expected[i].path_length));
    ASSERT_EQ(std::bit_cast<std::uint64_t>(word.speed), std::bit_cast<std::uint64_t>(expected[i].speed));
    ASSERT_EQ(std::bit_cast<std::uint64_t>(word.feed), std::bit_cast<std::uint64_t>(expected[i].feed));
    if (lines) {
      ASSERT_EQ(word.line, base::number(expected[i].line));
    }
    ASSERT_EQ(word.state, static_cast<std::uint8_t>(expected[i].state));
  }
}

inline std::string read(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

inline const std::string plate = read(LEADSCREW_SOURCE_DIR "/examples/01-plate.ngc");

inline leadscrew_error sized_error() {
  leadscrew_error error{};
  error.size = sizeof error;
  return error;
}

}  // namespace leadscrew::capi_tests
