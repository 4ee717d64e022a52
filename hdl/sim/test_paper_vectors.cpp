#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <leadscrew/pulse/linear.hpp>
#include <random>

#include "arc_bench.hpp"

// The interpolators of rtl/paper in a second simulator, iverilog, on vectors that pulse/ makes; script/hardware-mutants breaks
// them and runs the same.

namespace leadscrew::hardware {
namespace test_paper_vectors {

using pulse::Arc;
using pulse::Direction;
using pulse::Point;

/// Runs a bench of sim/iverilog on rows of that name; what it says.
std::string said_by_iverilog(const std::string& bench, const std::string& options, const std::string& modules,
                             const std::string& name) {
  const std::string hdl = LEADSCREW_SOURCE_DIR "/hdl/";
  std::string sources = hdl + "sim/iverilog/" + bench + ".sv";
  std::istringstream each(modules);
  for (std::string module; each >> module;) sources += " " + hdl + "rtl/paper/" + module + ".sv";
  const std::string compiled = name + ".vvp";
  if (std::system(
          ("iverilog -g2012 -I " + hdl + "sim/iverilog -o " + compiled + " -s " + bench + " " + options + " " + sources)
              .c_str()) != 0)
    return "not compiled";
  const std::string told = name + ".said";
  if (std::system(("vvp " + compiled + " +rows=" + name + ".rows > " + told).c_str()) != 0) return "not run";
  std::ifstream file(told);
  std::string line;
  std::getline(file, line);
  return line;
}

// ---------------------------------------------------------------------------------------------------------------------

class ArcRows {
 public:
  explicit ArcRows(const std::string& name) : rows_(name + ".rows") {}

  template <typename Reference>
  void follow(const Arc& arc, std::int64_t most_clocks = 1'000'000) {
    Reference reference(arc);
    row(false, &arc, {}, true, false, reference.at());
    while (!reference.done() && most_clocks-- > 0) {
      const pulse::Pulse<2> step = reference.step();
      row(false, nullptr, step, true, false, reference.at());
    }
    if (!reference.done()) return;  // another one comes
    for (int k = 0; k < 2; ++k) row(false, nullptr, {}, false, false, arc.end);
  }
  void refuse(const Arc& arc) {
    row(false, &arc, {}, false, true, {});
    row(false, nullptr, {}, false, true, {});
  }
  void reset() { row(true, nullptr, {}, false, false, {}); }

