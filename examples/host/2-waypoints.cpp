// Through waypoints: with a stop at each, then along one smooth path that passes them within half a millimetre, then along
// a curve that they control.
#include <array>
#include <cstdio>
#include <leadscrew/motion.hpp>

#include "trace_file.hpp"

using namespace leadscrew;

static constexpr std::array<base::AxisVector, 6> points = {
    {{40, 0, 0}, {60, 30, 5}, {40, 60, 10}, {0, 60, 10}, {-20, 30, 5}, {0, 0, 0}}};

/// Of all words to the end.
static double seconds_of(host::Motion& motion, TraceFile* trace = nullptr) {
  motion.finish();
  std::array<base::Word, 256> words;
  while (const std::size_t count = motion.next(words)) {
    for (std::size_t i = 0; i < count && trace != nullptr; ++i) trace->write(words[i]);
  }
  return motion.summary().time_s;
}

static double along_lines(double tolerance, bool stops, TraceFile* trace = nullptr) {
  host::Motion motion(machine::mill3());
  motion.smooth(tolerance);
  for (const base::AxisVector& point : points) {
    motion.push(host::line(point, 150));  // mm/s
    if (stops) motion.end_for_now();
  }
  return seconds_of(motion, trace);
}

static double along_a_curve() {
  host::Motion motion(machine::mill3());
  gcode::NurbsCurve curve;
  curve.degree = 3;
  curve.points.push_back({});  // from where motion stands
  for (const base::AxisVector& point : points) curve.points.push_back({point});
  if (const auto pushed = motion.push(host::curve(curve, 150)); !pushed)
    return std::fprintf(stderr, "%s\n", pushed.error().message.c_str()), -1;
  return seconds_of(motion);
}

int main(int argc, char** argv) {
  TraceFile smooth(argc, argv, "XYZ", machine::mill3().period);
  std::printf("a stop at each       %.3f s\n", along_lines(0, true));
  std::printf("within 0.5 mm        %.3f s\n", along_lines(0.5, false, &smooth));
  std::printf("as control points    %.3f s\n", along_a_curve());
}
