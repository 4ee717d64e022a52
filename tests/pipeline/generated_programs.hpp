#pragma once
// Random programs whose moves the reader makes itself: beside a compensated contour, in canned cycles, on patterns of
// holes, of contours that a lathe roughs, in loops and subprograms, up to what a probe finds, and threads.

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <leadscrew/machine/dialect.hpp>
#include <string>

#include "random_programs.hpp"

namespace leadscrew::testing_support {

class GeneratedProgram {
 public:
  /// What the program is of; each reads without a diagnostic.
  enum class Kind { compensated, cycles, pattern, lathe, flow, probing, threads };

  GeneratedProgram(Kind kind, const machine::Machine& on) : machine(on) {
    add("G21 G90 G94 G17 F%.3f S400 M3\n", 60 * logarithmic(15, 150));
    add(any(0, 2) == 0 ? "G61\n" : "G64 P%.4f\n", between(0.002, 0.1));
    using Make = void (GeneratedProgram::*)();
    constexpr Make make[] = {&GeneratedProgram::compensated, &GeneratedProgram::cycles, &GeneratedProgram::pattern,
                             &GeneratedProgram::lathe,       &GeneratedProgram::flow,   &GeneratedProgram::probing,
                             &GeneratedProgram::threads};
    (this->*make[static_cast<std::size_t>(kind)])();
  }

  std::string text;
  machine::Machine machine;
  machine::Dialect dialect = machine::Dialect::leadscrew;

 private:
  [[gnu::format(printf, 2, 3)]] void add(const char* format, ...) {
    char line[200];
    std::va_list values;
    va_start(values, format);
    std::vsnprintf(line, sizeof line, format, values);
    va_end(values);
    text += line;
  }

  /// Around a plate with corners round and sharp, outside, and now and then across to a level of its own.
  void compensated() {
    const double w = between(8, 25), h = between(8, 25), round = between(0.5, 2.5), slope = between(0, 2);
    const double radius =
        between(0.3, std::min(3.0, 0.8 * (w / 2 - round)));  // the first way is the inside of a corner
    const bool turns_left = any(0, 2) == 0;
    add("G0 X%.4f Y%.4f Z1\nG1 Z-1\n", w / 2, -h / 2 - radius * 3 - 2);
    add("%s D%.4f\nG1 X%.4f Y%.4f\n", turns_left ? "G42.1" : "G41.1", 2 * radius, w / 2, -h / 2);
    const double sign = turns_left ? 1 : -1;
    const auto x = [&](double value) { return w / 2 + sign * value; };
    for (int lap = any(1, 3); lap > 0; --lap) {
      add("G1 X%.4f\n%s X%.4f Y%.4f J%.4f\n", x(w / 2 - round), turns_left ? "G3" : "G2", x(w / 2), -h / 2 + round,
          round);
      if (any(0, 2) == 0) add("G1 Z%.4f\n", between(-2, 0));
      add("G1 Y%.4f\n", h / 2);
      if (any(0, 2) == 0) add("S%d\n", any(100, 900));
      add("G1 X%.4f Y%.4f\n", x(-w / 2 + round), h / 2 + slope);
      add("X%.4f Y%.4f\n", x(-w / 2), h / 2 - round);
      if (any(0, 3) == 0) add("G4 P0.02\n");
      add("G1 Y%.4f\nX%.4f\n", -h / 2, x(0));
    }
    static constexpr const char* behind[] = {"",
                                             "M8\n",
                                             "G42.1 D1\nG40\n",
                                             "G41.1 D0\nM9\nG40\n",
                                             "G18\nG41.1 D1\nG40\n",
                                             "G81 Z-3 R2\nG80\n",
                                             "G42.1 D2\nG1 X50 Y-40\nX60\nG40\n"};
    add("G40\n%sG1 Y%.4f\nM2\n", behind[any(0, 7)], -h / 2 - 2 * radius - 4);
  }

