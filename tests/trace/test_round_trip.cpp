#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <leadscrew/trace/trace_reader.hpp>
#include <leadscrew/trace/word_writer.hpp>

#include "byte_sinks.hpp"

namespace leadscrew::trace {
namespace test_round_trip {

using namespace testing_support;

base::AxisSet axes_from(std::uint16_t bits) {
  base::AxisSet axes;
  for (const base::Axis axis : base::all_axes) {
    if ((bits >> base::index(axis)) & 1) axes.insert(axis);
  }
  if (axes.empty()) axes.insert(base::Axis::X);
  return axes;
}

std::vector<base::Word> any_words(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto finite = [&] {
    while (true) {
      const double value = std::bit_cast<double>(random());
      if (std::isfinite(value)) return value;
    }
  };
  std::vector<base::Word> words(count);
  for (std::size_t i = 0; i < count; ++i) {
    words[i].tick = base::Tick{static_cast<std::int64_t>(i)};
    words[i].line = base::Line{static_cast<std::int64_t>(random() >> 12)};
    words[i].feed = finite();
    words[i].path_length = finite();
    for (double& q : words[i].position) q = random() % 4 == 0 ? std::round(finite()) : finite();
  }
  return words;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

void expect_same(const std::vector<base::Word>& words, TraceReader& reader, base::AxisSet axes, base::Period period) {
  RC_ASSERT(reader.axes() == axes);
  for (const base::Word& word : words) {
    const auto row = reader.next();
    RC_ASSERT(row && *row);
    RC_ASSERT(same_bits((*row)->t, base::seconds(word.tick, period)));
    RC_ASSERT((*row)->line == base::number(word.line));
    for (const base::Axis axis : base::all_axes) {
      const std::size_t i = base::index(axis);
      RC_ASSERT(same_bits((*row)->position[i], axes.contains(axis) ? word.position[i] : 0.0));
    }
  }
  const auto end = reader.next();
  RC_ASSERT(end && !*end);
}

/// The file of such an ending.
std::string written(std::string_view ending, const std::vector<base::Word>& words, base::AxisSet axes,
                    base::Period period) {
  std::string bytes;
  WordWriter writer(ending, into(bytes), axes, period);
  for (const base::Word& word : words) RC_ASSERT(writer.write(word).has_value());
  RC_ASSERT(writer.finish().has_value());
  RC_ASSERT(writer.header().has_value() == has_header_last(ending));
  if (const auto header = writer.header()) bytes.replace(0, header->size(), *header);
  return bytes;
}

RC_GTEST_PROP(RoundTrip, EveryFormatGivesEveryBitBack,
              (std::uint64_t seed, std::uint16_t axis_bits, std::uint8_t piece)) {
  const base::AxisSet axes = axes_from(axis_bits);
  const base::Period period{10'000 + static_cast<std::int64_t>(seed % 1'000'000)};
  const auto words = any_words(seed % 200, seed);
  for (const std::string_view ending : endings()) {
    auto reader = TraceReader::open(from(written(ending, words, axes, period), piece + 1u), "trace", axes);
    RC_ASSERT(reader.has_value());
    expect_same(words, *reader, axes, period);
  }
}

TEST(RoundTrip, SurvivesManyBlocksOfTheSink) {
  const auto words = random_train(20000, 3);
  const base::AxisSet axes = machine::mill3().axis_set();
  for (const std::string_view ending : endings()) {
    auto reader = TraceReader::open(from(written(ending, words, axes, millisecond)), "trace", axes);
    ASSERT_TRUE(reader);
    std::size_t count = 0;
    while (true) {
      const auto row = reader->next();
      ASSERT_TRUE(row);
      if (!*row) break;
      ASSERT_TRUE(same_bits((*row)->position[1], words[count++].position[1]));
    }
    EXPECT_EQ(count, words.size()) << ending;
  }
}

TEST(WordWriter, TakesTheFormatOfTheEndingAndElseTheFirst) {
  const auto words = random_train(3, 1);
  const base::AxisSet axes = machine::mill3().axis_set();
  const std::string csv = written(".csv", words, axes, millisecond);
  EXPECT_EQ(csv.substr(0, 20), "t,line,s,feed,X,Y,Z\n");
  EXPECT_EQ(written(".npy", words, axes, millisecond).substr(1, 5), "NUMPY");
  EXPECT_EQ(written("", words, axes, millisecond), csv);
}

TEST(CsvWriter, WritesTheContractsColumns) {
  std::string text;
  CsvWriter writer(into(text), machine::mill3().axis_set(), millisecond);
  base::Word word;
  word.tick = base::Tick{2};
  word.line = base::Line{7};
  word.path_length = 1.5;
  word.feed = 0.1;
  word.position = {1, -2, 0.25};
  ASSERT_TRUE(writer.write(word));
  ASSERT_TRUE(writer.finish());
  EXPECT_EQ(text, "t,line,s,feed,X,Y,Z\n0.002,7,1.5,0.10000000000000001,1,-2,0.25\n");
}

TEST(NpyWriter, HeaderIsThatOfTheFormat) {
  std::string bytes;
  NpyWriter writer(into(bytes), machine::mill3().axis_set(), millisecond);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(writer.write({}));
  ASSERT_TRUE(writer.finish());
  std::string expected("\x93NUMPY\x01\x00\x76\x00", 10);
  expected += "{'descr': '<f8', 'fortran_order': False, 'shape': (3, 7), }";
  expected += std::string(127 - expected.size(), ' ') + "\n";
  EXPECT_EQ(writer.header(), expected);
  EXPECT_EQ(writer.header().size() % 64, 0u);
  EXPECT_EQ(bytes.size(), 128u + 3 * 7 * 8);
}

TEST(NpyWriter, NumpyReadsIt) {
  const auto file = std::filesystem::temp_directory_path() / "leadscrew_test_trace.npy";
  auto words = random_train(1000, 5);
  std::ofstream(file, std::ios::binary) << written(".npy", words, machine::mill3().axis_set(), millisecond);
  char script[400];
  std::snprintf(
      script, sizeof script,
      "/usr/bin/python3 -c \"import numpy; a = numpy.load('%s'); assert a.shape == (1000, 7); assert a[999, 4] == "
      "float.fromhex('%a'); assert a[999, 0] == 0.999\"",
      file.c_str(), words[999].position[0]);
  EXPECT_EQ(std::system(script), 0);
  std::filesystem::remove(file);
}

/// Behind those of the words and of the slides, and not in the way of who reads the words again.
TEST(WordWriter, HasAColumnOfPower) {
  const base::AxisSet axes = machine::mill3().axis_set();
  const auto words = random_train(20, 3);
  for (const std::string_view ending : endings()) {
    std::string bytes;
    WordWriter writer(ending, into(bytes), axes, millisecond, {.power = true});
    for (const base::Word& word : words) ASSERT_TRUE(writer.write(word, {.power = 7.5}));
    ASSERT_TRUE(writer.finish());
    if (const auto header = writer.header()) bytes.replace(0, header->size(), *header);
    auto reader = TraceReader::open(from(bytes, 1000), "trace", axes);
    ASSERT_TRUE(reader) << reader.error().message;
    for (const base::Word& word : words) {
      const auto row = reader->next();
      ASSERT_TRUE(row && *row) << ending;
      EXPECT_EQ((*row)->position[1], word.position[1]);
    }
    const auto end = reader->next();
    EXPECT_TRUE(end && !*end);
  }
  std::string text;
  CsvWriter writer(into(text), axes, millisecond, {.actual = true, .power = true});
  ASSERT_TRUE(writer.write({}, {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {-1, -2, -3}, 0.5}));
  ASSERT_TRUE(writer.finish());
  EXPECT_EQ(text,
            "t,line,s,feed,X,Y,Z,actual_X,actual_Y,actual_Z,velocity_X,velocity_Y,velocity_Z,control_X,control_Y,"
            "control_Z,current_X,current_Y,current_Z,power\n0,0,0,0,0,0,0,1,2,3,4,5,6,7,8,9,-1,-2,-3,0.5\n");
}

TEST(WordWriter, PassesOnWhatTheSinkSays) {
  const auto words = random_train(5000, 1);
  for (const std::string_view ending : endings()) {
    for (const std::size_t room : {0, 100, 70000, 200000}) {
      WordWriter writer(ending, failing_after(room), machine::mill3().axis_set(), millisecond);
      for (const base::Word& word : words) (void)writer.write(word);
      const auto finished = writer.finish();
      ASSERT_FALSE(finished) << ending << " in " << room;
      EXPECT_EQ(finished.error().code, "disk-full");
      EXPECT_FALSE(writer.write(words[0]));
      EXPECT_FALSE(writer.finish());
    }
  }
}

}  // namespace test_round_trip
}  // namespace leadscrew::trace
