#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <leadscrew/gcode/tool_table.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/study/named_curves.hpp>
#include <map>
#include <random_programs.hpp>
#include <regex>
#include <span>
#include <string>
#include <string_view>

// Words of the examples, of the studies' curves and of 200 random programs, of these the first eight seconds, bit for
// bit as recorded in recorded.txt: a line for each program, its name, a hash of its text and machine, the number of its
// words and a hash of these. A change that means to alter motion records anew: script/record-words.

namespace test_words {

using namespace leadscrew;

/// FNV-1a, 64 bit.
class Hash {
 public:
  void add(std::string_view text) {
    for (const char byte : text) value_ = (value_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
  }
  void add(std::uint64_t bits) {
    for (int shift = 0; shift < 64; shift += 8) value_ = (value_ ^ ((bits >> shift) & 0xff)) * 0x100000001b3u;
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

struct Case {
  std::string text;
  machine::Machine machine = machine::mill3();
  machine::ToolTable tools;
  base::AxisVector start{};
  std::uint64_t most_words = ~std::uint64_t{0};
  bool is_overridden = false;  ///< 50 % after 300 words, 150 % after 900, in slices of 20 ms
};

constexpr std::uint64_t most_words_of_random_programs = 4000;  // at 2 ms: slow ones take minutes to plan

/// As a line of recorded.txt has it, behind the name.
std::string fingerprint(const Case& program) {
  Hash source, words;
  source.add(program.text);
  source.add(testing_support::limits_of(program.machine));
  pipeline::Program motion(gcode::text_source(program.text), program.machine, program.tools, {.start = program.start},
                           [](const base::Diagnostic& problem) { EXPECT_EQ(problem.message, ""); });
  if (program.is_overridden) motion.slice(0.02);
  std::uint64_t count = 0;
  std::array<base::Word, 100> place;
  while (count < program.most_words && motion.prepare()) {
    const std::size_t most =
        program.is_overridden ? 1 : std::min<std::size_t>(place.size(), program.most_words - count);
    for (const base::Word& word : motion.cycle(std::span(place).first(most))) {
      if (program.is_overridden && count == 300) motion.override_feed(0.5);
      if (program.is_overridden && count == 900) motion.override_feed(1.5);
      words.add(static_cast<std::uint64_t>(word.tick));
      for (const double position : word.position) words.add(position);
      words.add(word.path_length);
      words.add(word.feed);
      words.add(static_cast<std::uint64_t>(word.line));
      ++count;
    }
  }
  char line[80];
  std::snprintf(line, sizeof line, "%016" PRIx64 " %" PRIu64 " %016" PRIx64, source.value(), count, words.value());
  return line;
}

std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::map<std::string, Case> examples() {
  std::map<std::string, Case> cases;
  const std::filesystem::path folder = LEADSCREW_SOURCE_DIR "/examples";
  const auto tools = gcode::read_tool_table(file_text(folder / "tools.tbl"), "tools.tbl").table;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".ngc") continue;
    Case& program = cases["example/" + entry.path().stem().string()];
    program.text = file_text(entry.path());
    program.tools = tools;
    for (const base::Axis axis : {base::Axis::A, base::Axis::B, base::Axis::C}) {
      program.machine.axes[base::index(axis)] = machine::AxisLimits{-1e5, 1e5, 60, 300, 6000, 0.001};
    }
    // A program that needs kinematics names the machine that has them.
    std::smatch named;
    if (std::regex_search(program.text, named, std::regex("machines/([a-z-]+)\\.toml"))) {
      program.machine.rotary_chain = machine::preset_chain(named[1].str());
    }
  }
  return cases;
}

std::map<std::string, Case> study_curves() {
  std::map<std::string, Case> cases;
  for (const study::NamedCurve& curve : study::named_curves()) {
    for (const double factor : {0.3, 1.0, 4.0}) {
      const study::PartProgram program = curve.program(factor * curve.feed);
      char name[80];
      std::snprintf(name, sizeof name, "curve/%s@%g", std::string(curve.name).c_str(), factor * curve.feed);
      cases[name] = Case{.text = program.text, .start = program.start};
    }
  }
  return cases;
}

/// Of seed `number`, wherever and in whatever order it is drawn.
Case random_case(unsigned number) {
  const auto draw = rc::gen::exec([] {
    Case program;
    program.text = testing_support::RandomProgram::make(10);
    program.machine = testing_support::random_machine();
    return program;
  });
  Case program = draw(rc::Random(1980 + number), rc::kNominalSize).value();
  program.machine.period = base::Period{2'000'000};
  program.most_words = most_words_of_random_programs;
  program.is_overridden = number % 4 == 3;
  return program;
}

std::map<std::string, Case> random_programs(unsigned first, unsigned end) {
  std::map<std::string, Case> cases;
  for (unsigned number = first; number < end; ++number) {
    char name[32];
    std::snprintf(name, sizeof name, "random/%03u", number);
    cases[name] = random_case(number);
  }
  return cases;
}

std::map<std::string, std::string> recorded() {
  std::map<std::string, std::string> lines;
  std::ifstream file(RECORDED_WORDS);
  for (std::string name, rest; file >> name && std::getline(file >> std::ws, rest);) lines[name] = rest;
  return lines;
}

void check(const std::map<std::string, Case>& cases) {
  const bool records = std::getenv("LEADSCREW_RECORD_WORDS") != nullptr;
  auto known = recorded();
  for (const auto& [name, program] : cases) {
    const std::string found = fingerprint(program);
    if (!records) {
      EXPECT_EQ(known[name], found) << name << ": hash of the program, number of words, hash of the words";
    }
    known[name] = found;
  }
  if (!records) return;
  std::ofstream file(RECORDED_WORDS);
  for (const auto& [name, line] : known) file << name << ' ' << line << '\n';
}

TEST(RecordedWords, Examples) {
  check(examples());
}
TEST(RecordedWords, CurvesOfTheStudies) {
  check(study_curves());
}
TEST(RecordedWords, RandomPrograms) {
  check(random_programs(0, 100));
}
TEST(RecordedWords, MoreRandomPrograms) {
  check(random_programs(100, 200));
}

}  // namespace test_words