  void cycles() {
    add("G0 Z%.3f\n%s\n", between(3, 8), any(0, 2) == 0 ? "G98" : "G99");
    for (int k = any(1, 3); k > 0; --k) {
      const double r = between(0.5, 2), depth = between(1, 8);
      static constexpr const char* codes[] = {"G81", "G82 P0.05", "G85", "G89 P0.02", "G86 P0.01", "G88 P0"};
      if (any(0, 3) == 0) {
        add("%s Q%.3f", any(0, 2) == 0 ? "G83" : "G73", between(0.7, 4));
      } else {
        add("%s", codes[any(0, 6)]);
      }
      add(" X%.3f Y%.3f Z%.3f R%.3f\n", between(-20, 20), between(-20, 20), -depth, r);
      if (any(0, 2) == 0) add("X%.3f\nY%.3f Z%.3f\n", between(-20, 20), between(-20, 20), -depth / 2);
      if (any(0, 2) == 0) add("G91 X%.3f L%d Z%.3f R%.3f\nG90\n", between(0.5, 4), any(2, 4), -depth, -0.1);
      add("G80\n%s", any(0, 3) == 0 ? "G1 X0 Y0\n" : "");
      add("G0 Z%.3f\n", between(3, 8));
    }
    add("M2\n");
  }

  void pattern() {
    dialect = machine::Dialect::haas;
    add("G0 Z5.\nG0 X%.3f Y%.3f\nG98 G81 Z-%.3f R1. F%.3f L0\n", between(-9, 9), between(-9, 9), between(1, 5),
        60 * between(5, 50));
    switch (any(0, 3)) {
      case 0:
        add("G70 I%.3f J%.3f L%d\n", between(2, 15), between(0, 90), any(2, 7));
        break;
      case 1:
        add("G71 I%.3f J%.3f K%.3f L%d\n", between(2, 15), between(0, 90), between(5, 70), any(2, 6));
        break;
      default:
        add("G72 I%.3f J%.3f L%d\n", between(1, 8), between(0, 90), any(2, 6));
    }
    add("G80\nG1 X0. Y0. F900.\nM30\n");
  }

  /// A shaft: roughed along or across, and finished.
  void lathe() {
    const double x = between(4, 8), z = between(3, 8);
    const bool is_along = any(0, 2) == 0;
    add("G18 G8\nG0 X%.3f Z2\n", x + 7);
    text += "O100 sub\n";
    if (is_along) {
      add("G1 X%.4f Z0\nZ%.4f\nX%.4f Z%.4f\nZ%.4f\nX%.4f\n", x, -z, x + 2, -z - 3, -z - 5, x + 6);
    } else {
      add("G1 X%.4f Z%.4f\nX%.4f\nX%.4f Z%.4f\n", x + 6, -z, x, x - 3, -1.0);
    }
    add("O100 endsub\n%s Q100 D%.3f I%.3f R%.3f\n", is_along ? "G71" : "G72", between(0, 0.3), between(0.8, 2.5),
        between(0.2, 1));
    add("G70 Q100 P%d D%.3f\nM2\n", any(1, 3), between(0, 0.4));
  }

  void flow() {
    const double step = between(0.5, 4);
    add("o400 sub\nG91 G1 Y%.4f\nX%.4f Z0.1\nG90\no400 endsub\n", step, -step);
    add("o100 sub\n#10 = 0\no110 while [#10 LT #1]\nG91 G1 X%.4f Y[#2*%.4f]\no120 if [[#10 MOD 2] EQ 0]\n", step,
        step / 2);
    add("G2 X%.4f I%.4f\no120 else\nG1 Z[#2*0.3]\no120 endif\nG90\n#10 = [#10+1]\no110 endwhile\n", step, step / 2);
    add("%so100 endsub\n", any(0, 2) == 0 ? "o400 call\n" : "");
    add("o200 repeat [%d]\no100 call [%d] [%.3f]\no200 endrepeat\n", any(1, 4), any(1, 6), between(-2, 2));
    add("#<k> = 0\no300 do\n#<k> = [#<k>+1]\nG1 X[%.4f*COS[#<k>*50]] Y[%.4f*SIN[#<k>*50]]\n", 3 * step, 3 * step);
    add("o310 if [#<k> GT 6]\no300 break\no310 endif\no300 while [#<k> LT %d]\n", any(1, 10));
    add("o400 call\nM2\n");
  }