 private:
  void row(bool rst, const Arc* starts, pulse::Pulse<2> step, bool busy, bool err, Point at) {
    const Arc arc = starts != nullptr ? *starts : Arc{{7, -3}, {-2, 9}, Direction::clockwise};  // not to be seen
    rows_ << rst << ' ' << (starts != nullptr) << ' ' << !arc.is_counterclockwise() << ' ' << arc.start.x << ' '
          << arc.start.y << ' ' << arc.end.x << ' ' << arc.end.y << ' ' << int{step.step[0]} << ' ' << int{step.step[1]}
          << ' ' << busy << ' ' << err << ' ' << at.x << ' ' << at.y << '\n';
  }
  std::ofstream rows_;
};

template <typename Reference>
void write_arcs(const std::string& name) {
  ArcRows rows(name);
  rows.reset();
  std::mt19937 random(1980);
  const auto drawn = [&] { return Point{static_cast<int>(random() % 64) - 32, static_cast<int>(random() % 64) - 32}; };
  const auto square = [](Point at) { return at.x * at.x + at.y * at.y; };
  int followed = 0;
  for (int draw = 0; draw < 200'000 && followed < 400; ++draw) {
    Arc arc{drawn(), drawn(), random() % 2 == 0 ? Direction::clockwise : Direction::counterclockwise};
    if (draw % 7 == 0) arc.end = arc.start;
    if (draw % 5 == 0)  // beside the start: just ahead, or all round
      arc.end = {arc.start.x + static_cast<int>(random() % 3) - 1, arc.start.y + static_cast<int>(random() % 3) - 1};
    if (draw % 3 == 0 && square(arc.start) < 200) arc.end = {-arc.start.y, arc.start.x};
    if (is_accepted(arc, 6)) {
      ++followed;
      const bool is_broken_off = random() % 16 == 0;
      rows.follow<Reference>(arc, is_broken_off ? static_cast<std::int64_t>(random() % 20) : 1'000'000);
      if (is_broken_off && random() % 2 == 0) rows.reset();
    } else if (draw % 16 == 0) {
      rows.refuse(arc);
    }
  }
  for (const Point start : {Point{29, 0}, Point{0, 29}, Point{-29, 0}, Point{0, -29}})
    for (const Direction way : {Direction::clockwise, Direction::counterclockwise})
      rows.follow<Reference>({start, start, way});
  rows.refuse({{30, 0}, {0, 30}, Direction::clockwise});
  rows.refuse({{0, 0}, {5, 0}, Direction::clockwise});
  rows.refuse({{5, 0}, {0, 0}, Direction::clockwise});
}

constexpr const char* arcs = " arc_search arc_entry arc_quadrant";

TEST(PaperVectors, OfPointComparisonAreTheSameByIverilog) {
  write_arcs<PointComparisonReference>("by_point_comparison");
  EXPECT_EQ(said_by_iverilog("arc_vectors", "-DCORE=by_point_comparison", std::string("by_point_comparison") + arcs,
                             "by_point_comparison")
                .substr(0, 6),
            "passed");
}
TEST(PaperVectors, OfLeastErrorAreTheSameByIverilog) {
  write_arcs<LeastErrorReference>("minimum_error");
  EXPECT_EQ(
      said_by_iverilog("arc_vectors", "-DCORE=minimum_error", std::string("minimum_error") + arcs, "minimum_error")
          .substr(0, 6),
      "passed");
}
TEST(PaperVectors, OfImprovedLeastErrorAreTheSameByIverilog) {
  write_arcs<ImprovedLeastErrorReference>("improved_minimum_error");
  EXPECT_EQ(said_by_iverilog("arc_vectors", "-DCORE=improved_minimum_error",
                             std::string("improved_minimum_error") + arcs, "improved_minimum_error")
                .substr(0, 6),
            "passed");
}
TEST(PaperVectors, OfTheDdaAreTheSameByIverilog) {
  write_arcs<DdaReference>("dda");
  EXPECT_EQ(said_by_iverilog("arc_vectors", "-DCORE=dda", "dda arc_entry arc_quadrant", "dda").substr(0, 6), "passed");
}

// ---------------------------------------------------------------------------------------------------------------------

constexpr std::int32_t q = 300, q0 = 10;

/// What a motion of koren_hw.sv gives, clock by clock; `Motion` is of pulse/ and steps at each overflow of the feed DDA.
template <typename Motion, typename Place>
void write_motion(std::ostream& rows, const std::string& load, std::int64_t f, Motion motion, const Place& place) {
  const auto row = [&](const std::string& begin, pulse::Pulse<2> step, bool busy) {
    const Point at = place(motion);
    rows << begin << ' ' << (step.step[0] != 0) << ' ' << (step.step[1] != 0) << ' ' << busy << ' ' << at.x << ' '
         << at.y << '\n';
  };
  row("0 1 " + load, {}, true);
  pulse::FeedDda feed(q0, f);
  const std::string quiet = "0 0 1 1 3 5 7 2 2";  // what is not loaded is not seen
  while (!motion.done()) {
    const pulse::Pulse<2> step = feed.step() ? motion.step() : pulse::Pulse<2>{};
    row(quiet, step, true);
  }
  row(quiet, {}, false);
}

void write_koren(const std::string& name) {
  std::ofstream rows(name + ".rows");
  rows << "1 0 0 0 0 0 0 0 0 0 0 0 0 0\n";
  for (const Point delta : {Point{200, 1}, Point{123, 67}, Point{1, 300}, Point{77, 0}, Point{250, 250}}) {
    for (const std::int64_t f : {7, 10, 3}) {
      std::ostringstream load;
      load << "0 0 " << f << ' ' << delta.x << ' ' << delta.y << ' ' << delta.x << ' ' << delta.y;
      write_motion(rows, load.str(), f, pulse::LinearDda<2>({delta.x, delta.y}, q, pulse::Preload::none),
                   [&](const auto&) { return delta; });
    }
  }
  for (const std::int64_t radius : {1, 7, 100, 299}) {
    for (const bool grows_1 : {false, true}) {
      const Point start = grows_1 ? Point{0, radius} : Point{radius, 0}, end{start.y, start.x};
      std::ostringstream load;
      load << "1 " << grows_1 << " 10 " << start.x << ' ' << start.y << ' ' << radius << ' ' << radius;
      const Arc arc{start, end, grows_1 ? Direction::clockwise : Direction::counterclockwise};
      write_motion(
          rows, load.str(), 10,
          pulse::CircularDda(arc, {.order = pulse::Order::parallel, .preload = pulse::Preload::none, .capacity = q}),
          [](const pulse::CircularDda& dda) { return dda.at(); });
    }
  }
}

TEST(PaperVectors, OfKorenAreTheSameByIverilog) {
  write_koren("koren_hw");
  EXPECT_EQ(said_by_iverilog("koren_vectors", "", "koren_hw digital_integrator", "koren_hw").substr(0, 6), "passed");
}

void write_lecture(const std::string& name) {
  std::ofstream rows(name + ".rows");
  rows << "1 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n";
  std::mt19937 random(1980);
  int u = 0, v = 0;
  for (int round = 0; round < 60; ++round) {
    const int s = 1 + static_cast<int>(random() % 31), dx = static_cast<int>(random() % 128);
    const int dy = 1 + static_cast<int>(random() % 127), down = static_cast<int>(random() % 4);
    // Every third motion ends by its counters, before its way is made.
    std::int64_t left_x = round % 3 == 1 ? dx / (2 + round % 2) : dx,
                 left_y = round % 3 == 1 ? dy / (3 - round % 2) : dy;
    const std::int64_t pulses_x = left_x, pulses_y = left_y;
    pulse::FeedDda feed(1 << 5, s);
    pulse::Integrator x_axis{1 << 7, 0}, y_axis{1 << 7, 0};
    for (int clock = 0; clock < (round % 3 == 2 ? 300 : 3'000); ++clock) {
      const bool loads = clock == 0;
      const int encoders = static_cast<int>(random() % 16);
      const bool is_command = !loads && left_x + left_y > 0 && feed.step();
      const bool x_overflows = is_command && x_axis.add(dx), y_overflows = is_command && y_axis.add(dy);
      const bool x = x_overflows && left_x > 0, y = y_overflows && left_y > 0;
      left_x -= x;
      left_y -= y;
      const auto counted = [&](int bits) { return (bits & 1) != 0 ? ((bits & 2) != 0 ? -1 : 1) : 0; };
      u = std::clamp(u + (x ? ((down & 1) != 0 ? -1 : 1) : 0) - counted(encoders), -64, 63);
      v = std::clamp(v + (y ? ((down & 2) != 0 ? -1 : 1) : 0) - counted(encoders >> 2), -64, 63);
      rows << "0 " << loads << ' ' << s << ' ' << dx << ' ' << dy << ' ' << pulses_x << ' ' << pulses_y << ' '
           << (loads ? down : 0) << ' ' << encoders << ' ' << x << ' ' << y << ' ' << left_x << ' ' << left_y << ' '
           << u << ' ' << v << '\n';
    }
  }
  rows << "1 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n";
}

TEST(PaperVectors, OfTheLectureAreTheSameByIverilog) {
  write_lecture("lecture_dda");
  EXPECT_EQ(said_by_iverilog("lecture_vectors", "", "lecture_dda up_down_counter digital_integrator", "lecture_dda")
                .substr(0, 6),
            "passed");
}

}  // namespace test_paper_vectors
}  // namespace leadscrew::hardware
