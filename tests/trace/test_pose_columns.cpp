#include <gtest/gtest.h>

#include <cstdlib>
#include <leadscrew/trace/named_columns.hpp>
#include <leadscrew/trace/trace_reader.hpp>
#include <leadscrew/trace/word_writer.hpp>

#include "byte_sinks.hpp"

// A trace of a machine with kinematics has the tool's pose behind all else, and is read as any other.

namespace leadscrew::trace {
namespace test_pose_columns {

using namespace testing_support;

base::AxisSet trunnion_axes() {
  base::AxisSet axes;
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z, base::Axis::A, base::Axis::C})
    axes.insert(axis);
  return axes;
}

std::string one_row(std::string_view ending) {
  std::string bytes;
  WordWriter writer(ending,
                    [&](std::span<const char> part) -> base::Result<void> {
                      bytes.append(part.data(), part.size());
                      return {};
                    },
                    trunnion_axes(), base::Period{1'000'000}, {.pose = true});
  base::Word word;
  word.position = {1, 2, 3, 4, 0, 6};
  BesideWord beside;
  beside.pose = {10, 20, 30, 0.5, 0.25, 0.125};
  EXPECT_TRUE(writer.write(word, beside));
  EXPECT_TRUE(writer.finish());
  return bytes;
}

TEST(PoseColumns, StandBehindTheAxes) {
  EXPECT_EQ(one_row(".csv"), "t,line,s,feed,X,Y,Z,A,C,tx,ty,tz,i,j,k\n0,0,0,0,1,2,3,4,6,10,20,30,0.5,0.25,0.125\n");
  const std::string array = one_row(".npy");
  EXPECT_EQ((array.size() - 128) % (15 * sizeof(double)), 0U);
  EXPECT_GE(array.size(), 128 + 15 * sizeof(double));
}

/// Whatever stands behind the words is not in the way of who reads them.
TEST(PoseColumns, AndAllOthersAreReadOverInBothFormats) {
  for (const std::string_view ending : {".csv", ".npy"}) {
    for (int kinds = 0; kinds < 8; ++kinds) {
      const MoreColumns columns{(kinds & 1) != 0, (kinds & 2) != 0, (kinds & 4) != 0};
      std::string bytes;
      WordWriter writer(ending, into(bytes), trunnion_axes(), base::Period{1'000'000}, columns);
      base::Word word;
      word.position = {1, 2, 3, 4, 0, 6};
      ASSERT_TRUE(writer.write(word, BesideWord{}));
      ASSERT_TRUE(writer.finish());
      if (const auto header = writer.header()) bytes.replace(0, header->size(), *header);
      auto reader = TraceReader::open(from(bytes, 1000), "trace", trunnion_axes());
      ASSERT_TRUE(reader) << ending << kinds << ": " << reader.error().message;
      const auto row = reader->next();
      ASSERT_TRUE(row && *row) << ending << kinds;
      EXPECT_EQ((*row)->position, word.position) << ending << kinds;
    }
  }
}

TEST(PoseColumns, AreNamedWithTheirUnits) {
  const auto named = named_columns(trunnion_axes(), {.pose = true});
  ASSERT_EQ(named.size(), 15U);
  EXPECT_EQ(named[9].name, "tx");
  EXPECT_EQ(named[9].unit, "mm");
  EXPECT_EQ(named[14].name, "k");
  EXPECT_EQ(named[14].unit, "");
  EXPECT_EQ(named_columns(trunnion_axes(), {}).size(), 9U);
}

}  // namespace test_pose_columns
}  // namespace leadscrew::trace
