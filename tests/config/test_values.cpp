// Values of machine files: numbers are exact or refused, and what is wrong with a value is said where it stands.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <leadscrew/config/machine_keys.hpp>
#include <set>

#include "files.hpp"

namespace leadscrew::config::testing {
namespace test_values {

using Texts = std::vector<std::string>;

TEST(Integers, AreExactOrRefused) {
  const auto largest = read_machine(replaced(one_axis, "[-500, 500]", "[-9007199254740992, 9007199254740992]"), "m");
  ASSERT_TRUE(largest);
  EXPECT_EQ(largest->limits(base::Axis::X).travel_max, 9007199254740992.0);
  EXPECT_EQ(largest->limits(base::Axis::X).travel_min, -9007199254740992.0);
  EXPECT_EQ(problems_of(replaced(one_axis, "[-500, 500]", "[-500, 9223372036854775807]")), Texts{"2:13 machine-type"});
  EXPECT_EQ(problems_of(replaced(one_axis, "[-500, 500]", "[-9223372036854775807, 5]")), Texts{"2:13 machine-type"});
  EXPECT_EQ(problems_of(replaced(one_axis, "= 200\n", "= 9007199254740993\n")), Texts{"3:21 machine-type"});
  EXPECT_EQ(problems_of("period_us = 9007199254740993\n" + one_axis), Texts{"1:13 machine-type"});
  EXPECT_EQ(problems_of(one_axis + "pitch_errors_mm = [[0, 0], [9007199254740993, 0]]\n"), Texts{"7:28 machine-type"});
}

TEST(Integers, ThatAreRefusedAreNamed) {
  const auto read = read_machine(replaced(one_axis, "[-500, 500]", "[-500, 9223372036854775807]"), "m");
  ASSERT_FALSE(read);
  EXPECT_NE(read.error()[0].message.find("9223372036854775807"), std::string::npos) << read.error()[0].message;
  EXPECT_NE(read.error()[0].hint.find("decimal point"), std::string::npos) << read.error()[0].hint;
}

/// What machine::validate() can object to has a key, and so a place.
TEST(Subjects, OfEveryValueOfAnAxisHaveAKey) {
  std::set<std::string_view> fields;
  for (const Key& key : axis_keys) fields.insert(key.field);
  for (const Key& key : drive_keys) fields.insert(key.field);
  EXPECT_EQ(fields.size(), axis_keys.size() + drive_keys.size());
  for (const machine::StepTime& time : machine::all_step_times) EXPECT_TRUE(fields.contains(time.name)) << time.name;
  for (const machine::DriveNumber& number : machine::drive_numbers)
    EXPECT_TRUE(fields.contains(number.name)) << number.name;
}

/// A value that validate() refuses, in place of each key's own, is told at its line.
TEST(Subjects, LeadToTheLineOfTheValue) {
  for (const base::Axis axis : {base::Axis::X, base::Axis::B}) {
    std::string text = "[" + section_of(axis) + "]\n";
    std::size_t line = 1;
    Texts expected;
    const auto add = [&](std::string_view key, const std::string& value) {
      text += std::string(key) + " = " + value + "\n";
      expected.push_back(std::to_string(++line));
    };
    for (const Key& key : axis_keys) {
      const bool is_table =
          key.field == machine::field::pitch_errors || key.field == machine::field::backward_pitch_errors;
      add(text_of(key, axis), is_table ? "[[0, nan]]" : key.field == machine::field::travel ? "[1, 1]" : "-1");
    }
    text += "[" + drive_section_of(axis) + "]\n";
    ++line;
    for (const Key& key : drive_keys) add(text_of(key, axis), "-1");
    Texts found;
    for (const std::string& problem : problems_of(text)) found.push_back(problem.substr(0, problem.find(':')));
    EXPECT_EQ(found, expected) << text;
  }
}

TEST(Subjects, OfProblemsStayWithThem) {
  const auto read = read_machine(one_axis + "pitch_errors_mm = [[0, 0], [0, 0]]\n", "m.toml");
  ASSERT_FALSE(read);
  const base::Subject& subject = read.error()[0].subject;
  EXPECT_EQ(subject.axis, base::Axis::X);
  EXPECT_EQ(subject.field, machine::field::pitch_errors);
  EXPECT_EQ(subject.entry, 1u);
}

TEST(SpindleWaits, UnlessTheFileSaysOtherwise) {
  EXPECT_TRUE(read_machine(one_axis, "m")->spindle_waits);
  EXPECT_TRUE(read_machine("spindle_waits = true\n" + one_axis, "m")->spindle_waits);
  EXPECT_FALSE(read_machine("spindle_waits = false\n" + one_axis, "m")->spindle_waits);
  EXPECT_EQ(problems_of("spindle_waits = 0\n" + one_axis), Texts{"1:17 machine-type"});
}

TEST(Dialect, IsOneOfThoseThatAreRead) {
  EXPECT_EQ(read_machine(one_axis, "m")->dialect, machine::Dialect::leadscrew);
  for (std::size_t i = 0; i < machine::dialect_names.size(); ++i) {
    const std::string text = "dialect = \"" + std::string(machine::dialect_names[i]) + "\"\n" + one_axis;
    ASSERT_TRUE(read_machine(text, "m")) << text;
    EXPECT_EQ(index(read_machine(text, "m")->dialect), i);
  }
  EXPECT_EQ(problems_of("dialect = \"heidenhain\"\n" + one_axis), Texts{"1:11 machine-dialect"});
  EXPECT_EQ(problems_of("dialect = 1\n" + one_axis), Texts{"1:11 machine-dialect"});
}

TEST(Laser, IsReadWithItsDefaults) {
  EXPECT_FALSE(read_machine(one_axis, "m")->laser);
  EXPECT_EQ(read_machine(one_axis + "[laser]\n", "m")->laser, machine::Laser{});
  const auto read = read_machine(one_axis + "[laser]\npower = \"S\"\noutput = 63\nfollow_feed = false\n", "m");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->laser, (machine::Laser{machine::Laser::Power::spindle_speed, 63, false}));
}

TEST(Laser, IsRefusedWhereItIsWrong) {
  EXPECT_EQ(problems_of("laser = 5\n" + one_axis), Texts{"1:9 machine-type"});
  EXPECT_EQ(problems_of(one_axis + "[laser]\npower = \"M62\"\n"), Texts{"8:9 machine-laser"});
  EXPECT_EQ(problems_of(one_axis + "[laser]\npower = 67\n"), Texts{"8:9 machine-laser"});
  EXPECT_EQ(problems_of(one_axis + "[laser]\noutput = 64\n"), Texts{"8:10 machine-laser"});
  EXPECT_EQ(problems_of(one_axis + "[laser]\noutput = -1\n"), Texts{"8:10 machine-laser"});
  EXPECT_EQ(problems_of(one_axis + "[laser]\noutput = 1.0\n"), Texts{"8:10 machine-type"});
  EXPECT_EQ(problems_of(one_axis + "[laser]\nfollow_feed = 1\n"), Texts{"8:15 machine-type"});
  EXPECT_EQ(problems_of(one_axis + "[laser]\nfeed = true\n"), Texts{"8:1 machine-key"});
}

TEST(Probe, HasPlanesOfLinearAxes) {
  EXPECT_FALSE(read_machine(one_axis, "m")->probe);
  EXPECT_EQ(read_machine(one_axis + "[probe]\n", "m")->probe, machine::Probe{});
  const auto read = read_machine(one_axis + "[probe]\nplane_mm = {X = -3.5}\n", "m");
  ASSERT_TRUE(read);
  machine::Probe expected;
  expected.planes[0] = -3.5;
  EXPECT_EQ(read->probe, expected);
}

TEST(Probe, HasBodies) {
  using Kind = machine::ProbeBody::Kind;
  const auto read =
      read_machine(one_axis +
                       "[probe]\nbox_mm = [[0, 1, -20, 60, 40, 0.5]]\nsphere_mm = [[1, 2, 3, 4], [5, 6, 7, 8]]\n"
                       "bore_mm = [[1, 2, 3, 4, 5, 6, 7]]\npocket_mm = []\n",
                   "m");
  ASSERT_TRUE(read);
  machine::Probe expected;
  expected.bodies = {{Kind::box, {0, 1, -20}, {60, 40, 0.5}, 0},
                     {Kind::sphere, {1, 2, 3}, {}, 4},
                     {Kind::sphere, {5, 6, 7}, {}, 8},
                     {Kind::bore, {1, 2, 3}, {4, 5, 6}, 7}};
  EXPECT_EQ(read->probe, expected);
}

TEST(Probe, IsRefusedWhereABodyIsNone) {
  const struct {
    const char* text;
    Texts problems;
  } rows[] = {{"box_mm = 5", {"8:10 machine-type"}},
              {"box_mm = [5]", {"8:11 machine-type"}},
              {"box_mm = [[0, 0, 0, 1, 1]]", {"8:11 machine-type"}},
              {"box_mm = [[0, 0, 0, 1, 1, 1], [0, 0, 0, 1, 0, 1]]", {"8:31 machine-probe"}},
              {"pocket_mm = [[0, 0, 0, 1, 1, -1]]", {"8:14 machine-probe"}},
              {"sphere_mm = [[0, 0, 0, 0]]", {"8:14 machine-probe"}},
              {"sphere_mm = [[0, 0, nan, 1]]", {"8:14 machine-probe"}},
              {"sphere_mm = [[0, 0, 0, \"1\"]]", {"8:14 machine-type"}},
              {"sphere_mm = [[0, 0, 0], [0, 0, 0, -1]]", {"8:14 machine-type", "8:25 machine-probe"}},
              {"cylinder_mm = [[0, 0, 0, 0, 0, 0, 1]]", {"8:16 machine-probe"}},
              {"bore_mm = [[0, 0, 0, 0, 0, 1, inf]]", {"8:12 machine-probe"}}};
  for (const auto& row : rows)
    EXPECT_EQ(problems_of(one_axis + "[probe]\n" + row.text + "\n"), row.problems) << row.text;
}

std::string file_of(const std::string& name, const std::string& text) {
  const std::string path = ::testing::TempDir() + name;
  std::ofstream(path) << text;
  return path;
}

TEST(Probe, TouchesTheSurfacesOfAFile) {
  file_of("probe_face.ngc", "G6.4 D1 P2 Q2 I3 J2\nX0 Y0 Z0\nX5 Z1\nX10 Z0\nX0 Y8\nX5 Z1 R2\nX10 Z0\n");
  const std::string text = one_axis + "[probe]\nsurface = \"probe_face.ngc\"\nsurface_at_mm = [100, 0, -20]\n";
  const auto read = read_machine(text, ::testing::TempDir() + "m.toml");
  ASSERT_TRUE(read) << read.error()[0].message;
  ASSERT_TRUE(read->probe);
  ASSERT_EQ(read->probe->patches.size(), 2u);
  const machine::ProbePatch& second = read->probe->patches[1];
  EXPECT_EQ(second.degree, (std::array<int, 2>{1, 1}));
  EXPECT_EQ(second.net, (std::vector<std::array<double, 4>>{
                            {105, 0, -19, 1}, {110, 0, -20, 1}, {105, 8, -19, 2}, {110, 8, -20, 1}}));
}

TEST(Probe, TellsWhyAFileIsNoSurface) {
  const std::string none = file_of("probe_none.ngc", "G0 X1\nM2\n");
  const std::string wrong = file_of("probe_wrong.ngc", "G6.4 D1 P2 Q2 I2 J2\nX0 Y0 Z0\nX1\nX0 Y1 R-1\nX1 Y1\n");
  const auto problem = [](const std::string& lines) {
    const auto read = read_machine(one_axis + "[probe]\n" + lines + "\n", "m.toml");
    if (read || read.error().size() != 1) return std::string();
    const base::Diagnostic& first = read.error()[0];
    return std::to_string(first.place.line) + ":" + std::to_string(first.place.column) + " " + std::string(first.code) +
           " " + first.message;
  };
  const auto says = [&](const std::string& lines, const std::string& head, const std::string& part) {
    const std::string text = problem(lines);
    EXPECT_TRUE(text.starts_with(head) && text.find(part) != std::string::npos) << text;
  };
  says("surface = \"/nowhere/face.ngc\"", "8:11 machine-probe-surface", "cannot open");
  says("surface = \"" + none + "\"", "8:11 machine-probe-surface", "defines no surface");
  says("surface = \"" + wrong + "\"", "8:11 machine-probe-surface", "line 4: ");
  says("surface = 5", "8:11 machine-type", "not a file");
  says("surface_at_mm = [1, 2]", "8:17 machine-type", "not a place");
}

/// Entries that are no numbers, and numbers that are no body, are answered with the same form.
TEST(Probe, TellsTheFormOfABodyInOneWay) {
  using Kind = machine::ProbeBody::Kind;
  for (const Kind kind : {Kind::box, Kind::pocket, Kind::sphere, Kind::cylinder, Kind::bore}) {
    const std::string key(probe_body_keys[static_cast<std::size_t>(kind)]);
    const std::string none = kind == Kind::sphere                        ? "[0, 0, 0, -1]"
                             : kind == Kind::box || kind == Kind::pocket ? "[0, 0, 0, 1, 1, -1]"
                                                                         : "[0, 0, 0, 0, 0, 0, 1]";
    const auto read = read_machine(one_axis + "[probe]\n" + key + " = [[1], " + none + "]\n", "m");
    ASSERT_FALSE(read) << key;
    ASSERT_EQ(read.error().size(), 2u) << key;
    EXPECT_NE(read.error()[0].code, read.error()[1].code) << key;
    for (const base::Diagnostic& each : read.error())
      EXPECT_NE(each.hint.find(machine::probe_body_form(kind)), std::string::npos) << key << ": " << each.hint;
  }
}

TEST(Probe, IsRefusedWhereItIsWrong) {
  EXPECT_EQ(problems_of("probe = 5\n" + one_axis), Texts{"1:9 machine-type"});
  EXPECT_EQ(problems_of(one_axis + "[probe]\nplane = 5\n"), Texts{"8:1 machine-key"});
  EXPECT_EQ(problems_of(one_axis + "[probe]\nplane_mm = 5\n"), Texts{"8:12 machine-type"});
  EXPECT_EQ(problems_of(one_axis + "[probe]\nplane_mm = {X = \"3\"}\n"), Texts{"8:17 machine-type"});
  EXPECT_EQ(problems_of(one_axis + "[probe]\nplane_mm = {X = nan}\n"), Texts{"8:17 machine-probe"});
  EXPECT_EQ(problems_of(one_axis + "[probe]\nplane_mm = {Z = -3}\n"), Texts{"8:17 machine-probe"});
  EXPECT_EQ(problems_of(one_axis + "[probe]\nplane_mm = {A = 3}\n"), Texts{"8:13 machine-key"});
}

TEST(Spindle, IsAsItsKeysSay) {
  const auto plain = read_machine(one_axis, "m");
  ASSERT_TRUE(plain);
  EXPECT_FALSE(plain->spindle);
  EXPECT_FALSE(plain->threads_follow());
  const auto standard = read_machine(one_axis + "[spindle]\n", "m");
  ASSERT_TRUE(standard);
  EXPECT_EQ(standard->spindle, machine::Spindle{});
  EXPECT_TRUE(standard->threads_follow());
  const auto given = read_machine(
      one_axis + "[spindle]\nacceleration_rpm_s = 800\nnoise = 0.05\nnoise_period_s = 2.5\nseed = 7\n", "m");
  ASSERT_TRUE(given);
  EXPECT_EQ(given->spindle, (machine::Spindle{.acceleration = 800, .wander = 0.05, .wander_period = 2.5, .seed = 7}));
}

TEST(Spindle, IsRefusedWhereItIsWrong) {
  const struct {
    const char* text;
    const char* problem;
  } rows[] = {{"acceleration_rpm_s = 0", "8:22 machine-spindle"},
              {"acceleration_rpm_s = nan", "8:22 machine-spindle"},
              {"acceleration_rpm_s = inf", "8:22 machine-spindle"},
              {"acceleration_rpm_s = \"1\"", "8:22 machine-type"},
              {"noise = -0.01", "8:9 machine-spindle"},
              {"noise = 0.21", "8:9 machine-spindle"},
              {"noise = true", "8:9 machine-type"},
              {"noise_period_s = 0", "8:18 machine-spindle"},
              {"noise_period_s = 1001", "8:18 machine-spindle"},
              {"seed = -1", "8:8 machine-spindle"},
              {"seed = 1.5", "8:8 machine-type"},
              {"speed = 5", "8:1 machine-key"}};
  for (const auto& row : rows)
    EXPECT_EQ(problems_of(one_axis + "[spindle]\n" + row.text + "\n"), Texts{row.problem}) << row.text;
  EXPECT_EQ(problems_of("spindle = 5\n" + one_axis), Texts{"1:11 machine-type"});
}

}  // namespace test_values
}  // namespace leadscrew::config::testing