  /// Beside a spindle that turns at S, or one that is followed.
  void threads() {
    if (any(0, 3) > 0) {
      machine.spindle = machine::Spindle{.acceleration = between(1'000, 20'000),
                                         .wander = 0.05,
                                         .wander_period = between(0.5, 5),
                                         .seed = static_cast<std::uint64_t>(any(0, 1'000'000))};
    }
    const double slowest = std::min(machine.axes[0]->velocity, machine.axes[2]->velocity);
    const double lead = between(0.3, 2), turns = std::min(slowest * 0.6 / lead, 40.0) * between(0.3, 1);
    add("G18 S%.2f\nG0 X6 Z2\n", 60 * turns);
    for (int k = any(1, 4); k > 0; --k) {
      switch (any(0, 4)) {
        case 0:
          add("G33 Z%.4f K%.4f\n", -between(3, 15), lead);
          break;
        case 3:
          tap(lead, turns);
          break;
        case 1:
          add("G33 Z-2 K%.4f\nX%.4f Z%.4f K%.4f\n", lead, between(6, 8), -between(3, 15), lead / 2);
          break;
        default:
          add("G76 P%.4f Z%.4f I-1 J0.4 K0.8 R1 Q29.5 E0.8 L%d\n", lead, -between(3, 12), any(0, 4));
      }
      if (any(0, 2) == 0) add("M%d\n", any(3, 5));
      add("G0 X9\nZ2\nX6\n");
    }
    if (any(0, 2) == 0) {
      add("M%d S%.2f\nG95 F%.4f\nG1 X20 Z-5\nG64 P0.05 X24 Z0\n", any(3, 5), 60 * turns, slowest * 0.5 / turns);
      add("S%.2f\nX30 Z-8\nG3 X34 Z-8 I2\nG94 F600\n", 60 * turns * between(0.5, 1.5));
    }
    add("G1 X0 Z0\nM2\n");
  }

  /// Deep enough for the spindle to stand there, in revolutions per s at most.
  void tap(double lead, double turns) {
    if (machine.spindle) {
      const machine::AxisLimits& z = *machine.axes[2];
      const double acceleration = machine::tap_acceleration(*machine.spindle, {z.velocity, z.acceleration, z.jerk},
                                                            lead, machine.tolerance, machine.period);
      turns = std::min(turns, std::sqrt(2 * acceleration * between(1, 8) / lead));
    }
    const double depth = between(11, 16);
    if (any(0, 2) == 0) {
      add("S%.3f\nG33.1 Z%.4f K%.4f\n", 60 * turns, 2 - depth, lead);
    } else {
      add("S%.3f M3\nG17 G84 X6 Z%.4f R2 P0.02 F%.4f\nG80 G18\n", 60 * turns, 2 - depth, 60 * turns * lead);
    }
  }

  /// Around a ball and down to a table, and on from where they are.
  void probing() {
    machine::Probe probe;
    const double radius = between(3, 12), depth = between(15, 30);
    probe.planes[base::index(base::Axis::Z)] = -depth;
    probe.bodies = {{machine::ProbeBody::Kind::sphere, {0, 0, 0}, {}, radius}};
    machine.probe = probe;
    for (int k = any(1, 3); k > 0; --k) {
      const double angle = between(0, 360), height = between(-0.9, 0.9) * radius;
      add("G0 Z%.4f\nG0 X[%.4f*COS[%.4f]] Y[%.4f*SIN[%.4f]]\nG1 Z%.4f\n", radius + 2, radius + 4, angle, radius + 4,
          angle, height);
      add("G38.3 X%.4f Y%.4f\nG38.5 X[2*#5061] Y[2*#5062]\n", between(-2, 2), between(-2, 2));
      add("G91 G1 X[#5070*0.5] Z0.2\nG90\nG1 X[%.4f*COS[%.4f]] Y[%.4f*SIN[%.4f]]\n", 2 * radius + 4, angle,
          2 * radius + 4, angle);
      if (any(0, 2) == 0) add("G38.2 Z-40\n#<z> = #5063\nG1 Z[#<z>+1]\n");
    }
    add("G0 Z%.4f\nM2\n", radius + 2);
  }
};

}  // namespace leadscrew::testing_support
